#pragma once
/// \file
/// Warehouses as those of the MAPF benchmarks (R. Stern et al., "Multi-Agent Pathfinding: Definitions,
/// Variants, and Benchmarks", SoCS 2019): shelves in columns and rows with aisles between them, and open
/// floor at both ends.
///
/// \code
/// - warehouse: {columns: 10, rows: 20, shelf_length: 10, shelf_width: 2, aisle: 1, margin: 25, robots: 100}
/// \endcode
///
/// Promises: columns · (shelf_length + aisle) − aisle + 2 · margin cells in a row, rows · (shelf_width +
/// aisle)
/// + aisle rows, columns · rows shelves of shelf_length × shelf_width blocked cells; connected. The defaults
/// give the vertices and edges of warehouse-10-20-10-2-1. Not random. O(cells).

#include "problems/generators/Generator.h"

namespace mrpp
{

class Warehouse : public Generator
{
public:
    Warehouse();

    /// "warehouse 10-20-10-2-1": columns, rows, a shelf's length and width, aisle.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    [[nodiscard]] std::int64_t width() const
    {
        return columns_ * (shelfLength_ + aisle_) - aisle_ + 2 * margin_;
    }
    [[nodiscard]] std::int64_t height() const { return rows_ * (shelfWidth_ + aisle_) + aisle_; }

    std::int64_t columns_ = 10;
    std::int64_t rows_ = 20;
    std::int64_t shelfLength_ = 10;
    std::int64_t shelfWidth_ = 2;
    std::int64_t aisle_ = 1;
    std::int64_t margin_ = 25;
};

} // namespace mrpp
