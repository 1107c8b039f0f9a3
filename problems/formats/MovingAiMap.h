#pragma once
/// \file
/// Grid maps of the Moving AI Lab's pathfinding benchmarks (`.map`).
///
/// \code
/// type octile
/// height 3
/// width 4
/// map
/// ....
/// .@@.
/// ....
/// \endcode
///
/// Every passable cell is a vertex, numbered row by row; cells that share a side are neighbours (the `octile`
/// of the header speaks of diagonal moves, which MAPF does not make). Format and convention: N. R.
/// Sturtevant, "Benchmarks for Grid-Based Pathfinding", IEEE TCIAIG 4(2), 2012.

#include "framework/model/Graph.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

/// Which symbols robots may stand on. Programs disagree, so it is a choice.
struct Passability
{
    std::string_view name;
    std::string_view passable;
    std::string_view blocked; ///< a symbol in neither list is an error
};

/// `movingai`: . G S are passable, @ O T W are not (the default).
/// `lorr`: the League of Robot Runners' emitters E and service points S too.
/// `strict_dot`: nothing but the dot.
/// `all_but_at_t`: everything but @ and T.
[[nodiscard]] std::span<const Passability> passabilities();

/// Their names, separated by commas: the range of a parameter.
[[nodiscard]] std::string passabilityNames();

/// Throws InputError for an unknown name, with the nearest known one.
[[nodiscard]] const Passability &passability(std::string_view name = "movingai");

/// A grid of cells and the graph of its passable ones.
struct GridMap
{
    std::size_t width = 0;
    std::size_t height = 0;
    std::string cells;                  ///< the symbols row by row; size = width · height
    std::shared_ptr<const Graph> graph; ///< coordinates (column, row), y grows downwards
    std::vector<Vertex> vertices;       ///< a cell's vertex or kNoVertex; size = width · height

    [[nodiscard]] bool contains(std::int64_t x, std::int64_t y) const
    {
        return x >= 0 && y >= 0 && static_cast<std::size_t>(x) < width &&
               static_cast<std::size_t>(y) < height;
    }
    /// The vertex in column x of row y, kNoVertex for an obstacle. \pre the cell exists
    [[nodiscard]] Vertex vertexAt(std::size_t x, std::size_t y) const { return vertices[y * width + x]; }
    [[nodiscard]] bool passable(std::size_t x, std::size_t y) const { return vertexAt(x, y) != kNoVertex; }
    /// The cell of a vertex: column and row. \pre the graph is this map's
    [[nodiscard]] std::pair<std::size_t, std::size_t> cellOf(Vertex v) const
    {
        return {static_cast<std::size_t>(graph->coordinate(v).x),
                static_cast<std::size_t>(graph->coordinate(v).y)};
    }
};

/// Reads a map. Throws ParseError at the place of the first rule that is broken: a header line that is
/// missing, given twice or no number, rows that are too short, too long, too few or too many, an unknown
/// symbol. O(cells).
[[nodiscard]] GridMap readMovingAiMap(const std::filesystem::path &file,
                                      const Passability &rule = passability());
/// \param file the name for messages
[[nodiscard]] GridMap parseMovingAiMap(std::string_view text, const std::string &file,
                                       const Passability &rule = passability());

/// The map of given symbols: numbers the passable cells and joins those that share a side. O(cells).
/// \param yAxis of the graph
/// \pre cells.size() == width · height
[[nodiscard]] GridMap makeGridMap(std::size_t width, std::size_t height, std::string cells,
                                  const Passability &rule = passability(), YAxis yAxis = YAxis::down);

/// The map of a graph whose vertices lie on whole coordinates from 0 on and whose edges join exactly the
/// neighbouring cells; the vertices keep their numbers only where they are numbered row by row. Throws
/// InputError for any other graph. O(cells).
[[nodiscard]] GridMap gridMapOf(const Graph &graph);

/// The same; nothing for any other graph.
[[nodiscard]] std::optional<GridMap> gridMapIfOne(const Graph &graph);

[[nodiscard]] std::string formatMovingAiMap(const GridMap &map);

} // namespace mrpp
