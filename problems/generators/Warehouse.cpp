#include "problems/generators/Warehouse.h"

#include "problems/generators/CellMap.h"

namespace mrpp
{

Warehouse::Warehouse()
{
    declareParam("columns", columns_, "1:1000000", "shelves side by side");
    declareParam("rows", rows_, "1:1000000", "shelves one above another");
    declareParam("shelf_length", shelfLength_, "1:1000000", "cells of a shelf along a row");
    declareParam("shelf_width", shelfWidth_, "1:1000000", "rows that a shelf covers");
    declareParam("aisle", aisle_, "1:1000000", "cells between two shelves");
    declareParam("margin", margin_, "1:1000000", "columns of open floor on each side of the shelves");
}

std::string Warehouse::name() const
{
    std::string text = "warehouse " + std::to_string(columns_);
    for (const std::int64_t number : {rows_, shelfLength_, shelfWidth_, aisle_})
        text += "-" + std::to_string(number);
    return text;
}

void Warehouse::checkParameters() const
{
    requireSize(static_cast<double>(width()) * static_cast<double>(height()));
}

std::shared_ptr<const Graph> Warehouse::makeGraph(Seed) const
{
    CellMap cells(static_cast<std::size_t>(width()), static_cast<std::size_t>(height()), true);
    const auto size = [](std::int64_t number) { return static_cast<std::size_t>(number); };
    const std::size_t columnStep = size(shelfLength_ + aisle_);
    const std::size_t rowStep = size(shelfWidth_ + aisle_);
    for (std::size_t row = 0; row < size(rows_); ++row)
        for (std::size_t column = 0; column < size(columns_); ++column)
            for (std::size_t y = 0; y < size(shelfWidth_); ++y)
                for (std::size_t x = 0; x < size(shelfLength_); ++x)
                    cells.set(size(margin_) + column * columnStep + x, size(aisle_) + row * rowStep + y,
                              false);
    return cells.graph();
}

} // namespace mrpp
