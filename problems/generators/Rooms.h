#pragma once
/// \file
/// Rooms with doors, as those of the Moving AI Lab's benchmarks (N. R. Sturtevant, "Benchmarks for Grid-Based
/// Pathfinding", IEEE TCIAIG 4(2), 2012): square rooms in rows and columns, walls one cell thick, doors of
/// one cell.
///
/// \code
/// - rooms: {width: 32, height: 32, room: 7, doors: 0.5, robots: 20}
/// \endcode
///
/// Promises: connected; at most one door in each wall between two rooms. A random spanning tree of the rooms
/// (SpanningTree.h) has doors, and each other wall has one with probability `doors`, at a uniformly random
/// place. Where the rooms do not fill the map evenly, the last column and row of rooms are larger. The map
/// has no outer wall. O(cells).

#include "problems/generators/Chambers.h"

namespace mrpp
{

class Rooms : public ChamberGenerator
{
public:
    Rooms();

protected:
    /// One cell in each wall of a random spanning tree, and of others by chance.
    void openDoors(Chambers &chambers, Random &random) const override;

private:
    double doors_ = 0.5;
};

} // namespace mrpp
