#pragma once
/// \file
/// Coordinates for any connected graph: neighbours attract each other as springs do, vertices that are close
/// repel each other, and the graph is laid out coarsely first.
///
/// T. M. J. Fruchterman, E. M. Reingold, "Graph Drawing by Force-directed Placement", Software: Practice and
/// Experience 21(11), 1991 (the forces, the limit on how far a vertex goes in an iteration, the cells); C.
/// Walshaw, "A Multilevel Algorithm for Force-Directed Graph Drawing", JGAA 7(3), 2003 (the levels). Here a
/// coarser level joins stars rather than pairs, so that hubs with many leaves become small as soon as paths
/// do.

#include "framework/model/Graph.h"

#include <vector>

namespace mrpp
{

/// One place a vertex, to a thousandth, no two the same; edges have a mean length of one. Depends on the
/// graph alone, and only on arithmetic that IEEE 754 rounds correctly, so that files are the same on every
/// machine. \pre the graph is connected. O((V + E) log V).
[[nodiscard]] std::vector<Point> forceDrawing(const Graph &graph);

} // namespace mrpp
