#pragma once
/// \file
/// Grows a biconnected graph: a cycle first, then one handle (ear) after another.
///
/// A graph is biconnected exactly where it can be grown so: H. Whitney, "Non-separable and planar graphs",
/// Transactions of the AMS 34, 1932. Every handle brings a new vertex, so no edge is ever parallel.

#include "framework/model/Graph.h"
#include "framework/support/Random.h"

#include <vector>

namespace mrpp
{

class HandleGraph
{
public:
    /// A cycle of the vertices 0 … size−1. \pre size ≥ 3
    explicit HandleGraph(std::size_t size);

    /// Joins x and y by a path of `inner` new vertices, numbered from x to y.
    /// \pre x ≠ y, both exist, inner ≥ 1
    void addHandle(Vertex x, Vertex y, std::size_t inner);

    /// The same between two random vertices, as Surynek's generator draws them: both uniformly; where they
    /// are one, the second becomes the vertex before it.
    void addRandomHandle(std::size_t inner, Random &random);

    [[nodiscard]] std::size_t vertexCount() const { return vertexCount_; }
    [[nodiscard]] const std::vector<Graph::Edge> &edges() const { return edges_; }

private:
    std::vector<Graph::Edge> edges_;
    std::size_t vertexCount_;
};

} // namespace mrpp
