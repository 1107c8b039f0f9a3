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

#include "problems/generators/Chambers.h"

namespace mrpp
{

class Maze : public ChamberGenerator
{
public:
    Maze();

protected:
    /// Along a randomized depth-first search, each wall as a whole.
    void openDoors(Chambers &chambers, Random &random) const override;
};

} // namespace mrpp
