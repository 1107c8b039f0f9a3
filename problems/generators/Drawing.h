#pragma once
/// \file
/// Coordinates for graphs that have no natural ones.

#include "framework/model/Graph.h"

#include <span>
#include <vector>

namespace mrpp
{

/// A point in the plane, to a thousandth: what sines and cosines have in their last bits differs from machine
/// to machine, and files should not.
[[nodiscard]] Point drawnPoint(double x, double y);

/// `size` points on a circle around the origin, neighbours one apart, counter-clockwise from the right.
[[nodiscard]] std::vector<Point> circle(std::size_t size);

/// A breadth-first tree drawn in rings around its root: a vertex's ring is its distance from the root, and
/// each subtree has a sector as wide as its leaves. Without crossings where the graph is a tree.
/// \pre the graph is connected and has the root. O(V + E).
[[nodiscard]] std::vector<Point> radialDrawing(const Graph &graph, Vertex root);

/// A vertex in the middle of a longest path of a tree; of a connected graph, of a long shortest path.
/// \pre the graph is connected and not empty. O(V + E).
[[nodiscard]] Vertex middleVertex(const Graph &graph);

/// The graph of these edges, with the radial drawing around its middle. \pre it is connected, not empty
[[nodiscard]] std::shared_ptr<const Graph> drawnGraph(std::size_t vertexCount,
                                                      std::span<const Graph::Edge> edges);

} // namespace mrpp
