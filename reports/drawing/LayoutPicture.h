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
#include "reports/drawing/Picture.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

inline constexpr std::size_t kLargestGraph = 5000;       ///< vertices that Graphviz draws
inline constexpr std::size_t kLargestSpringLayout = 300; ///< vertices that `neato` arranges
inline constexpr std::size_t kLargestForceLayout = 3000; ///< vertices that `sfdp` arranges

/// Where vertices lie on paper: points of 1/72 inch, y upwards.
struct Placement
{
    std::vector<Point> positions; ///< one a vertex
    double spacing = 0;           ///< typical distance of neighbours
};

/// From the graph's coordinates, where no two vertices share theirs: scaled so that neighbours lie `spacing`
/// apart (the median; further where vertices would overlap), y turned upwards. Nothing where there are none
/// that can be used. O(V log V + E).
[[nodiscard]] std::optional<Placement> placeByCoordinates(const Graph &graph, double spacing);

/// Arranged by Graphviz, neighbours about `spacing` apart and vertices of that diameter without overlaps.
/// The same graph gets the same places. Throws DrawingError where the graph is too large.
[[nodiscard]] Placement placeByEngine(const Graph &graph, double spacing, double diameter);

/// Draws an instance; `solution` may be null. The same input gives the same bytes.
/// Throws DrawingError where the graph is too large or Graphviz fails.
[[nodiscard]] Picture drawInstance(const Instance &instance, const Solution *solution,
                                   const std::string &title);

/// For each edge (in the order of Graph::edges()) the robots that used it, in the order of their first use
/// and each once; at most `limit` of them.
[[nodiscard]] std::vector<std::vector<Robot>> edgeUsers(const Graph &graph, const Solution &solution,
                                                        std::size_t limit);

/// Drawn with cairo as cells (where the graph is a grid) or edges. \pre the graph has a placement
[[nodiscard]] Picture drawMap(const Instance &instance, const Solution *solution, const Placement &placement,
                              const std::string &title);

} // namespace mrpp
