#include "algorithms/search/PathFinder.h"

#include "framework/support/Random.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>
#include <optional>

namespace mrpp
{
namespace
{

/// Cheapest costs by repeated relaxation.
std::optional<std::uint64_t> cheapest(const Graph &graph, Vertex from, Vertex to,
                                      const std::vector<PathFinder::Cost> &prices)
{
    constexpr auto kFar = static_cast<std::uint64_t>(-1);
    std::vector<std::uint64_t> costs(graph.vertexCount(), kFar);
    costs[from] = 0;
    for (bool changed = true; changed;)
    {
        changed = false;
        for (Vertex v = 0; v < graph.vertexCount(); ++v)
            for (const Vertex w : graph.neighbors(v))
                if (costs[v] != kFar && prices[w] != PathFinder::kImpassable &&
                    costs[v] + prices[w] < costs[w])
                {
                    costs[w] = costs[v] + prices[w];
                    changed = true;
                }
    }
    return costs[to] == kFar ? std::nullopt : std::optional(costs[to]);
}

TEST(PathFinder, FindsCheapestPathsAmongPricesAndWalls)
{
    Random random(7);
    for (Seed seed = 1; seed <= 60; ++seed)
    {
        const auto graph = test::randomConnectedGraph(4 + seed, seed / 2, seed);
        const Landmarks landmarks(*graph);
        PathFinder finder(*graph, landmarks);
        std::vector<PathFinder::Cost> prices(graph->vertexCount());
        for (auto &price : prices)
        {
            const auto kind = random.below(4);
            price = kind == 0   ? PathFinder::kMaxEnterCost
                    : kind == 1 ? PathFinder::kImpassable
                                : PathFinder::kStep + static_cast<PathFinder::Cost>(kind == 2);
        }
        for (int query = 0; query < 20; ++query)
        {
            const auto from = static_cast<Vertex>(random.below(graph->vertexCount()));
            const auto to = static_cast<Vertex>(random.below(graph->vertexCount()));
            const auto &path = finder.find(from, to, [&](Vertex v) { return prices[v]; });
            const auto expected = cheapest(*graph, from, to, prices);
            ASSERT_EQ(path.empty(), !expected.has_value());
            if (path.empty())
                continue;
            EXPECT_EQ(path.front(), from);
            EXPECT_EQ(path.back(), to);
            std::uint64_t cost = 0;
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                ASSERT_TRUE(graph->hasEdge(path[i - 1], path[i]));
                cost += prices[path[i]];
            }
            EXPECT_EQ(cost, *expected);
        }
    }
}

std::uint64_t costOf(const std::vector<Vertex> &path, const std::vector<PathFinder::Cost> &prices)
{
    std::uint64_t cost = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        cost += prices[path[i]];
    return cost;
}

std::vector<PathFinder::Cost> randomPrices(std::size_t vertices, Random &random)
{
    std::vector<PathFinder::Cost> prices(vertices);
    for (auto &price : prices)
        price =
            random.below(4) > 0 ? PathFinder::kStep : static_cast<PathFinder::Cost>(4 + random.below(117));
    return prices;
}

/// Grids, trees and sparse graphs side by side, and isolated vertices.
std::shared_ptr<const Graph> severalComponents(Seed seed)
{
    std::vector<Graph::Edge> edges;
    Vertex vertices = 2;
    for (const auto &part :
         {test::gridGraph(30, 20), test::randomConnectedGraph(60, 0, seed),
          test::randomConnectedGraph(400, 100, seed), test::randomConnectedGraph(2, 0, seed)})
    {
        for (const Graph::Edge &edge : part->edges())
            edges.push_back({edge.a + vertices, edge.b + vertices});
        vertices += static_cast<Vertex>(part->vertexCount()) + 1;
    }
    return Graph::fromEdges(vertices, edges);
}

TEST(PathFinder, KeepsThePromiseOfEveryWeightAndVisitsNothingTwice)
{
    Random random(11);
    for (Seed seed = 1; seed <= 6; ++seed)
    {
        const auto graph = severalComponents(seed);
        const Landmarks landmarks(*graph);
        const auto prices = randomPrices(graph->vertexCount(), random);
        for (const double weight : {0.0, 1.0, 1.25, 1.5, 2.0})
        {
            PathFinder finder(*graph, landmarks);
            if (weight > 0)
                finder.fixWeight(weight);
            for (int query = 0; query < 12; ++query)
            {
                const auto from = static_cast<Vertex>(random.below(graph->vertexCount()));
                const auto to = static_cast<Vertex>(random.below(graph->vertexCount()));
                const auto &path = finder.find(from, to, [&](Vertex v) { return prices[v]; });
                const auto expected = cheapest(*graph, from, to, prices);
                ASSERT_EQ(path.empty(), !expected.has_value());
                EXPECT_LE(finder.visits(), graph->vertexCount());
                if (weight > 0)
                {
                    EXPECT_EQ(finder.weight(), weight);
                }
                EXPECT_LE(finder.weight(), PathFinder::kMostWeight);
                if (expected)
                {
                    EXPECT_LE(static_cast<double>(costOf(path, prices)),
                              finder.weight() * static_cast<double>(*expected));
                }
            }
        }
    }
}

/// No search is any the worse for those before it.
TEST(PathFinder, LearnsItsWeightAnewInEverySearch)
{
    const auto graph = test::gridGraph(200, 200);
    const Landmarks landmarks(*graph);
    PathFinder finder(*graph, landmarks);
    Random random(5);
    const auto prices = randomPrices(graph->vertexCount(), random);
    const auto last = static_cast<Vertex>(graph->vertexCount() - 1);
    for (int i = 0; i < 100; ++i)
    {
        (void)finder.find(0, last, [&](Vertex v) { return prices[v]; });
        EXPECT_GT(finder.weight(), 1);
        EXPECT_LT(finder.weight(), PathFinder::kMostWeight);
    }
    const auto &path = finder.find(0, last, [](Vertex) { return PathFinder::kStep; });
    EXPECT_EQ(path.size(), 399U);
    EXPECT_EQ(finder.weight(), 1);
}

/// Where every fifth vertex is dear, the bounds promise too much, and A* alone would look at an area.
TEST(PathFinder, StaysNearThePathOnLargeGraphs)
{
    constexpr std::size_t kSide = 300;
    const auto graph = test::gridGraph(kSide, kSide);
    const Landmarks landmarks(*graph);
    PathFinder finder(*graph, landmarks);
    Random random(3);
    std::vector<PathFinder::Cost> prices(graph->vertexCount());
    for (auto &price : prices)
        price = PathFinder::kStep * (random.below(5) == 0 ? 2 : 1);
    std::size_t asked = 0;
    std::size_t steps = 0;
    std::uint64_t cost = 0;
    std::uint64_t least = 0;
    for (int query = 0; query < 100; ++query)
    {
        const auto from = static_cast<Vertex>(random.below(kSide));
        const auto to = static_cast<Vertex>(graph->vertexCount() - 1 - random.below(kSide));
        const auto &path = finder.find(from, to,
                                       [&](Vertex v)
                                       {
                                           ++asked;
                                           return prices[v];
                                       });
        ASSERT_EQ(path.front(), from);
        ASSERT_EQ(path.back(), to);
        steps += path.size();
        for (std::size_t i = 1; i < path.size(); ++i)
            cost += prices[path[i]];
        least += PathFinder::kStep * landmarks.lowerBound(from, to);
    }
    EXPECT_LT(asked, 100 * steps);
    EXPECT_LT(cost, least + least / 10);
}

} // namespace
} // namespace mrpp
