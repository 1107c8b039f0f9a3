#include "framework/analysis/Blocks.h"

#include "framework/analysis/Components.h"
#include "framework/model/BglAdaptor.h"
#include "framework/support/Random.h"

#include <boost/graph/biconnected_components.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A triangle 0 1 2 and a square 2 3 4 5 that share vertex 2; a bridge 4–6; apart from it 7–8, and 9 alone.
std::shared_ptr<const Graph> example()
{
    return Graph::fromEdges(10, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 2}, {4, 6}, {7, 8}});
}

std::shared_ptr<const Graph> randomGraph(Random &random)
{
    const std::size_t vertices = 1 + random.below(16);
    std::vector<Graph::Edge> edges;
    for (std::size_t i = random.below(24); i > 0; --i)
        edges.push_back(
            {static_cast<Vertex>(random.below(vertices)), static_cast<Vertex>(random.below(vertices))});
    return Graph::fromEdges(vertices, edges);
}

TEST(Blocks, KnowTheirVerticesAndEdges)
{
    const Blocks blocks(*example());
    ASSERT_EQ(blocks.count(), 4U);
    const std::uint32_t triangle = blocks.ofEdge(1, 2);
    const std::uint32_t square = blocks.ofEdge(5, 2);
    const std::uint32_t bridge = blocks.ofEdge(6, 4);
    EXPECT_THAT(blocks.vertices(triangle), ElementsAre(0, 1, 2));
    EXPECT_THAT(blocks.vertices(square), ElementsAre(2, 3, 4, 5));
    EXPECT_THAT(blocks.vertices(bridge), ElementsAre(4, 6));
    EXPECT_THAT(blocks.edges(bridge), ElementsAre(Blocks::Edge{4, 6}));
    EXPECT_EQ(blocks.edges(square).size(), 4U);
    EXPECT_TRUE(blocks.isCycle(triangle));
    EXPECT_FALSE(blocks.isBipartite(triangle));
    EXPECT_TRUE(blocks.isCycle(square));
    EXPECT_TRUE(blocks.isBipartite(square));
    EXPECT_TRUE(blocks.isEdge(bridge));
    EXPECT_FALSE(blocks.isCycle(bridge));
    EXPECT_TRUE(blocks.isBipartite(bridge));
    EXPECT_TRUE(blocks.isBridge(8, 7));
    EXPECT_FALSE(blocks.isBridge(3, 4));
}

TEST(Blocks, KnowTheBlocksOfAVertex)
{
    const Blocks blocks(*example());
    EXPECT_EQ(blocks.of(2).size(), 2U);
    EXPECT_EQ(blocks.of(3).size(), 1U);
    EXPECT_THAT(blocks.of(9), IsEmpty());
    EXPECT_TRUE(blocks.isCutVertex(2));
    EXPECT_TRUE(blocks.isCutVertex(4));
    EXPECT_FALSE(blocks.isCutVertex(0));
    EXPECT_FALSE(blocks.isCutVertex(7));
}

TEST(Blocks, JoinedWithoutBridgesAreOneTwoEdgeComponent)
{
    const Blocks blocks(*example());
    EXPECT_EQ(blocks.twoEdgeCount(), 5U);
    EXPECT_EQ(blocks.twoEdgeOf(0), blocks.twoEdgeOf(5));
    EXPECT_EQ(blocks.twoEdgeSize(blocks.twoEdgeOf(0)), 6U);
    EXPECT_NE(blocks.twoEdgeOf(6), blocks.twoEdgeOf(4));
    EXPECT_TRUE(blocks.inTwoEdgeComponent(4));
    EXPECT_FALSE(blocks.inTwoEdgeComponent(6));
    EXPECT_FALSE(blocks.inTwoEdgeComponent(9));
    EXPECT_EQ(blocks.twoEdgeOf(9), 4U);
}

TEST(Blocks, OfAnEmptyGraphThereAreNone)
{
    const Blocks blocks(*Graph::fromEdges(0, {}));
    EXPECT_EQ(blocks.count(), 0U);
    EXPECT_EQ(blocks.twoEdgeCount(), 0U);
}

