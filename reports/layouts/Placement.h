#pragma once
/// \file
/// Where the vertices of a graph lie on paper: at their own coordinates, or where Graphviz puts them.

#include "framework/model/Graph.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace mrpp
{

inline constexpr std::size_t kLargestGraph = 5000;       ///< vertices that Graphviz draws
inline constexpr std::size_t kLargestSpringLayout = 300; ///< vertices that `neato` arranges
inline constexpr std::size_t kLargestForceLayout = 3000; ///< vertices that `sfdp` arranges

/// How large things are drawn: graphs of few vertices with numbers, large ones small and without.
struct DrawingScale
{
    bool numbers = false;
    double spacing = 0;  ///< points between neighbours
    double diameter = 0; ///< points, of a vertex
    double ring = 0;     ///< points, width of a goal's ring
    double route = 0;    ///< points, width of a route
};
[[nodiscard]] DrawingScale drawingScale(std::size_t vertices);

/// Points of 1/72 inch, y upwards, none negative.
struct Placement
{
    std::vector<Point> positions; ///< one a vertex
    double spacing = 0;           ///< typical distance of neighbours
};

struct Extent
{
    double width = 0; ///< points
    double height = 0;
};
/// Of the vertices' centres.
[[nodiscard]] Extent extentOf(const Placement &placement);

/// By the graph's coordinates where it has some that can be used, else by Graphviz.
/// Throws DrawingError where the graph is empty, or too large for Graphviz.
[[nodiscard]] Placement placeGraph(const Graph &graph);

/// From the graph's coordinates, where no two vertices share theirs: scaled so that neighbours lie `spacing`
/// apart (the median; further where vertices would overlap), y turned upwards. Nothing where there are none
/// that can be used. O(V log V + E).
[[nodiscard]] std::optional<Placement> placeByCoordinates(const Graph &graph, double spacing);

/// Arranged by Graphviz, neighbours about `spacing` apart and vertices of that diameter without overlaps.
/// The same graph gets the same places. Throws DrawingError where the graph is too large.
[[nodiscard]] Placement placeByEngine(const Graph &graph, double spacing, double diameter);

} // namespace mrpp
