#include "framework/model/BglAdaptor.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/Components.h"
#include "tests/support/RandomCases.h"

#include <boost/concept/assert.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/visitors.hpp>
#include <gtest/gtest.h>

#include <set>

namespace mrpp
{
namespace
{

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));

/// Sparse random graphs of several components.
std::shared_ptr<const Graph> sparseGraph(Seed seed)
{
    Random random(seed);
    const std::size_t vertices = 1 + random.below(14);
    std::vector<Graph::Edge> edges;
    for (std::size_t i = random.below(18); i > 0; --i)
        edges.push_back(
            {static_cast<Vertex>(random.below(vertices)), static_cast<Vertex>(random.below(vertices))});
    return Graph::fromEdges(vertices, edges);
}

std::shared_ptr<const Graph> without(const Graph &graph, Vertex removed)
{
    std::vector<Graph::Edge> edges;
    for (const Graph::Edge &edge : graph.edges())
        if (edge.a != removed && edge.b != removed)
            edges.push_back(edge);
    return Graph::fromEdges(graph.vertexCount(), edges);
}

TEST(BglAdaptor, WalksOverVerticesAndEdges)
{
    const auto graph = Graph::fromEdges(4, {{2, 1}, {0, 3}, {0, 1}});
    EXPECT_EQ(num_vertices(*graph), 4U);
    EXPECT_EQ(num_edges(*graph), 3U);
    const auto [first, last] = edges(*graph);
    std::vector<std::pair<Vertex, Vertex>> seen;
    for (auto edge = first; edge != last; ++edge)
        seen.emplace_back(source(*edge, *graph), target(*edge, *graph));
    EXPECT_EQ(seen, (std::vector<std::pair<Vertex, Vertex>>{{0, 1}, {0, 3}, {1, 2}}));
    EXPECT_EQ(out_degree(0, *graph), 2U);
}

TEST(BglAdaptor, GivesBothDirectionsOfAnEdgeOneIndex)
{
    const auto graph = Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    const auto index = get(boost::edge_index, *graph);
    std::set<std::size_t> indices;
    for (const Graph::Edge &edge : graph->edges())
    {
        EXPECT_EQ(get(index, bgl::EdgeDescriptor{edge.a, edge.b}),
                  get(index, bgl::EdgeDescriptor{edge.b, edge.a}));
        EXPECT_LT(index[(bgl::EdgeDescriptor{edge.a, edge.b})], 2 * graph->edgeCount());
        indices.insert(index[(bgl::EdgeDescriptor{edge.a, edge.b})]);
    }
    EXPECT_EQ(indices.size(), 4U);
}

TEST(BglAdaptor, ConnectedComponentsAgreeWithOurs)
{
    for (Seed seed = 0; seed < 200; ++seed)
    {
        const auto graph = sparseGraph(seed);
        std::vector<std::uint32_t> component(graph->vertexCount());
        const auto count = boost::connected_components(
            *graph, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, *graph)));
        const Components ours(*graph);
        EXPECT_EQ(static_cast<std::size_t>(count), ours.count());
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
            EXPECT_EQ(component[v], ours.of(v)) << "seed " << seed << ", vertex " << v;
    }
}

TEST(BglAdaptor, BiconnectedComponentsFindTheVerticesWhoseRemovalDisconnects)
{
    for (Seed seed = 0; seed < 200; ++seed)
    {
        const auto graph = sparseGraph(seed);
        std::vector<std::size_t> block(2 * graph->edgeCount() + 1);
        std::vector<Vertex> found;
        boost::biconnected_components(
            *graph, boost::make_iterator_property_map(block.begin(), get(boost::edge_index, *graph)),
            std::back_inserter(found));
        const std::set<Vertex> articulations(found.begin(), found.end());
        const std::size_t whole = Components(*graph).count();
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
        {
            // The removed vertex stays behind as a component of its own.
            const bool cuts = graph->degree(v) > 0 && Components(*without(*graph, v)).count() - 1 > whole;
            EXPECT_EQ(articulations.contains(v), cuts) << "seed " << seed << ", vertex " << v;
        }
    }
}

TEST(BglAdaptor, TwoEdgesAreInOneBlockExactlyWhereNoVertexSeparatesThem)
{
    // Two triangles that share vertex 2, and a bridge 4–5.
    const auto graph = Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}, {4, 5}});
    std::vector<std::size_t> block(2 * graph->edgeCount());
    const auto map = boost::make_iterator_property_map(block.begin(), get(boost::edge_index, *graph));
    EXPECT_EQ(boost::biconnected_components(*graph, map), 3U);
    const auto of = [&](Vertex a, Vertex b) { return get(map, bgl::EdgeDescriptor{a, b}); };
    EXPECT_EQ(of(0, 1), of(2, 0));
    EXPECT_EQ(of(2, 3), of(3, 4));
    EXPECT_NE(of(0, 1), of(2, 3));
    EXPECT_NE(of(4, 5), of(3, 4));
}

TEST(BglAdaptor, BreadthFirstSearchAgreesWithOurs)
{
    for (Seed seed = 0; seed < 200; ++seed)
    {
        const auto graph = sparseGraph(seed);
        std::vector<std::uint32_t> distance(graph->vertexCount(), kUnreachable);
        distance[0] = 0;
        const auto map =
            boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, *graph));
        boost::breadth_first_search(
            *graph, Vertex{0},
            boost::visitor(boost::make_bfs_visitor(boost::record_distances(map, boost::on_tree_edge()))));
        BreadthFirstSearch ours(*graph);
        ours.run(0);
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
            EXPECT_EQ(ours.distance(v), distance[v]) << "seed " << seed << ", vertex " << v;
    }
}

} // namespace
} // namespace mrpp
