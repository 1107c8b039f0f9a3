#include "problems/formats/OctileDistances.h"
#include "framework/support/Random.h"
#include "tests/support/CpuClock.h"

#include <cmath>
#include <gtest/gtest.h>
#include <queue>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr bool kMeasure = false;
#else
constexpr bool kMeasure = true;
#endif

GridMap parse(std::string_view text)
{
    return parseMovingAiMap(text, "test.map");
}

/// Obstacles by chance.
GridMap randomMap(std::size_t width, std::size_t height, double obstacles, Seed seed)
{
    Random random(seed);
    std::string text =
        "type octile\nheight " + std::to_string(height) + "\nwidth " + std::to_string(width) + "\nmap\n";
    for (std::size_t y = 0; y < height; ++y)
    {
        for (std::size_t x = 0; x < width; ++x)
            text += random.below(1000) < static_cast<std::uint64_t>(obstacles * 1000) ? '@' : '.';
        text += '\n';
    }
    return parse(text);
}

/// Lengths to all vertices by Dijkstra's algorithm; negative where no path leads.
std::vector<double> lengthsFrom(const GridMap &map, Vertex source)
{
    std::vector<double> best(map.graph->vertexCount(), -1);
    std::priority_queue<std::pair<double, Vertex>> queue; // negative lengths
    queue.emplace(0, source);
    while (!queue.empty())
    {
        const auto [length, v] = queue.top();
        queue.pop();
        if (best[v] >= 0)
            continue;
        best[v] = -length;
        const auto [cellX, cellY] = map.cellOf(v);
        const auto x = static_cast<std::int64_t>(cellX);
        const auto y = static_cast<std::int64_t>(cellY);
        const auto free = [&map](std::int64_t column, std::int64_t row)
        {
            return map.contains(column, row) &&
                   map.passable(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
        };
        for (std::int64_t dy = -1; dy <= 1; ++dy)
            for (std::int64_t dx = -1; dx <= 1; ++dx)
                if ((dx != 0 || dy != 0) && free(x + dx, y + dy) && free(x + dx, y) && free(x, y + dy))
                    queue.emplace(
                        length - std::sqrt(static_cast<double>(dx * dx + dy * dy)),
                        map.vertexAt(static_cast<std::size_t>(x + dx), static_cast<std::size_t>(y + dy)));
    }
    return best;
}

TEST(OctileDistances, CutNoCorners)
{
    const GridMap map = parse("type octile\nheight 3\nwidth 3\nmap\n.@.\n...\n@.@\n");
    OctileDistances distances(map);
    EXPECT_DOUBLE_EQ(distances.distance(map.vertexAt(0, 0), map.vertexAt(1, 1)), 2);
    EXPECT_DOUBLE_EQ(distances.distance(map.vertexAt(0, 0), map.vertexAt(2, 0)), 4);
    EXPECT_DOUBLE_EQ(distances.distance(map.vertexAt(0, 0), map.vertexAt(0, 0)), 0);
    const GridMap open = parse("type octile\nheight 3\nwidth 3\nmap\n...\n...\n..@\n");
    EXPECT_DOUBLE_EQ(OctileDistances(open).distance(open.vertexAt(0, 0), open.vertexAt(2, 1)),
                     1 + std::sqrt(2.0));
    const GridMap split = parse("type octile\nheight 1\nwidth 3\nmap\n.@.\n");
    EXPECT_LT(OctileDistances(split).distance(0, 1), 0);
}

TEST(OctileDistances, AreThoseOfDijkstrasAlgorithmWithAndWithoutLandmarks)
{
    for (Seed seed = 1; seed <= 40; ++seed)
    {
        Random random(seed);
        const GridMap map = randomMap(1 + random.below(40), 1 + random.below(40),
                                      0.05 * static_cast<double>(random.below(9)), seed);
        if (map.graph->vertexCount() == 0)
            continue;
        OctileDistances plain(map);
        OctileDistances guided(map);
        guided.addLandmarks();
        for (int i = 0; i < 5; ++i)
        {
            const auto start = static_cast<Vertex>(random.below(map.graph->vertexCount()));
            const std::vector<double> expected = lengthsFrom(map, start);
            for (Vertex v = 0; v < map.graph->vertexCount(); ++v)
            {
                ASSERT_NEAR(plain.distance(start, v), expected[v], 1e-9) << "seed " << seed;
                ASSERT_NEAR(guided.distance(start, v), expected[v], 1e-9) << "seed " << seed;
            }
        }
        EXPECT_LE(guided.visits(), plain.visits());
    }
}

TEST(OctileDistances, AskWhetherToStopForEachRobot)
{
    const GridMap map = randomMap(20, 20, 0, 1);
    Instance instance{map.graph, {}, {}};
    for (Vertex v = 0; v < 100; ++v)
    {
        instance.starts.push_back(v);
        instance.goals.push_back(399 - v);
    }
    std::size_t told = 0;
    const auto listener = [&told](std::string_view work, std::size_t done, std::size_t total)
    {
        EXPECT_EQ(work, "lengths of paths");
        EXPECT_EQ(done, told++);
        EXPECT_EQ(total, 100U);
    };
    const std::vector<double> lengths =
        octileDistances(map, instance, {TerminationCondition::when([&told] { return told > 60; }), listener});
    EXPECT_GT(lengths[59], 0);
    EXPECT_EQ(lengths[60], 0);
    EXPECT_EQ(told, 61U);
}

TEST(OctileDistances, CostWhatPathsAreLongAndNotWhatMapsAreLarge)
{
    // Ten times as many cells, paths three times as long.
    double small = 0;
    double large = 0;
    for (const auto &[side, visits] : {std::pair<std::size_t, double *>(250, &small), {790, &large}})
    {
        const GridMap map = randomMap(side, side, 0, 1);
        OctileDistances distances(map);
        Random random(3);
        const double start = test::cpuSeconds();
        for (int i = 0; i < 300; ++i)
            (void)distances.distance(static_cast<Vertex>(random.below(map.graph->vertexCount())),
                                     static_cast<Vertex>(random.below(map.graph->vertexCount())));
        *visits = static_cast<double>(distances.visits());
        if (kMeasure)
        {
            EXPECT_LT(test::cpuSeconds() - start, 2); // a search of the whole map each took a minute
        }
    }
    EXPECT_LT(large / small, 4);
}

} // namespace
} // namespace mrpp
