#include "problems/generators/Maze.h"

#include <algorithm>
#include <array>

namespace mrpp
{

Maze::Maze() : ChamberGenerator("maze", "corridor", "cells across a corridor", 1) {}

void Maze::openDoors(Chambers &chambers, Random &random) const
{
    std::vector<char> seen(chambers.count(), 0);
    std::vector<std::size_t> trail{random.below(chambers.count())};
    seen[trail.back()] = 1;
    while (!trail.empty())
    {
        const std::size_t here = trail.back();
        const std::size_t column = here % chambers.columns();
        std::array<std::size_t, 4> fresh{};
        std::size_t count = 0;
        const auto consider = [&](bool exists, std::size_t next)
        {
            if (exists && seen[next] == 0)
                fresh[count++] = next;
        };
        consider(here >= chambers.columns(), here - chambers.columns());
        consider(column > 0, here - 1);
        consider(column + 1 < chambers.columns(), here + 1);
        consider(here + chambers.columns() < chambers.count(), here + chambers.columns());
        if (count == 0)
        {
            trail.pop_back();
            continue;
        }
        const std::size_t next = fresh[random.below(count)];
        const auto [first, second] = std::minmax(here, next);
        chambers.open(first, second, 0, chambers.wallLength(first, second));
        seen[next] = 1;
        trail.push_back(next);
    }
}

} // namespace mrpp
