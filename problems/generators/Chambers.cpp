#include "problems/generators/Chambers.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

namespace
{
/// How many chambers of `size` with walls between them fit; at least one.
std::size_t chambersIn(std::size_t cells, std::size_t size)
{
    return std::max<std::size_t>(1, (cells + 1) / (size + 1));
}
} // namespace

Chambers::Chambers(std::size_t width, std::size_t height, std::size_t size)
    : size_(size), columns_(chambersIn(width, size)), rows_(chambersIn(height, size)),
      cells_(width, height, true)
{
    for (std::size_t column = 1; column < columns_; ++column)
        for (std::size_t y = 0; y < height; ++y)
            cells_.set(column * (size + 1) - 1, y, false);
    for (std::size_t row = 1; row < rows_; ++row)
        for (std::size_t x = 0; x < width; ++x)
            cells_.set(x, row * (size + 1) - 1, false);
}

std::size_t Chambers::wallLength(std::size_t chamber, std::size_t neighbor) const
{
    const bool beside = isBeside(chamber, neighbor);
    const std::size_t index = beside ? chamber / columns_ : chamber % columns_;
    const bool last = index + 1 == (beside ? rows_ : columns_);
    return last ? (beside ? cells_.height() : cells_.width()) - index * (size_ + 1) : size_;
}

void Chambers::open(std::size_t chamber, std::size_t neighbor, std::size_t offset, std::size_t length)
{
    assert(offset + length <= wallLength(chamber, neighbor));
    const std::size_t x = chamber % columns_ * (size_ + 1);
    const std::size_t y = chamber / columns_ * (size_ + 1);
    for (std::size_t i = offset; i < offset + length; ++i)
    {
        if (isBeside(chamber, neighbor))
            cells_.set(x + size_, y + i, true);
        else
            cells_.set(x + i, y + size_, true);
    }
}

ChamberGenerator::ChamberGenerator(std::string family, std::string sizeName, std::string sizeHelp,
                                   std::int64_t size)
    : family_(std::move(family)), size_(size)
{
    declareParam("width", width_, "1:1000000", "cells in a row");
    declareParam("height", height_, "1:1000000", "rows");
    declareParam(std::move(sizeName), size_, "1:1000", std::move(sizeHelp));
}

std::string ChamberGenerator::name() const
{
    return family_ + " " + std::to_string(width_) + "×" + std::to_string(height_) + "-" +
           std::to_string(size_);
}

void ChamberGenerator::checkParameters() const
{
    requireSize(static_cast<double>(width_) * static_cast<double>(height_));
}

std::shared_ptr<const Graph> ChamberGenerator::makeGraph(Seed seed) const
{
    Random random(seed);
    Chambers chambers(static_cast<std::size_t>(width_), static_cast<std::size_t>(height_),
                      static_cast<std::size_t>(size_));
    openDoors(chambers, random);
    return chambers.graph();
}

} // namespace mrpp
