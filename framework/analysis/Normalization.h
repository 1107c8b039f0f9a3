#pragma once
/// \file
/// Brings robots to given vertices without saying which robot goes where.

#include "framework/analysis/Blocks.h"
#include "framework/model/Graph.h"

#include <span>
#include <vector>

namespace mrpp
{

/// A place in `support` for each robot, such that moves of one robot at a time lead from `starts` to these
/// places. On a connected graph there always is one, even without telling robots apart (Kornhauser, Miller,
/// Spirakis, FOCS 1984); this finds it without the moves.
///
/// Why it is reachable: across an edge of a spanning tree robots flow in one direction only. At each vertex
/// those that come in, its own first and then one stream after another, go out in this order, some to one
/// neighbour, then some to the next, and the last one stays where the vertex is to be occupied. Every vertex
/// waits for one neighbour at a time, to take a robot from it or to give one to it. Follow these waits: they
/// cannot end, and in a tree they come back only where two neighbours wait for each other, which, the edge
/// being used in one direction, is a move that can be made. So some move can be made until all are.
///
/// The order in which streams leave is free: the longest goes last, so that a robot is counted only as one of
/// a lighter part, O(V + E + robots · log robots) in all. \param support as many vertices as there are
/// starts, in each component
[[nodiscard]] std::vector<Vertex> normalize(const Graph &graph, const Blocks &blocks,
                                            std::span<const Vertex> starts, std::span<const Vertex> support);

} // namespace mrpp
