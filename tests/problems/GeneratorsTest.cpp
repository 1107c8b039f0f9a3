/// What each generator promises, over many seeds.

#include "framework/support/Error.h"
#include "problems/generators/Biconnected.h"
#include "problems/generators/CycleLeaves.h"
#include "problems/generators/Grid.h"
#include "problems/generators/Isthmus.h"
#include "problems/generators/Maze.h"
#include "problems/generators/RandomGraph.h"
#include "problems/generators/Rooms.h"
#include "problems/generators/Tree.h"
#include "problems/generators/Warehouse.h"
#include "tests/problems/Generated.h"
#include "tests/support/CpuClock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace mrpp::test
{
namespace
{

using ::testing::HasSubstr;

std::string print(const Graph &graph)
{
    std::string text;
    for (const Graph::Edge &edge : graph.edges())
        text += std::to_string(edge.a) + "-" + std::to_string(edge.b) + " ";
    return text;
}

/// No two vertices in one place.
bool drawsApart(const Graph &graph)
{
    std::set<std::pair<double, double>> places;
    for (const Point &point : graph.coordinates())
        places.emplace(point.x, point.y);
    return graph.hasCoordinates() && places.size() == graph.vertexCount();
}

double distance(const Graph &graph, Vertex a, Vertex b)
{
    return std::hypot(graph.coordinate(a).x - graph.coordinate(b).x,
                      graph.coordinate(a).y - graph.coordinate(b).y);
}

TEST(Drawing, HasRoomForEveryVertex)
{
    const auto generator =
        make<Biconnected>({{"initial_cycle", "8"}, {"handles", "8"}, {"max_handle_length", "8"}});
    for (Seed seed = 0; seed < 200; ++seed)
    {
        const auto graph = generator->makeGraph(seed);
        double sum = 0;
        for (const Graph::Edge &edge : graph->edges())
            sum += distance(*graph, edge.a, edge.b);
        ASSERT_NEAR(sum / static_cast<double>(graph->edgeCount()), 1, 0.01) << "seed " << seed;
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
            for (Vertex u = 0; u < v; ++u)
                ASSERT_GT(distance(*graph, u, v), 0.25) << "seed " << seed << ", " << u << " " << v;
    }
}

TEST(Drawing, IsTheSameOnEveryMachine)
{
    const auto graph = make<Biconnected>({})->makeGraph(1);
    std::string text;
    for (const Point &point : graph->coordinates())
        text += formatNumber(point.x) + "," + formatNumber(point.y) + " ";
    EXPECT_EQ(text, "0.177,1.227 -0.332,0.091 0.645,-0.588 0.927,0.076 -0.242,0.732 1.094,-1.13 1.659,-0.493 "
                    "-1.195,0.531 1.101,1.184 ");
}

TEST(BiconnectedGenerator, IsBiconnectedForTenThousandSeeds)
{
    const auto fixed = make<Biconnected>(
        {{"initial_cycle", "5"}, {"handles", "4"}, {"max_handle_length", "3"}, {"handle", "fixed"}});
    const auto uniform = make<Biconnected>(
        {{"initial_cycle", "5"}, {"handles", "4"}, {"max_handle_length", "3"}, {"handle", "uniform"}});
    std::map<std::size_t, std::size_t> sizes;
    std::set<std::string> different;
    for (Seed seed = 0; seed < 10'000; ++seed)
    {
        const auto graph = fixed->makeGraph(seed);
        ASSERT_EQ(graph->vertexCount(), 9U);
        ASSERT_EQ(graph->edgeCount(), 13U);
        ASSERT_TRUE(isBiconnected(*graph)) << "seed " << seed << ": " << print(*graph);
        ASSERT_TRUE(drawsApart(*graph)) << "seed " << seed;
        different.insert(graph->fingerprint());

        const auto other = uniform->makeGraph(seed);
        ASSERT_GE(other->vertexCount(), 9U);
        ASSERT_LE(other->vertexCount(), 17U);
        ASSERT_EQ(other->edgeCount(), other->vertexCount() + 4);
        ASSERT_TRUE(isBiconnected(*other)) << "seed " << seed << ": " << print(*other);
        ++sizes[other->vertexCount()];
    }
    EXPECT_EQ(sizes.size(), 9U) << "lengths from 1 to 3 are drawn";
    EXPECT_GT(sizes[13], sizes[9]);
    EXPECT_GT(different.size(), 1000U);
}

TEST(BiconnectedGenerator, MakesTheSameGraphOnEveryMachine)
{
    const auto fixed =
        make<Biconnected>({{"initial_cycle", "5"}, {"handles", "4"}, {"max_handle_length", "3"}});
    EXPECT_EQ(print(*fixed->makeGraph(1)), "0-1 0-4 0-8 1-2 1-7 2-3 2-5 2-6 3-4 3-5 3-6 3-8 4-7 ");
    EXPECT_EQ(fixed->makeGraph(2)->fingerprint(), "ef297ff9fc2d93a5392eab392927c618");
    const auto uniform = make<Biconnected>(
        {{"initial_cycle", "20"}, {"handles", "30"}, {"max_handle_length", "7"}, {"handle", "uniform"}});
    EXPECT_EQ(uniform->makeGraph(3)->fingerprint(), "d051cb3a5dc1d8109bee1985f1807b3b");
}

TEST(BiconnectedGenerator, HasThePapersSizes)
{
    for (const std::int64_t x : {4, 8, 52, 100})
    {
        const std::string text = std::to_string(x);
        const auto graph =
            make<Biconnected>({{"initial_cycle", text}, {"handles", text}, {"max_handle_length", text}})
                ->makeGraph(1);
        EXPECT_EQ(graph->vertexCount(), static_cast<std::size_t>(x + x * (x / 2)));
        EXPECT_EQ(graph->edgeCount(), graph->vertexCount() + static_cast<std::size_t>(x));
    }
    EXPECT_EQ(make<Biconnected>({{"initial_cycle", "7"}, {"handles", "0"}})->makeGraph(1)->edgeCount(), 7U);
    EXPECT_EQ(make<Biconnected>({})->name(), "biconnected 5-4-3");
    EXPECT_TRUE(drawsApart(*make<Biconnected>({})->makeGraph(1)));
    EXPECT_THAT(complaint("biconnected", {{"handles", "1000000"}, {"max_handle_length", "999999"}}),
                HasSubstr("plan.yaml:4:5: a graph of 1000000000005 vertices or edges"));
    EXPECT_THAT(complaint("biconnected", {{"initial_cycle", "2"}}), HasSubstr("plan.yaml:4:20"));
}

TEST(RandomGenerator, IsConnectedWithExactlyTheEdges)
{
    for (const auto &[vertices, edges] : std::vector<std::pair<int, int>>{
             {1, 0}, {2, 1}, {6, 5}, {6, 9}, {6, 15}, {30, 29}, {30, 60}, {30, 430}})
        for (Seed seed = 0; seed < 300; ++seed)
        {
            const auto graph =
                make<RandomGraph>({{"vertices", std::to_string(vertices)}, {"edges", std::to_string(edges)}})
                    ->makeGraph(seed);
            ASSERT_EQ(graph->vertexCount(), static_cast<std::size_t>(vertices));
            ASSERT_EQ(graph->edgeCount(), static_cast<std::size_t>(edges == 0 ? vertices - 1 : edges));
            ASSERT_TRUE(isConnected(*graph)) << "seed " << seed << ": " << print(*graph);
        }
    EXPECT_EQ(make<RandomGraph>({{"vertices", "12"}, {"edges", "17"}})->makeGraph(5)->fingerprint(),
              "5ff00c7a56f08e4f3f61e42aeab8799a");
}

TEST(RandomGenerator, TakesAMeanDegree)
{
    const auto edges = [](const char *vertices, const char *degree) {
        return make<RandomGraph>({{"vertices", vertices}, {"mean_degree", degree}})
            ->makeGraph(3)
            ->edgeCount();
    };
    EXPECT_EQ(edges("100", "3"), 150U);
    EXPECT_EQ(edges("101", "2.5"), 126U);
    EXPECT_EQ(edges("100", "1"), 99U) << "what connects it";
    EXPECT_EQ(edges("5", "40"), 10U) << "the complete graph";
    EXPECT_THAT(complaint("random", {{"vertices", "10"}, {"edges", "8"}}),
                HasSubstr("a connected graph of 10 vertices has 9 to 45 edges, not 8"));
    EXPECT_THAT(complaint("random", {{"vertices", "10"}, {"edges", "46"}}), HasSubstr("plan.yaml:4:5"));
}

/// χ² of equally likely outcomes.
double chiSquared(const std::map<std::string, int> &counts, int outcomes)
{
    int total = 0;
    for (const auto &[text, count] : counts)
        total += count;
    const double expected = static_cast<double>(total) / outcomes;
    double sum = (outcomes - static_cast<double>(counts.size())) * expected;
    for (const auto &[text, count] : counts)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

TEST(TreeGenerator, IsATree)
{
    for (const char *shape : {"uniform", "recursive"})
        for (Seed seed = 0; seed < 500; ++seed)
        {
            const auto graph =
                make<Tree>({{"vertices", std::to_string(1 + seed % 60)}, {"shape", shape}})->makeGraph(seed);
            ASSERT_EQ(graph->vertexCount(), 1 + seed % 60);
            ASSERT_EQ(graph->edgeCount(), seed % 60);
            ASSERT_TRUE(isConnected(*graph)) << shape << " " << seed << ": " << print(*graph);
            ASSERT_TRUE(drawsApart(*graph)) << shape << " " << seed;
        }
    EXPECT_EQ(make<Tree>({{"vertices", "20"}})->makeGraph(1)->fingerprint(),
              "e467ba86c62a9a14c3e1fdd45abdc13b");
}

TEST(TreeGenerator, MakesEveryLabelledTreeEquallyOften)
{
    std::map<std::string, int> counts;
    const auto tree = make<Tree>({{"vertices", "5"}});
    for (Seed seed = 0; seed < 25'000; ++seed)
        ++counts[print(*tree->makeGraph(seed))];
    EXPECT_EQ(counts.size(), 125U) << "Cayley: n^(n-2)";
    EXPECT_LT(chiSquared(counts, 125), 186) << "124 degrees of freedom, p = 0.0002";
}

TEST(IsthmusGenerator, HasExactlyTheSizeAndTheIsthmus)
{
    for (Seed seed = 0; seed < 1500; ++seed)
    {
        const std::size_t longest = 2 + seed % 30 * 2; // objective 7: up to 60 of 100
        const auto graph = make<Isthmus>({{"vertices", "100"}, {"longest_isthmus", std::to_string(longest)}})
                               ->makeGraph(seed);
        ASSERT_EQ(graph->vertexCount(), 100U);
        ASSERT_TRUE(isConnected(*graph));
        ASSERT_EQ(longestIsthmus(*graph), longest) << "seed " << seed << ": " << print(*graph);
        const auto cyclic = onCycle(*graph);
        for (Vertex v = 0; v < 100; ++v)
            ASSERT_TRUE(cyclic[v] || graph->degree(v) == 2) << "seed " << seed << ": " << print(*graph);
    }
    EXPECT_EQ(make<Isthmus>({{"vertices", "20"}, {"longest_isthmus", "4"}})->makeGraph(1)->fingerprint(),
              "33d3e4c10ad96bb467ff26d1c7673718");
}

TEST(IsthmusGenerator, TakesSeveralBlocks)
{
    for (Seed seed = 0; seed < 500; ++seed)
    {
        const auto graph = make<Isthmus>({{"vertices", std::to_string(30 + seed % 50)},
                                          {"longest_isthmus", "7"},
                                          {"blocks", "6"},
                                          {"max_handle_length", "1"}})
                               ->makeGraph(seed);
        ASSERT_EQ(graph->vertexCount(), 30 + seed % 50);
        ASSERT_TRUE(isConnected(*graph));
        ASSERT_EQ(longestIsthmus(*graph), 7U) << "seed " << seed << ": " << print(*graph);
    }
    EXPECT_THAT(
        complaint("isthmus", {{"vertices", "20"}, {"longest_isthmus", "16"}}),
        HasSubstr("plan.yaml:4:5: 2 blocks and an isthmus of 16 edges need 21 vertices or more, not 20"));
    EXPECT_EQ(complaint("isthmus", {{"vertices", "21"}, {"longest_isthmus", "16"}}), "nothing is wrong");
}

TEST(CycleLeavesGenerator, HasCyclesBySizeNumberAndBridge)
{
    EXPECT_EQ(print(*make<CycleLeaves>({{"cycle_size", "3"}, {"bridge_length", "2"}})->makeGraph(1)),
              "0-1 0-2 0-6 1-2 3-4 3-5 3-6 4-5 ");
    for (const std::size_t cycles : {2U, 3U, 5U})
        for (const std::size_t size : {3U, 4U, 9U})
            for (const std::size_t length : {1U, 2U, 6U})
            {
                const auto graph = make<CycleLeaves>({{"cycle_size", std::to_string(size)},
                                                      {"bridge_length", std::to_string(length)},
                                                      {"cycles", std::to_string(cycles)}})
                                       ->makeGraph(1);
                const std::size_t inner = cycles == 2 ? length - 1 : cycles * (length - 1) + 1;
                EXPECT_EQ(graph->vertexCount(), cycles * size + inner);
                EXPECT_EQ(graph->edgeCount(), graph->vertexCount() - 1 + cycles);
                EXPECT_TRUE(isConnected(*graph));
                EXPECT_TRUE(drawsApart(*graph)) << cycles << " " << size << " " << length;
                EXPECT_EQ(longestIsthmus(*graph), length);
                const auto cyclic = onCycle(*graph);
                EXPECT_EQ(std::count(cyclic.begin(), cyclic.end(), true),
                          static_cast<std::ptrdiff_t>(cycles * size));
            }
}

TEST(GridGenerator, IsTheWholeGridRowByRow)
{
    const auto graph = make<Grid>({{"width", "7"}, {"height", "4"}})->makeGraph(1);
    EXPECT_EQ(graph->vertexCount(), 28U);
    EXPECT_EQ(graph->edgeCount(), 6U * 4 + 7U * 3);
    EXPECT_EQ(graph->yAxis(), YAxis::down);
    for (Vertex v = 0; v < 28; ++v)
    {
        EXPECT_EQ(graph->coordinate(v), (Point{static_cast<double>(v % 7), static_cast<double>(v / 7), 0}));
        EXPECT_EQ(graph->hasEdge(v, v + 1), v % 7 != 6);
        EXPECT_EQ(graph->hasEdge(v, v + 7), v < 21);
    }
    EXPECT_EQ(make<Grid>({{"side", "10"}})->makeGraph(1)->edgeCount(), 180U);
    EXPECT_EQ(make<Grid>({{"side", "1"}})->makeGraph(1)->vertexCount(), 1U);
    EXPECT_EQ(make<Grid>({{"side", "8"}})->name(), "grid 8×8");
    EXPECT_THAT(complaint("grid", {{"side", "3"}, {"width", "4"}}),
                HasSubstr("plan.yaml:4:5: a grid has either a side, or width and height"));
    EXPECT_THAT(complaint("grid", {{"width", "4"}}), HasSubstr("width and height go together"));
}

TEST(GridGenerator, HasItsShareOfObstaclesAndStaysConnected)
{
    for (const auto &[share, free] :
         std::map<std::string, std::size_t>{{"0.1", 270}, {"0.333", 201}, {"0.5", 150}, {"0.95", 15}})
        for (Seed seed = 0; seed < 200; ++seed)
        {
            const auto graph =
                make<Grid>({{"width", "20"}, {"height", "15"}, {"obstacles", share}})->makeGraph(seed);
            ASSERT_EQ(graph->vertexCount(), free);
            ASSERT_TRUE(isConnected(*graph)) << share << ", seed " << seed;
        }
    EXPECT_EQ(make<Grid>({{"side", "9"}, {"obstacles", "0.2"}})->makeGraph(1)->fingerprint(),
              "e41fa0def8d5f9b9a8c91be79a647080");
}

/// Which cells are free.
std::set<std::pair<int, int>> cellsOf(const Graph &graph)
{
    std::set<std::pair<int, int>> cells;
    for (const Point &point : graph.coordinates())
        cells.emplace(static_cast<int>(point.x), static_cast<int>(point.y));
    return cells;
}

TEST(MazeGenerator, HasOneWayBetweenAnyTwoSquares)
{
    for (Seed seed = 0; seed < 300; ++seed)
    {
        const auto thin = make<Maze>({{"width", "21"}, {"height", "15"}})->makeGraph(seed);
        ASSERT_EQ(thin->vertexCount(), 2U * 11 * 8 - 1);
        ASSERT_EQ(thin->edgeCount(), thin->vertexCount() - 1);
        ASSERT_TRUE(isConnected(*thin));

        // 32 cells: 10 corridors of 2 and one of 2 with a wall after each but the last.
        const auto wide = make<Maze>({{"width", "32"}, {"height", "32"}, {"corridor", "2"}})->makeGraph(seed);
        ASSERT_TRUE(isConnected(*wide));
        ASSERT_EQ(wide->vertexCount(), 121U * 4 + 120U * 2);
        for (Vertex v = 0; v < wide->vertexCount(); ++v)
            ASSERT_GE(wide->degree(v), 2U) << "no corridor is narrower than 2";
    }
    EXPECT_EQ(make<Maze>({{"width", "16"}, {"height", "16"}})->makeGraph(1)->fingerprint(),
              "88dc5c51ff2246ce6f449b34a49fa116");
}

TEST(MazeGenerator, FillsTheMap)
{
    for (const int width : {1, 2, 3, 6, 7, 13, 14})
        for (const int height : {1, 2, 5, 9, 12})
        {
            const auto graph =
                make<Maze>(
                    {{"width", std::to_string(width)}, {"height", std::to_string(height)}, {"corridor", "3"}})
                    ->makeGraph(1);
            const auto cells = cellsOf(*graph);
            EXPECT_TRUE(isConnected(*graph)) << width << " " << height;
            EXPECT_TRUE(cells.contains({0, 0}) && cells.contains({width - 1, height - 1}))
                << width << " " << height;
        }
}

TEST(RoomsGenerator, ConnectsAllRoomsByDoors)
{
    // 3 x 2 rooms of 7 x 7, 5 doors in their spanning tree and 2 walls besides.
    for (Seed seed = 0; seed < 300; ++seed)
    {
        const auto vertices = [seed](const char *doors)
        {
            const auto graph =
                make<Rooms>({{"width", "23"}, {"height", "15"}, {"room", "7"}, {"doors", doors}})
                    ->makeGraph(seed);
            EXPECT_TRUE(isConnected(*graph)) << doors << ", seed " << seed;
            return graph->vertexCount();
        };
        ASSERT_EQ(vertices("0"), 6U * 49 + 5);
        ASSERT_EQ(vertices("1"), 6U * 49 + 7);
        ASSERT_GE(vertices("0.5"), 6U * 49 + 5);
    }
    EXPECT_EQ(make<Rooms>({{"width", "30"}, {"height", "20"}})->makeGraph(1)->fingerprint(),
              "55abf10113524eaa1985849659f77fe3");
}

TEST(WarehouseGenerator, HasTheBenchmarksSizes)
{
    const auto expectSize = [](const Settings &settings, std::size_t vertices, std::size_t edges)
    {
        const auto graph = make<Warehouse>(settings)->makeGraph(1);
        EXPECT_EQ(graph->vertexCount(), vertices);
        EXPECT_EQ(graph->edgeCount(), edges);
        EXPECT_TRUE(isConnected(*graph));
    };
    expectSize({}, 5699, 8778);
    expectSize({{"columns", "20"}, {"rows", "40"}, {"margin", "50"}}, 22599, 35158);
    expectSize({{"columns", "20"}, {"rows", "40"}, {"margin", "50"}, {"aisle", "2"}}, 38756, 67412);
    EXPECT_EQ(make<Warehouse>({})->name(), "warehouse 10-20-10-2-1");
}

TEST(Generators, RefuseRobotsThatDoNotFit)
{
    const auto checked = [](const Settings &settings) -> std::string
    {
        try
        {
            make<Grid>(settings)->check();
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "nothing is wrong";
    };
    EXPECT_EQ(checked({{"side", "3"}, {"robots", "9"}}), "nothing is wrong");
    EXPECT_THAT(checked({{"side", "3"}, {"robots", "10"}}), HasSubstr("does not fit a graph of 9 vertices"));
    EXPECT_THAT(checked({{"side", "3"}, {"free", "10"}}), HasSubstr("does not fit a graph of 9 vertices"));
    EXPECT_EQ(checked({{"side", "3"}, {"occupancy", "1"}}), "nothing is wrong");
}

TEST(Generators, MakeAMillionVerticesInSeconds)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
    GTEST_SKIP() << "takes minutes without optimization";
#endif
    const auto expectFast = [](const Problem &problem, std::size_t vertices)
    {
        const double before = cpuSeconds();
        const auto graph = problem.makeGraph(1);
        EXPECT_EQ(graph->vertexCount(), vertices) << problem.name();
        EXPECT_LT(cpuSeconds() - before, 30) << problem.name();
    };
    expectFast(*make<Grid>({{"side", "1000"}}), 1'000'000);
    expectFast(*make<Grid>({{"side", "1000"}, {"obstacles", "0.2"}}), 800'000);
    expectFast(
        *make<Biconnected>({{"initial_cycle", "1000"}, {"handles", "333000"}, {"max_handle_length", "6"}}),
        1'000'000);
    expectFast(*make<RandomGraph>({{"vertices", "1000000"}, {"mean_degree", "4"}}), 1'000'000);
}

} // namespace
} // namespace mrpp::test
