#include "framework/analysis/Landmarks.h"

#include "framework/support/Random.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace mrpp
{
namespace
{

std::vector<std::uint32_t> distancesFrom(const Graph &graph, Vertex root)
{
    constexpr auto kFar = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> distances(graph.vertexCount(), kFar);
    std::vector<Vertex> queue = {root};
    distances[root] = 0;
    for (std::size_t head = 0; head < queue.size(); ++head)
        for (const Vertex w : graph.neighbors(queue[head]))
            if (distances[w] == kFar)
            {
                distances[w] = distances[queue[head]] + 1;
                queue.push_back(w);
            }
    return distances;
}

TEST(Landmarks, NeverOverestimateADistance)
{
    for (Seed seed = 1; seed <= 30; ++seed)
    {
        const auto graph = test::randomConnectedGraph(5 + 3 * seed, seed, seed);
        const Landmarks landmarks(*graph);
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
        {
            const auto distances = distancesFrom(*graph, v);
            for (Vertex w = 0; w < graph->vertexCount(); ++w)
                EXPECT_LE(landmarks.lowerBound(v, w), distances[w]);
        }
    }
}

TEST(Landmarks, StayTrueOnAPathLongerThanTheirNumbers)
{
    constexpr Vertex kLength = 200'000;
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v + 1 < kLength; ++v)
        edges.push_back({v, v + 1});
    const Landmarks landmarks(*Graph::fromEdges(kLength, edges));
    for (const auto &[a, b] : std::initializer_list<std::pair<Vertex, Vertex>>{
             {0, 1}, {0, 199'999}, {100'000, 100'007}, {65'534, 65'537}, {150'000, 199'999}})
        EXPECT_LE(landmarks.lowerBound(a, b), b - a);
    EXPECT_EQ(landmarks.lowerBound(10, 30), 20U);
}

TEST(Landmarks, ServeAnEmptyGraphAndSeveralComponents)
{
    const Landmarks none(*Graph::fromEdges(0, std::initializer_list<std::pair<Vertex, Vertex>>{}));
    const auto two = Graph::fromEdges(5, {{0, 1}, {2, 3}, {3, 4}});
    const Landmarks landmarks(*two);
    EXPECT_EQ(landmarks.lowerBound(2, 4), 2U);
    EXPECT_LE(landmarks.lowerBound(0, 1), 1U);
}

/// A grid and whatever comes after it.
std::shared_ptr<const Graph> gridAnd(std::size_t isolated, const Graph *other)
{
    const auto grid = test::gridGraph(20, 15);
    std::vector<Graph::Edge> edges = grid->edges();
    const auto first = static_cast<Vertex>(grid->vertexCount() + isolated);
    if (other != nullptr)
        for (const Graph::Edge &edge : other->edges())
            edges.push_back({edge.a + first, edge.b + first});
    return Graph::fromEdges(first + (other == nullptr ? 0 : other->vertexCount()), edges);
}

TEST(Landmarks, OfAComponentDoNotDependOnTheRestOfTheGraph)
{
    const Landmarks alone(*gridAnd(0, nullptr));
    const auto tree = test::randomConnectedGraph(500, 0, 1);
    const Landmarks inCompany(*gridAnd(15, tree.get()));
    for (Vertex v = 0; v < 300; ++v)
        for (Vertex t = 0; t < 300; ++t)
            ASSERT_EQ(alone.lowerBound(v, t), inCompany.lowerBound(v, t));
    const Landmarks ofTree(*tree);
    for (Vertex v = 0; v < 500; ++v)
        ASSERT_EQ(ofTree.lowerBound(v, 7), inCompany.lowerBound(v + 315, 7 + 315));
    ASSERT_EQ(inCompany.centers().size(), 17U);
    EXPECT_EQ(inCompany.centers()[0], alone.centers()[0]);
    EXPECT_EQ(inCompany.centers()[16], ofTree.centers()[0] + 315);
}

TEST(Landmarks, SeeTheMiddleOfEachComponent)
{
    // A cross of arms of two, an isolated vertex, a path of three.
    const auto graph = Graph::fromEdges(
        13, {{0, 1}, {1, 4}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {4, 7}, {7, 8}, {10, 11}, {11, 12}});
    const Landmarks landmarks(*graph);
    ASSERT_EQ(landmarks.centers().size(), 3U);
    EXPECT_EQ(landmarks.centers()[0], 4U);
    EXPECT_EQ(landmarks.centers()[1], 9U);
    EXPECT_EQ(landmarks.centers()[2], 11U);
}

TEST(Landmarks, KnowDistancesOfSmallComponentsExactly)
{
    const auto graph = test::randomConnectedGraph(16, 5, 3);
    const Landmarks landmarks(*graph);
    for (Vertex v = 0; v < 16; ++v)
    {
        const auto distances = distancesFrom(*graph, v);
        for (Vertex w = 0; w < 16; ++w)
            EXPECT_EQ(landmarks.lowerBound(v, w), distances[w]);
    }
}

TEST(Landmarks, AreFewerWhereTimeIsOver)
{
    const auto graph = test::gridGraph(10, 10);
    const Landmarks none(*graph, TerminationCondition::when([] { return true; }));
    EXPECT_EQ(none.lowerBound(0, 99), 0U);
    EXPECT_EQ(none.centers().size(), 1U);
}

} // namespace
} // namespace mrpp
