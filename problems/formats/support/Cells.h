#pragma once
/// \file
/// The cells, columns and rows, on which a graph's vertices lie: what file formats for grids need. Internal
/// to the readers and writers of this folder.

#include "framework/model/Instance.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

class Cells
{
public:
    /// Throws InputError where the graph has no coordinates, they are not whole numbers from 0 on, or two
    /// vertices share a cell. O(V log V), O(V) where the vertices are ordered by row and column.
    explicit Cells(const Graph &graph);

    /// The vertex in column x of row y; kNoVertex where there is none. O(log V).
    [[nodiscard]] Vertex vertexAt(std::int64_t x, std::int64_t y) const;

    /// Column and row of a vertex.
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> cellOf(Vertex v) const { return cells_[v]; }

    /// One more than the largest column and row.
    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }

private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cells_;
    std::vector<std::pair<std::uint64_t, Vertex>> order_; ///< (row, column) as one number, ascending
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
};

/// "(x, y)".
[[nodiscard]] std::string cellName(std::int64_t x, std::int64_t y);

/// Puts robots onto a graph one by one, and refuses what is no well-formed instance at its place in the file.
class InstanceBuilder
{
public:
    InstanceBuilder(std::shared_ptr<const Graph> graph, std::string file);

    /// The next robot's start and goal. Throws ParseError where another robot has that start or goal.
    void addStart(Vertex v, std::size_t line, std::size_t column);
    void addGoal(Vertex v, std::size_t line, std::size_t column);

    [[nodiscard]] const Graph &graph() const { return *instance_.graph; }
    [[nodiscard]] Instance take() { return std::move(instance_); }

private:
    void add(std::vector<Vertex> &places, std::vector<std::size_t> &lineOf, const char *role, Vertex v,
             std::size_t line, std::size_t column);

    std::string file_;
    Instance instance_;
    std::vector<std::size_t> startLine_; ///< where a vertex became a start; 0 for none
    std::vector<std::size_t> goalLine_;
};

} // namespace mrpp
