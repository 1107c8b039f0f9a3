#include "problems/generators/Rooms.h"

#include "problems/generators/SpanningTree.h"

namespace mrpp
{

Rooms::Rooms() : ChamberGenerator("rooms", "room", "cells along a room's side", 7)
{
    declareParam("doors", doors_, "0:1",
                 "share of the walls with a door beyond those that connect all rooms");
}

void Rooms::openDoors(Chambers &chambers, Random &random) const
{
    auto walls = gridEdges(chambers.columns(), chambers.rows());
    const std::size_t needed = moveSpanningTreeFirst(walls, chambers.count(), random);
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (i < needed || random.uniform() < doors_)
            chambers.open(walls[i].a, walls[i].b, random.below(chambers.wallLength(walls[i].a, walls[i].b)),
                          1);
}

} // namespace mrpp
