#pragma once
/// \file
/// A map divided into chambers by walls one cell thick, into which doors are cut, and what the generators
/// have in common that cut them: mazes and rooms.

#include "problems/generators/CellMap.h"
#include "problems/generators/Generator.h"

namespace mrpp
{

class Chambers
{
public:
    /// All doors closed. Chambers are squares of `size` cells, the last of each row and column larger where
    /// that fills the map. \pre no number is 0
    Chambers(std::size_t width, std::size_t height, std::size_t size);

    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t count() const { return columns_ * rows_; }

    /// Opens the wall between a chamber and a later neighbour (numbered row by row), `length` cells of it
    /// from `offset` on. \pre they share a wall of so many cells
    void open(std::size_t chamber, std::size_t neighbor, std::size_t offset, std::size_t length);
    /// How many cells the wall between them has.
    [[nodiscard]] std::size_t wallLength(std::size_t chamber, std::size_t neighbor) const;

    [[nodiscard]] std::shared_ptr<const Graph> graph() const { return cells_.graph(); }

private:
    [[nodiscard]] bool isBeside(std::size_t chamber, std::size_t neighbor) const
    {
        return neighbor == chamber + 1 && neighbor % columns_ != 0;
    }

    std::size_t size_;
    std::size_t columns_;
    std::size_t rows_;
    CellMap cells_;
};

/// A generator that differs from others in the doors alone.
class ChamberGenerator : public Generator
{
public:
    /// "maze 32×32-2": width, height, size of a chamber.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    /// Declares width and height, and the side of a chamber under the given name.
    ChamberGenerator(std::string family, std::string sizeName, std::string sizeHelp, std::int64_t size);

    void checkParameters() const override;

    /// Opens walls until all chambers are connected.
    virtual void openDoors(Chambers &chambers, Random &random) const = 0;

private:
    std::string family_;
    std::int64_t width_ = 32;
    std::int64_t height_ = 32;
    std::int64_t size_;
};

} // namespace mrpp