TEST(Blocks, AreThoseOfBoost)
{
    Random random(4);
    for (int round = 0; round < 3000; ++round)
    {
        const auto graph = randomGraph(random);
        const Blocks blocks(*graph);
        std::vector<std::size_t> theirs(2 * graph->edgeCount());
        const auto map = boost::make_iterator_property_map(theirs.begin(), get(boost::edge_index, *graph));
        std::vector<Vertex> cuts;
        const auto result = boost::biconnected_components(*graph, map, std::back_inserter(cuts));
        ASSERT_EQ(blocks.count(), result.first);
        std::map<std::size_t, std::uint32_t> renamed;
        std::vector<std::set<Vertex>> vertices(blocks.count());
        for (const Graph::Edge &edge : graph->edges())
        {
            const std::uint32_t block = blocks.ofEdge(edge.a, edge.b);
            const auto theirBlock = get(map, bgl::EdgeDescriptor{edge.a, edge.b});
            ASSERT_EQ(renamed.emplace(theirBlock, block).first->second, block);
            vertices[block].insert({edge.a, edge.b});
        }
        ASSERT_EQ(renamed.size(), blocks.count());
        std::size_t edgesOfBlocks = 0;
        for (std::uint32_t block = 0; block < blocks.count(); ++block)
        {
            EXPECT_TRUE(std::ranges::equal(blocks.vertices(block), vertices[block]));
            EXPECT_TRUE(vertices[block].contains(blocks.top(block)));
            edgesOfBlocks += blocks.edges(block).size();
            for (const Blocks::Edge &edge : blocks.edges(block))
            {
                ASSERT_TRUE(graph->hasEdge(edge.a, edge.b));
                ASSERT_EQ(blocks.ofEdge(edge.b, edge.a), block);
            }
        }
        EXPECT_EQ(edgesOfBlocks, graph->edgeCount());
        const std::set<Vertex> cutSet(cuts.begin(), cuts.end());
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
            EXPECT_EQ(blocks.isCutVertex(v), cutSet.contains(v));
    }
}

/// The graph without one of its edges.
std::shared_ptr<const Graph> without(const Graph &graph, const Graph::Edge &removed)
{
    std::vector<Graph::Edge> edges = graph.edges();
    std::erase_if(edges, [&](const Graph::Edge &e) { return e.a == removed.a && e.b == removed.b; });
    return Graph::fromEdges(graph.vertexCount(), edges);
}

TEST(Blocks, BridgesAreTheEdgesWhoseRemovalSeparates)
{
    Random random(5);
    for (int round = 0; round < 500; ++round)
    {
        const auto graph = randomGraph(random);
        const Blocks blocks(*graph);
        const std::size_t components = Components(*graph).count();
        std::vector<Graph::Edge> others;
        for (const Graph::Edge &edge : graph->edges())
        {
            const bool separates = Components(*without(*graph, edge)).count() > components;
            ASSERT_EQ(blocks.isBridge(edge.a, edge.b), separates);
            if (!separates)
                others.push_back(edge);
        }
        const Components remaining(*Graph::fromEdges(graph->vertexCount(), others));
        ASSERT_EQ(blocks.twoEdgeCount(), remaining.count());
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
        {
            EXPECT_EQ(blocks.twoEdgeOf(v), remaining.of(v));
            EXPECT_EQ(blocks.twoEdgeSize(blocks.twoEdgeOf(v)), remaining.size(remaining.of(v)));
        }
    }
}

TEST(Blocks, AreBipartiteWhereTheyCanBeColouredWithTwoColours)
{
    Random random(6);
    for (int round = 0; round < 500; ++round)
    {
        const auto graph = randomGraph(random);
        const Blocks blocks(*graph);
        for (std::uint32_t block = 0; block < blocks.count(); ++block)
        {
            const auto vertices = blocks.vertices(block);
            bool colourable = false;
            for (std::uint32_t colours = 0; colours < (1U << vertices.size()) && !colourable; ++colours)
            {
                const auto colour = [&](Vertex v)
                { return colours >> (std::ranges::lower_bound(vertices, v) - vertices.begin()) & 1U; };
                colourable = std::ranges::all_of(blocks.edges(block), [&](const Blocks::Edge &edge)
                                                 { return colour(edge.a) != colour(edge.b); });
            }
            ASSERT_EQ(blocks.isBipartite(block), colourable);
        }
    }
}

TEST(Blocks, SubtreesAreRangesOfThePreorder)
{
    Random random(7);
    for (int round = 0; round < 500; ++round)
    {
        const auto graph = randomGraph(random);
        const Blocks blocks(*graph);
        const Components components(*graph);
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
        {
            ASSERT_EQ(blocks.preorder()[blocks.position(v)], v);
            ASSERT_EQ(components.vertices(components.of(v)).front(), blocks.root(v));
            for (Vertex w = 0; w < graph->vertexCount(); ++w)
            {
                Vertex up = w;
                while (up != v && up != kNoVertex)
                    up = blocks.parent(up);
                const std::size_t offset = blocks.position(w) - blocks.position(v);
                ASSERT_EQ(up == v, offset < blocks.subtreeSize(v));
            }
        }
    }
}

TEST(Blocks, OfALongPathAreFoundWithoutRecursion)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v + 1 < 500000; ++v)
        edges.push_back({v, v + 1});
    const Blocks blocks(*Graph::fromEdges(500000, edges));
    EXPECT_EQ(blocks.count(), 499999U);
    EXPECT_EQ(blocks.twoEdgeCount(), 500000U);
}

} // namespace
} // namespace mrpp
