#pragma once
/// \file
/// A graph as the explorer draws it: where its vertices lie, its edges, and the block of each edge.
///
/// All numbers are variable-length integers (Bytes.h): vertices V; edges E; for each vertex the differences
/// of x and y to the vertex before it (kGraphUnit is the distance of typical neighbours, y grows upwards);
/// for each vertex how many larger neighbours it has, and each of them less the one before it (the first less
/// the vertex); for each edge in that order the difference of its block to that of the edge before it; and
/// how many vertices each block has.

#include "framework/model/Graph.h"

#include <cstdint>
#include <vector>

namespace mrpp
{

inline constexpr double kGraphUnit = 64;

/// Any graph can be placed: by its coordinates; where it has none, by Graphviz, and where it is too large for
/// that, on rings around a vertex. O(V log V + E), Graphviz aside.
[[nodiscard]] std::vector<std::uint8_t> graphBlock(const Graph &graph);

} // namespace mrpp
