#pragma once
/// \file
/// Random spanning trees of grids, for maps that must stay connected.

#include "framework/model/Graph.h"
#include "framework/support/Random.h"

#include <vector>

namespace mrpp
{

/// The edges of a W×H grid (cells numbered row by row), each cell's right one before its lower one.
[[nodiscard]] std::vector<Graph::Edge> gridEdges(std::size_t width, std::size_t height);

/// Kruskal's algorithm on a random order of the edges: shuffles them, with those of the tree first. Not every
/// tree is equally likely. Returns how many edges the tree has. O(E α(V)).
std::size_t moveSpanningTreeFirst(std::vector<Graph::Edge> &edges, std::size_t vertices, Random &random);

} // namespace mrpp
