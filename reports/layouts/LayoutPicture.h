#pragma once
/// \file
/// Pictures of an instance: its graph, where the robots start, where they have to go and on which edges they
/// went.
///
/// Up to kLargestGraph vertices Graphviz draws them, every vertex and edge an element with an id and a
/// tooltip in the SVG. Beyond that its PDF output takes quadratic time; larger graphs with coordinates become
/// a map of cells, drawn with cairo.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "reports/layouts/Placement.h"
#include "reports/picture/Picture.h"

#include <string>
#include <vector>

namespace mrpp
{

/// Draws an instance; `solution` may be null. The same input gives the same bytes.
/// \param placement of the graph
/// Throws DrawingError where Graphviz fails.
[[nodiscard]] Picture drawInstance(const Instance &instance, const Solution *solution,
                                   const Placement &placement, const std::string &title);

/// For each edge (in the order of Graph::edges()) the robots that used it, in the order of their first use
/// and each once; at most `limit` of them.
[[nodiscard]] std::vector<std::vector<Robot>> edgeUsers(const Graph &graph, const Solution &solution,
                                                        std::size_t limit);

/// Drawn with cairo as cells (where the graph is a grid) or edges.
[[nodiscard]] Picture drawMap(const Instance &instance, const Solution *solution, const Placement &placement,
                              const std::string &title);

} // namespace mrpp
