#include "framework/analysis/Subgraphs.h"

#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <map>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<Vertex> membersOf(std::size_t set, std::size_t vertices)
{
    std::vector<Vertex> members;
    for (Vertex v = 0; v < vertices; ++v)
        if ((set >> v & 1U) != 0)
            members.push_back(v);
    return members;
}

std::vector<Vertex> range(Vertex first, Vertex last)
{
    std::vector<Vertex> list;
    for (; first <= last; ++first)
        list.push_back(first);
    return list;
}

/// A triangle 0 1 2, a corridor 2–3–4–5 to a star with arms 5–6, 5–7–8, and a corridor 8–9–10–11 onwards to
/// the square 11 12 13 14.
std::shared_ptr<const Graph> chain()
{
    return Graph::fromEdges(15, {{0, 1},
                                 {1, 2},
                                 {2, 0},
                                 {2, 3},
                                 {3, 4},
                                 {4, 5},
                                 {5, 6},
                                 {5, 7},
                                 {7, 8},
                                 {8, 9},
                                 {9, 10},
                                 {10, 11},
                                 {11, 12},
                                 {12, 13},
                                 {13, 14},
                                 {14, 11}});
}

TEST(Subgraphs, AreLinkedByShortCorridors)
{
    const auto graph = chain();
    const Blocks blocks(*graph);
    const auto count = [&](std::size_t free, MotionRule rule)
    { return Subgraphs(*graph, blocks, rule, range(0, static_cast<Vertex>(14 - free))).count(); };
    // 2 to 5 are three edges, 5 to 11 five.
    EXPECT_EQ(count(1, MotionRule::pebble), 0U);
    EXPECT_EQ(count(4, MotionRule::pebble), 3U);
    EXPECT_EQ(count(5, MotionRule::pebble), 2U);
    EXPECT_EQ(count(6, MotionRule::following), 2U);
    EXPECT_EQ(count(7, MotionRule::parallel), 1U);
    EXPECT_EQ(count(0, MotionRule::rotation), 3U);
    EXPECT_EQ(count(3, MotionRule::rotation), 3U);
    EXPECT_EQ(count(4, MotionRule::rotation), 2U);
    EXPECT_EQ(count(5, MotionRule::rotation), 2U);
    EXPECT_EQ(count(6, MotionRule::rotation), 1U);
}

