#include "problems/generators/Rooms.h"

#include "problems/generators/Chambers.h"
#include "problems/generators/SpanningTree.h"

namespace mrpp
{

Rooms::Rooms()
{
    declareParam("width", width_, "1:1000000", "cells in a row");
    declareParam("height", height_, "1:1000000", "rows");
    declareParam("room", room_, "1:1000", "cells along a room's side");
    declareParam("doors", doors_, "0:1",
                 "share of the walls with a door beyond those that connect all rooms");
}

std::string Rooms::name() const
{
    return "rooms " + std::to_string(width_) + "×" + std::to_string(height_) + "-" + std::to_string(room_);
}

void Rooms::checkParameters() const
{
    requireSize(static_cast<double>(width_) * static_cast<double>(height_));
}

std::shared_ptr<const Graph> Rooms::makeGraph(Seed seed) const
{
    Random random(seed);
    Chambers chambers(static_cast<std::size_t>(width_), static_cast<std::size_t>(height_),
                      static_cast<std::size_t>(room_));
    auto walls = gridEdges(chambers.columns(), chambers.rows());
    const std::size_t needed = moveSpanningTreeFirst(walls, chambers.count(), random);
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (i < needed || random.uniform() < doors_)
            chambers.open(walls[i].a, walls[i].b, random.below(chambers.wallLength(walls[i].a, walls[i].b)),
                          1);
    return chambers.graph();
}

} // namespace mrpp
