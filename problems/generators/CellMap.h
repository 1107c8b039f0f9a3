#pragma once
/// \file
/// A map of cells, free or blocked, as a graph: each free cell is a vertex, numbered row by row, and cells
/// that share a side are neighbours, as in MovingAI's maps (formats/MovingAiMap.h).

#include "framework/model/Graph.h"

#include <vector>

namespace mrpp
{

class CellMap
{
public:
    /// All cells free, or all blocked. O(cells).
    CellMap(std::size_t width, std::size_t height, bool free)
        : width_(width), free_(width * height, free ? 1 : 0)
    {}

    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return free_.size() / width_; }
    [[nodiscard]] std::size_t cellCount() const { return free_.size(); }
    [[nodiscard]] bool isFree(std::size_t x, std::size_t y) const { return free_[y * width_ + x] != 0; }
    void set(std::size_t x, std::size_t y, bool free) { setCell(y * width_ + x, free); }
    void setCell(std::size_t cell, bool free) { free_[cell] = free ? 1 : 0; }

    /// Coordinates are columns and rows; y grows downwards. O(cells).
    [[nodiscard]] std::shared_ptr<const Graph> graph() const;

private:
    std::size_t width_;
    std::vector<char> free_; ///< row by row
};

} // namespace mrpp
