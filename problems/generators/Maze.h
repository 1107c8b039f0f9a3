#pragma once
/// \file
/// Mazes as those of the Moving AI Lab's benchmarks (N. R. Sturtevant, "Benchmarks for Grid-Based
/// Pathfinding", IEEE TCIAIG 4(2), 2012): corridors of a given width between walls one cell thick.
///
/// \code
/// - maze: {width: 32, height: 32, corridor: 2, robots: 20}
/// \endcode
///
/// Promises: connected; corridors at least `corridor` wide; between two squares of corridor there is exactly
/// one way, so that with corridors of width 1 the graph is a tree (where width and height are odd). A
/// randomized depth-first search over the squares. Where the corridors do not fill the map evenly, the last
/// column and row of squares are wider. The map has no outer wall. O(cells).

#include "problems/generators/Generator.h"

namespace mrpp
{

class Maze : public Generator
{
public:
    Maze();

    /// "maze 32×32-2": size, width of the corridors.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    std::int64_t width_ = 32;
    std::int64_t height_ = 32;
    std::int64_t corridor_ = 1;
};

} // namespace mrpp
