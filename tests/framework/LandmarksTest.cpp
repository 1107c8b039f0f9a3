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

} // namespace
} // namespace mrpp
