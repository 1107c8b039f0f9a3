#include "framework/analysis/Blocks.h"
#include "framework/store/SolutionCodec.h"
#include "reports/explorer/GraphBlock.h"
#include "reports/explorer/Packing.h"
#include "reports/explorer/PlayableRuns.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/Unpacked.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

std::vector<std::uint8_t> bytesOf(std::string_view text)
{
    return {text.begin(), text.end()};
}

TEST(Packing, IsWhatBrowsersCanRead)
{
    EXPECT_EQ(packedText({}), "eNoDAAAAAAE=");
    EXPECT_EQ(packedText(bytesOf("a")), "eNpLBAAAYgBi");
    EXPECT_EQ(unpacked("eNpLBAAAYgBi"), bytesOf("a"));
}

RC_GTEST_PROP(Packing, IsUndoneByUnpacking, (const std::vector<std::uint8_t> &bytes))
{
    RC_ASSERT(unpacked(packedText(bytes)) == std::optional(bytes));
}

/// The block of a graph is the graph: its edges and their blocks.
void expectRoundTrip(const Graph &graph)
{
    const auto read = unpackGraph(graphBlock(graph));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->places.size(), graph.vertexCount());
    const auto edges = graph.edges();
    const Blocks blocks(graph);
    ASSERT_EQ(read->edges.size(), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        EXPECT_EQ(read->edges[i], std::pair(edges[i].a, edges[i].b));
        EXPECT_EQ(read->blocks[i], blocks.ofEdge(edges[i].a, edges[i].b));
        EXPECT_EQ(read->blockSizes[read->blocks[i]], blocks.vertices(read->blocks[i]).size());
    }
}

TEST(GraphBlock, HoldsEveryEdgeAndItsBlock)
{
    expectRoundTrip(*treeInstance().graph);
    expectRoundTrip(*gridInstance(9, 1).graph);
    expectRoundTrip(*Graph::fromEdges(0, std::initializer_list<std::pair<Vertex, Vertex>>{}));
    expectRoundTrip(*Graph::fromEdges(5, {{0, 4}, {1, 4}, {0, 1}})); // without coordinates, two parts
}

TEST(GraphBlock, PutsTheCellsOfAMapOnWholeUnits)
{
    const auto read = unpackGraph(graphBlock(*gridInstance(40, 1).graph));
    ASSERT_TRUE(read);
    const auto unit = static_cast<std::int64_t>(kGraphUnit);
    for (std::int64_t v = 0; v < 1600; ++v)
        EXPECT_EQ(read->places[static_cast<std::size_t>(v)],
                  std::pair(v % 40 * unit, (39 - v / 40) * unit)); // y grows upwards
}

TEST(GraphBlock, PlacesLargeGraphsWithoutCoordinatesApart)
{
    std::vector<Graph::Edge> edges;
    constexpr Vertex kVertices = 6000; // more than Graphviz is asked to arrange
    for (Vertex v = 1; v < kVertices; ++v)
        edges.push_back({v, (v - 1) / 3});
    const auto read = unpackGraph(graphBlock(*Graph::fromEdges(kVertices + 1, edges)));
    ASSERT_TRUE(read);
    std::vector<std::pair<std::int64_t, std::int64_t>> places = read->places;
    std::sort(places.begin(), places.end());
    const auto distinct = std::unique(places.begin(), places.end()) - places.begin();
    EXPECT_GT(distinct, 5500);
}

TEST(PlayableRuns, KeepsEachGraphAndInstanceOnce)
{
    PlayableRuns runs(1'000'000);
    const Instance tree = treeInstance();
    const Instance again = treeInstance(); // another object, the same graph
    const Solution solution({{0, 1, 0}});
    EXPECT_TRUE(runs.add(0, "tree/0", tree, solution));
    EXPECT_TRUE(runs.add(1, "tree/0", tree, solution, &solution));
    EXPECT_TRUE(runs.add(2, "tree/1", again, solution));
    EXPECT_EQ(runs.graphs().size(), 1U);
    EXPECT_EQ(runs.cases().size(), 2U);
    ASSERT_EQ(runs.runs().size(), 3U);
    EXPECT_EQ(runs.runs()[2].inCase, 1U);
    EXPECT_TRUE(runs.runs()[0].optimized.empty());
    EXPECT_EQ(runs.runs()[1].optimized, runs.runs()[1].solution);
    std::size_t size = 0;
    for (const auto &text : runs.graphs())
        size += text.size();
    for (const auto &one : runs.cases())
        size += one.robotsText.size();
    for (const auto &run : runs.runs())
        size += run.solution.size() + run.optimized.size();
    EXPECT_EQ(runs.size(), size);
}

TEST(PlayableRuns, TakesNothingInThatDoesNotFit)
{
    const Instance tree = treeInstance();
    const Solution solution({{0, 1, 0}, {0, 0, 1}});
    PlayableRuns all(1'000'000);
    ASSERT_TRUE(all.add(0, "tree/0", tree, solution));
    PlayableRuns less(all.size() - 1);
    EXPECT_FALSE(less.add(0, "tree/0", tree, solution));
    EXPECT_EQ(less.size(), 0U);
    EXPECT_TRUE(less.cases().empty());
    PlayableRuns enough(all.size());
    EXPECT_TRUE(enough.add(0, "tree/0", tree, solution));
    EXPECT_FALSE(enough.add(1, "tree/0", tree, solution));
    EXPECT_EQ(enough.size(), all.size());
}

TEST(PlayableRuns, KeepsTheStepsOfASchedule)
{
    Schedule schedule;
    schedule.appendStep(std::vector<Move>{{0, 1, 0}, {1, 4, 3}, {2, 6, 4}});
    schedule.appendStep(std::vector<Move>{{0, 0, 1}});
    PlayableRuns runs(1'000'000);
    ASSERT_TRUE(runs.add(0, "tree/0", treeInstance(), schedule));
    EXPECT_FALSE(runs.runs()[0].isSequential);
    const auto bytes = unpacked(runs.runs()[0].solution);
    ASSERT_TRUE(bytes);
    const auto solution = unpackSolution(*bytes);
    ASSERT_TRUE(solution);
    std::vector<std::size_t> sizes;
    solution->forEachAction([&](std::span<const Move> action) { sizes.push_back(action.size()); });
    EXPECT_EQ(sizes, (std::vector<std::size_t>{3, 1}));
    EXPECT_TRUE(std::equal(solution->moves().begin(), solution->moves().end(), schedule.moves().begin()));
}

} // namespace
} // namespace mrpp
