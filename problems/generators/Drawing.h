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

/// The graph of these edges, drawn by forces (ForceDrawing.h). \pre it is connected
[[nodiscard]] std::shared_ptr<const Graph> drawnGraph(std::size_t vertexCount,
                                                      std::span<const Graph::Edge> edges);

} // namespace mrpp
