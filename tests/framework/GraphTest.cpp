#include "framework/model/Graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Graph, DefaultIsEmpty)
{
    const Graph graph;
    EXPECT_EQ(graph.vertexCount(), 0U);
    EXPECT_EQ(graph.edgeCount(), 0U);
    EXPECT_THAT(graph.edges(), IsEmpty());
}

TEST(Graph, ListsNeighborsAscendingWhateverTheOrderOfEdges)
{
    const auto graph = Graph::fromEdges(5, {{3, 1}, {1, 0}, {4, 1}, {2, 1}});
    EXPECT_THAT(graph->neighbors(1), ElementsAre(0, 2, 3, 4));
    EXPECT_THAT(graph->neighbors(3), ElementsAre(1));
    EXPECT_EQ(graph->degree(1), 4U);
    EXPECT_EQ(graph->edgeCount(), 4U);
}

TEST(Graph, KeepsVerticesWithoutEdges)
{
    const auto graph = Graph::fromEdges(3, {});
    EXPECT_EQ(graph->vertexCount(), 3U);
    EXPECT_THAT(graph->neighbors(2), IsEmpty());
}

TEST(Graph, DropsLoops)
{
    const auto graph = Graph::fromEdges(2, {{0, 0}, {0, 1}, {1, 1}});
    EXPECT_EQ(graph->edgeCount(), 1U);
    EXPECT_THAT(graph->neighbors(0), ElementsAre(1));
}

TEST(Graph, OfParallelEdgesTheFirstIsKept)
{
    const std::vector<Graph::Edge> edges = {{1, 0, 2.5}, {0, 1, 7}, {1, 0, 9}};
    const auto graph = Graph::fromEdges(2, edges);
    EXPECT_EQ(graph->edgeCount(), 1U);
    EXPECT_EQ(graph->weight(0, 1), 2.5);
    EXPECT_EQ(graph->weight(1, 0), 2.5);
}

TEST(Graph, WithoutOtherWeightsIsNotWeighted)
{
    const std::vector<Graph::Edge> plain = {{0, 1}, {1, 2}};
    EXPECT_FALSE(Graph::fromEdges(3, plain)->isWeighted());
    EXPECT_EQ(Graph::fromEdges(3, plain)->weight(1, 2), 1);
    const std::vector<Graph::Edge> weighted = {{0, 1}, {1, 2, 0.5}};
    EXPECT_TRUE(Graph::fromEdges(3, weighted)->isWeighted());
    EXPECT_EQ(Graph::fromEdges(3, weighted)->weight(0, 1), 1);
}

TEST(Graph, NumbersArcsBySourceThenTarget)
{
    const auto graph = Graph::fromEdges(3, {{0, 1}, {1, 2}});
    EXPECT_EQ(graph->arc(0, 1), 0U);
    EXPECT_EQ(graph->arc(1, 0), 1U);
    EXPECT_EQ(graph->arc(1, 2), 2U);
    EXPECT_EQ(graph->arc(2, 1), 3U);
    EXPECT_EQ(graph->arc(0, 2), std::nullopt);
    EXPECT_EQ(graph->arc(7, 0), std::nullopt);
    EXPECT_FALSE(graph->hasEdge(0, 7));
    EXPECT_FALSE(graph->hasEdge(1, 1));
}

TEST(Graph, ListsEveryEdgeOnceInOrder)
{
    const std::vector<Graph::Edge> given = {{2, 1, 3}, {3, 0}, {1, 0}};
    const auto edges = Graph::fromEdges(4, given)->edges();
    ASSERT_EQ(edges.size(), 3U);
    EXPECT_EQ(edges[0].a, 0U);
    EXPECT_EQ(edges[0].b, 1U);
    EXPECT_EQ(edges[1].b, 3U);
    EXPECT_EQ(edges[2].a, 1U);
    EXPECT_EQ(edges[2].b, 2U);
    EXPECT_EQ(edges[2].weight, 3);
}

TEST(Graph, KeepsCoordinatesAndTheirAxis)
{
    const std::vector<Graph::Edge> edges = {{0, 1}};
    const auto graph = Graph::fromEdges(2, edges, {{1, 2, 3}, {4, 5, 6}}, YAxis::down);
    ASSERT_TRUE(graph->hasCoordinates());
    EXPECT_EQ(graph->coordinate(1), (Point{4, 5, 6}));
    EXPECT_EQ(graph->yAxis(), YAxis::down);
    EXPECT_FALSE(Graph::fromEdges(2, edges)->hasCoordinates());
}

// The literals were computed outside this program: SHA-256 of the documented bytes.
TEST(Graph, FingerprintIsTheSameOnEveryMachine)
{
    EXPECT_EQ(Graph().fingerprint(), "21fc3f955c14305ed66b2f6064de082e");
    EXPECT_EQ(Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}})->fingerprint(),
              "18c9a106642ff66be4115b219499857e");
    const std::vector<Graph::Edge> weighted = {{0, 1}, {1, 2, 2.5}, {2, 3}};
    EXPECT_EQ(Graph::fromEdges(4, weighted)->fingerprint(), "5019c95fffe635f7a0a891add49af5e5");
}

TEST(Graph, FingerprintForgetsOrderAndCoordinatesButNoEdge)
{
    const std::vector<Graph::Edge> edges = {{0, 1}, {1, 2}};
    const std::vector<Graph::Edge> turned = {{2, 1}, {1, 0}};
    const std::string print = Graph::fromEdges(3, edges)->fingerprint();
    EXPECT_EQ(Graph::fromEdges(3, turned, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})->fingerprint(), print);
    EXPECT_NE(Graph::fromEdges(4, edges)->fingerprint(), print);
    EXPECT_NE(Graph::fromEdges(3, {{0, 1}, {0, 2}})->fingerprint(), print);
}

} // namespace
} // namespace mrpp
