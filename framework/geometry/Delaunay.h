#pragma once
/// \file
/// Delaunay triangulation of points in the plane, by CGAL with exact predicates: the same points give the
/// same edges on every machine. In the library mrpp::geometry, which is built with MRPP_WITH_CGAL.

#include "framework/model/Graph.h"

#include <span>
#include <vector>

namespace mrpp
{

/// The edges of a Delaunay triangulation of the points (z is not looked at), each once with a < b, sorted.
/// Straight lines along them do not cross, and they connect all points. \pre no two points in one
/// place. O(V log V) expected.
[[nodiscard]] std::vector<Graph::Edge> delaunayEdges(std::span<const Point> points);

} // namespace mrpp
