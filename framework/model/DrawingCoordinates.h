#pragma once
/// \file
/// Coordinates for pictures: near ones, far ones and tiny ones alike can be computed with.

#include "framework/model/Graph.h"

#include <vector>

namespace mrpp
{

/// x and y of all vertices; z is 0. Coordinates of ordinary size stay as they are. Where they lie beyond
/// 2^100, or all within 2^-100, they are moved to begin at 0 and scaled by a power of two to an extent of
/// about 1: the differences and squares of such numbers are no numbers any more. y grows as in the graph.
/// O(V). \pre the graph has coordinates, which are finite
[[nodiscard]] std::vector<Point> drawingCoordinates(const Graph &graph);

} // namespace mrpp
