#include "framework/analysis/EarDecomposition.h"

#include "tests/support/BiconnectedGraphs.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace mrpp
{
namespace
{

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

using Growth = EarDecomposition::Growth;

/// Says what is wrong; nothing where it is a decomposition.
std::string defect(const Graph &graph, const EarDecomposition &ears, std::span<const Vertex> cycle)
{
    if (!std::ranges::equal(ears.cycle(), cycle))
        return "another first cycle";
    std::vector<char> there(graph.vertexCount(), 0);
    for (std::size_t i = 0; i < cycle.size(); ++i)
    {
        if (!graph.hasEdge(cycle[i], cycle[(i + 1) % cycle.size()]))
            return "the cycle is none";
        if (there[cycle[i]]++ != 0 || ears.level(cycle[i]) != 0)
            return "a vertex of the cycle is there twice, or on a wrong level";
    }
    for (std::size_t i = 0; i < ears.handleCount(); ++i)
    {
        const auto handle = ears.handle(i);
        if (handle.size() < 3 || handle.front() == handle.back())
            return "a handle without an interior, or a closed one";
        if (there[handle.front()] == 0 || there[handle.back()] == 0)
            return "a handle hangs in the air";
        for (std::size_t j = 0; j + 1 < handle.size(); ++j)
            if (!graph.hasEdge(handle[j], handle[j + 1]))
                return "a handle is no path";
        for (const Vertex v : ears.interior(i))
            if (there[v]++ != 0 || ears.level(v) != i + 1)
                return "a vertex is there twice, or on a wrong level";
    }
    if (std::ranges::find(there, 0) != there.end())
        return "a vertex is missing";
    return {};
}

TEST(EarDecomposition, OfEverySmallBiconnectedGraphIsOne)
{
    std::size_t graphs = 0;
    for (std::size_t vertices = 3; vertices <= 7; ++vertices)
        for (const auto &graph : test::connectedGraphs(vertices))
        {
            if (!test::isBiconnected(*graph))
                continue;
            ++graphs;
            const auto shortest = shortCycle(*graph);
            for (const auto &cycle : test::simpleCycles(*graph))
            {
                ASSERT_LE(shortest.size(), cycle.size());
                for (const Growth growth : {Growth::shortest, Growth::depthFirst})
                    for (const std::optional<Seed> shuffle : {std::optional<Seed>(), std::optional<Seed>(7)})
                        ASSERT_EQ(defect(*graph, EarDecomposition(*graph, cycle, growth, shuffle), cycle),
                                  "");
            }
        }
    EXPECT_EQ(graphs, 1U + 3U + 10U + 56U + 468U);
}

TEST(EarDecomposition, OfLargeRandomGraphsIsOne)
{
    for (Seed seed = 1; seed <= 30; ++seed)
    {
        const auto graph = test::cycleWithHandles(3 + seed % 7, 500, 1 + seed % 12, seed);
        const auto cycle = seed % 2 == 0 ? shortCycle(*graph) : shortestCycleThrough(*graph, 100);
        for (const Growth growth : {Growth::shortest, Growth::depthFirst})
            ASSERT_EQ(defect(*graph, EarDecomposition(*graph, cycle, growth, seed), cycle), "");
    }
}

TEST(EarDecomposition, GrowsByTheShortestHandle)
{
    // A square 0 1 2 3 with a long handle 4 5 6 from 0 to 2, and from its middle a short one, 7, to 1.
    const auto graph =
        Graph::fromEdges(8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 6}, {6, 2}, {5, 7}, {7, 1}});
    const EarDecomposition ears(*graph, std::vector<Vertex>{0, 1, 2, 3});
    ASSERT_EQ(ears.handleCount(), 2U);
    EXPECT_EQ(ears.interior(0).size(), 3U);
    EXPECT_EQ(ears.interior(1).size(), 1U);
    const EarDecomposition others(*graph, std::vector<Vertex>{0, 4, 5, 7, 1});
    EXPECT_EQ(others.interior(0).size(), 2U);
    EXPECT_EQ(others.interior(1).size(), 1U);
}

TEST(EarDecomposition, OfACycleHasNoHandles)
{
    const auto graph = Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}});
    EXPECT_THAT(shortCycle(*graph), UnorderedElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(EarDecomposition(*graph, shortCycle(*graph)).handleCount(), 0U);
}

TEST(EarDecomposition, ShortestCyclesThroughAVertex)
{
    for (std::size_t vertices = 3; vertices <= 6; ++vertices)
        for (const auto &graph : test::connectedGraphs(vertices))
        {
            const auto cycles = test::simpleCycles(*graph);
            for (Vertex v = 0; v < vertices; ++v)
            {
                std::size_t best = 0;
                for (const auto &cycle : cycles)
                    if (std::ranges::find(cycle, v) != cycle.end() && (best == 0 || cycle.size() < best))
                        best = cycle.size();
                const auto found = shortestCycleThrough(*graph, v);
                ASSERT_EQ(found.size(), best);
                for (std::size_t i = 0; i < best; ++i)
                    ASSERT_TRUE(graph->hasEdge(found[i], found[(i + 1) % best]));
                ASSERT_EQ(std::set<Vertex>(found.begin(), found.end()).size(), best);
                if (best > 0)
                {
                    ASSERT_EQ(found.front(), v);
                }
            }
        }
    EXPECT_THAT(shortCycle(*Graph::fromEdges(3, {{0, 1}, {1, 2}})), IsEmpty());
}

TEST(EarDecomposition, OfLargeGraphsTakesLittleTime)
{
    std::vector<std::shared_ptr<const Graph>> graphs = {
        test::gridGraph(320, 320), test::cycleWithHandles(1000, 200, 1000, 1),
        test::cycleWithHandles(3, 60'000, 3, 2), test::cycleWithHandles(50'000, 1, 50'000, 3),
        test::cycleWithHandles(100'000, 1000, 1, 4)};
    for (const auto &graph : graphs)
        for (const Growth growth : {Growth::shortest, Growth::depthFirst})
        {
            const double begin = test::cpuSeconds();
            const auto cycle = shortCycle(*graph);
            const EarDecomposition ears(*graph, cycle, growth);
            const double seconds = test::cpuSeconds() - begin;
            EXPECT_EQ(defect(*graph, ears, cycle), "");
            EXPECT_LT(seconds, 1.0) << graph->vertexCount() << " vertices";
            RecordProperty("ms_" + std::to_string(graph->vertexCount()) +
                               (growth == Growth::shortest ? "_shortest" : "_depthFirst"),
                           static_cast<int>(seconds * 1000));
        }
}

} // namespace
} // namespace mrpp
