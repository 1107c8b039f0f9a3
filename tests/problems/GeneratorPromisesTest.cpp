/// What each random generator promises, for ten thousand seeds, judged by Boost.Graph (biconnected: see
/// GeneratorsTest.cpp, roadmaps: see RoadmapTest.cpp). Those that are not
/// random are tried in many sizes.

#include "framework/Catalog.h"
#include "problems/Problems.h"
#include "problems/generators/CycleLeaves.h"
#include "problems/generators/Generator.h"
#include "problems/generators/Warehouse.h"
#include "tests/problems/Generated.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mrpp::test
{
namespace
{

struct Promise
{
    const char *name;
    const char *family;
    Settings settings;
    bool (*holds)(const Graph &graph);
};

bool hasSize(const Graph &graph, std::size_t vertices, std::size_t edges)
{
    return graph.vertexCount() == vertices && graph.edgeCount() == edges;
}

/// Every vertex of degree 3 or more lies on a cycle.
bool branchesOnCyclesOnly(const Graph &graph)
{
    const std::vector<bool> cyclic = onCycle(graph);
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        if (!cyclic[v] && graph.degree(v) != 2)
            return false;
    return true;
}

const std::vector<Promise> &promises()
{
    static const std::vector<Promise> kPromises = {
        {"random",
         "random",
         {{"vertices", "12"}, {"edges", "17"}},
         [](const Graph &g) { return hasSize(g, 12, 17) && isConnected(g); }},
        {"sparse_random",
         "random",
         {{"vertices", "12"}, {"mean_degree", "2"}},
         [](const Graph &g) { return hasSize(g, 12, 12) && isConnected(g); }},
        {"uniform_tree",
         "tree",
         {{"vertices", "12"}},
         [](const Graph &g) { return hasSize(g, 12, 11) && isConnected(g); }},
        {"recursive_tree",
         "tree",
         {{"vertices", "12"}, {"shape", "recursive"}},
         [](const Graph &g) { return hasSize(g, 12, 11) && isConnected(g); }},
        {"isthmus",
         "isthmus",
         {{"vertices", "12"}, {"longest_isthmus", "4"}},
         [](const Graph &g) {
             return g.vertexCount() == 12 && isConnected(g) && longestIsthmus(g) == 4 &&
                    branchesOnCyclesOnly(g);
         }},
        {"isthmus_of_three_blocks",
         "isthmus",
         {{"vertices", "15"}, {"longest_isthmus", "3"}, {"blocks", "3"}, {"max_handle_length", "1"}},
         [](const Graph &g) {
             return g.vertexCount() == 15 && isConnected(g) && longestIsthmus(g) == 3 &&
                    branchesOnCyclesOnly(g);
         }},
        {"grid_with_obstacles",
         "grid",
         {{"width", "6"}, {"height", "5"}, {"obstacles", "0.4"}},
         [](const Graph &g) { return g.vertexCount() == 18 && isConnected(g) && isPlanar(g); }},
        {"maze",
         "maze",
         {{"width", "9"}, {"height", "7"}},
         [](const Graph &g) { return hasSize(g, 39, 38) && isConnected(g); }},
        {"wide_maze",
         "maze",
         {{"width", "8"}, {"height", "8"}, {"corridor", "2"}},
         [](const Graph &g) { return g.vertexCount() == 9 * 4 + 8 * 2 && isConnected(g); }},
        {"rooms",
         "rooms",
         {{"width", "11"}, {"height", "7"}, {"room", "3"}},
         // 3 x 2 rooms, which 5 of their 7 walls connect
         [](const Graph &g) { return g.vertexCount() >= 59 && g.vertexCount() <= 61 && isConnected(g); }},
    };
    return kPromises;
}

class Promises : public ::testing::TestWithParam<Promise>
{};

TEST_P(Promises, AreKeptForTenThousandSeeds)
{
    Catalog catalog;
    registerProblems(catalog);
    const auto generator = makeGenerator(catalog, GetParam().family);
    generator->configure(config(GetParam().settings), {.catalog = &catalog});
    for (Seed seed = 0; seed < 10'000; ++seed)
    {
        const auto graph = generator->makeGraph(seed);
        ASSERT_TRUE(GetParam().holds(*graph)) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Generators, Promises, ::testing::ValuesIn(promises()),
                         [](const auto &promise) { return std::string(promise.param.name); });

TEST(FixedPromises, OfCycleLeavesAreKeptInAllSizes)
{
    for (std::size_t cycles = 2; cycles <= 6; ++cycles)
        for (std::size_t size = 3; size <= 9; ++size)
            for (std::size_t length = 1; length <= 9; ++length)
            {
                const auto graph = make<CycleLeaves>({{"cycle_size", std::to_string(size)},
                                                      {"bridge_length", std::to_string(length)},
                                                      {"cycles", std::to_string(cycles)}})
                                       ->makeGraph(1);
                const auto cyclic = onCycle(*graph);
                const std::size_t edges = graph->vertexCount() - 1 + cycles;
                EXPECT_TRUE(isConnected(*graph) && graph->edgeCount() == edges);
                EXPECT_EQ(longestIsthmus(*graph), length);
                EXPECT_EQ(static_cast<std::size_t>(std::count(cyclic.begin(), cyclic.end(), true)),
                          cycles * size);
            }
}

TEST(FixedPromises, OfWarehousesAreKeptInAllSizes)
{
    for (int number = 0; number < 4096; ++number)
    {
        const auto digit = [number](int place) { return std::to_string(1 + (number >> (2 * place)) % 4); };
        const auto graph = make<Warehouse>({{"columns", digit(0)},
                                            {"rows", digit(1)},
                                            {"shelf_length", digit(2)},
                                            {"shelf_width", digit(3)},
                                            {"aisle", digit(4)},
                                            {"margin", digit(5)}})
                               ->makeGraph(1);
        ASSERT_TRUE(isConnected(*graph)) << number;
    }
}

} // namespace
} // namespace mrpp::test