TEST(Subgraphs, HaveVerticesAndPlanks)
{
    const auto graph = chain();
    const Blocks blocks(*graph);
    const Subgraphs subgraphs(*graph, blocks, MotionRule::pebble, range(0, 9));
    ASSERT_EQ(subgraphs.count(), 2U);
    EXPECT_THAT(subgraphs.vertices(0), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(subgraphs.vertices(1), ElementsAre(11, 12, 13, 14));
    EXPECT_EQ(subgraphs.of(4), 0U);
    EXPECT_EQ(subgraphs.of(6), kNoSubgraph);
    ASSERT_EQ(subgraphs.planks(0).size(), 2U);
    const Plank &arm = subgraphs.planks(0)[0];
    EXPECT_EQ(arm.join, 5U);
    EXPECT_EQ(arm.end, 6U);
    EXPECT_EQ(arm.length, 1U);
    EXPECT_EQ(arm.farSubgraph, kNoSubgraph);
    const Plank &corridor = subgraphs.planks(0)[1];
    EXPECT_EQ(corridor.exterior, 7U);
    EXPECT_EQ(corridor.end, 11U);
    EXPECT_EQ(corridor.length, 5U);
    EXPECT_EQ(corridor.farSubgraph, 1U);
    std::vector<Vertex> seen;
    subgraphs.walk(corridor,
                   [&](Vertex v)
                   {
                       seen.push_back(v);
                       return true;
                   });
    EXPECT_THAT(seen, ElementsAre(7, 8, 9, 10, 11));
    ASSERT_EQ(subgraphs.planks(1).size(), 1U);
    EXPECT_EQ(subgraphs.planks(1)[0].subgraph, 1U);
    EXPECT_EQ(subgraphs.planks(1)[0].farSubgraph, 0U);
}

TEST(Subgraphs, CountFreeVerticesInEachComponent)
{
    // Two stars; one has two free vertices, the other one.
    const auto graph = Graph::fromEdges(8, {{0, 1}, {0, 2}, {0, 3}, {4, 5}, {4, 6}, {4, 7}});
    const Blocks blocks(*graph);
    const std::vector<Vertex> occupied = {7, 1, 5, 2, 6};
    const FreeCounts free(blocks, occupied);
    EXPECT_EQ(free.inComponent(2), 2U);
    EXPECT_EQ(free.inComponent(7), 1U);
    EXPECT_EQ(free.beyond(0, 3), 1U);
    EXPECT_EQ(free.beyond(3, 0), 1U);
    EXPECT_EQ(free.beyond(5, 4), 1U);
    const Subgraphs subgraphs(*graph, blocks, MotionRule::pebble, occupied);
    ASSERT_EQ(subgraphs.count(), 1U);
    EXPECT_THAT(subgraphs.vertices(0), ElementsAre(0));
    EXPECT_THAT(subgraphs.assignment(occupied), ElementsAre(kNoSubgraph, 0, kNoSubgraph, 0, kNoSubgraph));
}

TEST(Subgraphs, OfPathsThereAreNone)
{
    const auto graph = Graph::fromEdges(6, {{0, 1}, {1, 2}, {3, 4}});
    const Blocks blocks(*graph);
    const std::vector<Vertex> occupied = {1, 5};
    const Subgraphs subgraphs(*graph, blocks, MotionRule::rotation, occupied);
    EXPECT_EQ(subgraphs.count(), 0U);
    EXPECT_THAT(subgraphs.assignment(occupied), ElementsAre(kNoSubgraph, kNoSubgraph));
    EXPECT_THAT(subgraphs.assignment({}), IsEmpty());
}

/// Two robots have the same subgraph exactly where brute force can bring one to the other's place.
void expectOrbits(const Graph &graph, MotionRule rule, std::size_t &sets)
{
    const std::size_t n = graph.vertexCount();
    const Blocks blocks(graph);
    const std::vector<Vertex> orbits = test::positionOrbits(graph, rule);
    for (std::size_t set = 0; set < std::size_t{1} << n; ++set)
    {
        const std::vector<Vertex> occupied = membersOf(set, n);
        if (rule == MotionRule::pebble && occupied.size() + 2 > n)
            continue;
        const Subgraphs subgraphs(graph, blocks, rule, occupied);
        const std::vector<std::uint32_t> assignment = subgraphs.assignment(occupied);
        std::map<std::uint32_t, Vertex> first;
        for (std::size_t i = 0; i < occupied.size(); ++i)
        {
            const Vertex expected = assignment[i] == kNoSubgraph
                                        ? occupied[i]
                                        : first.emplace(assignment[i], occupied[i]).first->second;
            ASSERT_EQ(orbits[set * n + occupied[i]], expected)
                << toString(rule) << " " << n << " vertices, set " << set << ", vertex " << occupied[i];
        }
        ++sets;
    }
}

TEST(Subgraphs, AssignRobotsAsBruteForceDoesOnAllSmallGraphs)
{
    std::size_t sets = 0;
    for (std::size_t n = 1; n <= 7; ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            ASSERT_NO_FATAL_FAILURE(expectOrbits(*graph, MotionRule::pebble, sets));
            ASSERT_NO_FATAL_FAILURE(expectOrbits(*graph, MotionRule::rotation, sets));
        }
    }
    EXPECT_EQ(sets, 226507U);
}

TEST(Subgraphs, AssignRobotsAsBruteForceDoesOnSparseGraphs)
{
    std::size_t sets = 0;
    for (Seed seed = 0; seed < 60; ++seed)
    {
        const auto graph = test::randomConnectedGraph(7 + seed % 5, seed % 4, seed);
        ASSERT_NO_FATAL_FAILURE(expectOrbits(*graph, MotionRule::pebble, sets));
        ASSERT_NO_FATAL_FAILURE(expectOrbits(*graph, MotionRule::rotation, sets));
    }
    EXPECT_GT(sets, 80000U);
}

TEST(Subgraphs, OfALongCombAreFoundInLinearTime)
{
    // A spine of 100 000 vertices, a tooth at each: all one subgraph with three free vertices.
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < 100000; ++v)
    {
        edges.push_back({v, v + 100000});
        if (v > 0)
            edges.push_back({v - 1, v});
    }
    const auto graph = Graph::fromEdges(200000, edges);
    const Blocks blocks(*graph);
    const std::vector<Vertex> occupied = range(0, 199996);
    const Subgraphs subgraphs(*graph, blocks, MotionRule::pebble, occupied);
    EXPECT_EQ(subgraphs.count(), 1U);
    EXPECT_EQ(subgraphs.planks(0).size(), 100000U);
}

} // namespace
} // namespace mrpp
