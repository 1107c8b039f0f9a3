#pragma once
/// \file
/// Makes a Graph a model of Boost.Graph's VertexListGraph, IncidenceGraph, AdjacencyGraph and EdgeListGraph,
/// so that its algorithms run on it without a copy:
///
/// \code
/// #include "framework/model/BglAdaptor.h"
/// #include <boost/graph/biconnected_components.hpp>
/// std::vector<std::size_t> block(2 * graph.edgeCount());
/// auto blocks = boost::make_iterator_property_map(block.begin(), get(boost::edge_index, graph));
/// std::size_t n = boost::biconnected_components(graph, blocks);
/// \endcode
///
/// `edge_index` gives both directions of an edge the same number, below 2·edgeCount(); it costs O(log
/// degree).

#include "framework/model/Graph.h"

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace mrpp::bgl
{

struct EdgeDescriptor
{
    Vertex source = 0;
    Vertex target = 0;

    friend bool operator==(const EdgeDescriptor &x, const EdgeDescriptor &y)
    {
        return (x.source == y.source && x.target == y.target) ||
               (x.source == y.target && x.target == y.source);
    }
};

class OutEdgeIterator : public boost::iterator_facade<OutEdgeIterator, EdgeDescriptor,
                                                      boost::random_access_traversal_tag, EdgeDescriptor>
{
public:
    OutEdgeIterator() = default;
    OutEdgeIterator(Vertex source, const Vertex *target) : source_(source), target_(target) {}

private:
    friend class boost::iterator_core_access;
    [[nodiscard]] EdgeDescriptor dereference() const { return {source_, *target_}; }
    [[nodiscard]] bool equal(const OutEdgeIterator &other) const { return target_ == other.target_; }
    void increment() { ++target_; }
    void decrement() { --target_; }
    void advance(std::ptrdiff_t n) { target_ += n; }
    [[nodiscard]] std::ptrdiff_t distance_to(const OutEdgeIterator &other) const
    {
        return other.target_ - target_;
    }

    Vertex source_ = 0;
    const Vertex *target_ = nullptr;
};

/// Every edge once, from its smaller end.
class EdgeIterator : public boost::iterator_facade<EdgeIterator, EdgeDescriptor, boost::forward_traversal_tag,
                                                   EdgeDescriptor>
{
public:
    EdgeIterator() = default;
    EdgeIterator(const Graph &graph, Vertex source) : graph_(&graph), source_(source) { skip(); }

private:
    friend class boost::iterator_core_access;
    [[nodiscard]] EdgeDescriptor dereference() const { return {source_, graph_->neighbors(source_)[index_]}; }
    [[nodiscard]] bool equal(const EdgeIterator &other) const
    {
        return source_ == other.source_ && index_ == other.index_;
    }
    void increment()
    {
        ++index_;
        skip();
    }
    void skip()
    {
        for (; source_ < graph_->vertexCount(); ++source_, index_ = 0)
            for (; index_ < graph_->degree(source_); ++index_)
                if (graph_->neighbors(source_)[index_] > source_)
                    return;
    }

    const Graph *graph_ = nullptr;
    Vertex source_ = 0;
    std::size_t index_ = 0;
};

struct Category : boost::incidence_graph_tag,
                  boost::adjacency_graph_tag,
                  boost::vertex_list_graph_tag,
                  boost::edge_list_graph_tag
{};

/// Property map from an edge to its index.
struct EdgeIndexMap
{
    using key_type = EdgeDescriptor;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::readable_property_map_tag;

    const Graph *graph = nullptr;

    friend std::size_t get(const EdgeIndexMap &map, const EdgeDescriptor &edge)
    {
        return *map.graph->arc(std::min(edge.source, edge.target), std::max(edge.source, edge.target));
    }
    std::size_t operator[](const EdgeDescriptor &edge) const { return get(*this, edge); }
};

} // namespace mrpp::bgl

namespace boost
{
template <>
struct graph_traits<mrpp::Graph>
{
    using vertex_descriptor = mrpp::Vertex;
    using edge_descriptor = mrpp::bgl::EdgeDescriptor;
    using directed_category = undirected_tag;
    using edge_parallel_category = disallow_parallel_edge_tag;
    using traversal_category = mrpp::bgl::Category;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = counting_iterator<mrpp::Vertex>;
    using edge_iterator = mrpp::bgl::EdgeIterator;
    using out_edge_iterator = mrpp::bgl::OutEdgeIterator;
    using adjacency_iterator = const mrpp::Vertex *;

    static vertex_descriptor null_vertex() { return mrpp::kNoVertex; }
};

/// Some algorithms (biconnected_components) ask for the traits of `const Graph`.
template <>
struct graph_traits<const mrpp::Graph> : graph_traits<mrpp::Graph>
{};

template <>
struct property_map<mrpp::Graph, vertex_index_t>
{
    using type = typed_identity_property_map<mrpp::Vertex>;
    using const_type = type;
};

template <>
struct property_map<mrpp::Graph, edge_index_t>
{
    using type = mrpp::bgl::EdgeIndexMap;
    using const_type = type;
};
} // namespace boost

namespace mrpp
{
// Boost.Graph finds these through argument-dependent look-up; the names are its own.
inline std::size_t num_vertices(const Graph &g)
{
    return g.vertexCount();
}
inline std::size_t num_edges(const Graph &g)
{
    return g.edgeCount();
}
inline std::pair<boost::counting_iterator<Vertex>, boost::counting_iterator<Vertex>> vertices(const Graph &g)
{
    return {boost::counting_iterator<Vertex>(0),
            boost::counting_iterator<Vertex>(static_cast<Vertex>(g.vertexCount()))};
}
inline std::pair<bgl::EdgeIterator, bgl::EdgeIterator> edges(const Graph &g)
{
    return {bgl::EdgeIterator(g, 0), bgl::EdgeIterator(g, static_cast<Vertex>(g.vertexCount()))};
}
inline Vertex source(const bgl::EdgeDescriptor &e, const Graph &)
{
    return e.source;
}
inline Vertex target(const bgl::EdgeDescriptor &e, const Graph &)
{
    return e.target;
}
inline std::pair<bgl::OutEdgeIterator, bgl::OutEdgeIterator> out_edges(Vertex v, const Graph &g)
{
    const auto around = g.neighbors(v);
    return {bgl::OutEdgeIterator(v, around.data()), bgl::OutEdgeIterator(v, around.data() + around.size())};
}
inline std::size_t out_degree(Vertex v, const Graph &g)
{
    return g.degree(v);
}
inline std::pair<const Vertex *, const Vertex *> adjacent_vertices(Vertex v, const Graph &g)
{
    const auto around = g.neighbors(v);
    return {around.data(), around.data() + around.size()};
}
inline boost::typed_identity_property_map<Vertex> get(boost::vertex_index_t, const Graph &)
{
    return {};
}
inline Vertex get(boost::vertex_index_t, const Graph &, Vertex v)
{
    return v;
}
inline bgl::EdgeIndexMap get(boost::edge_index_t, const Graph &g)
{
    return {&g};
}
} // namespace mrpp
