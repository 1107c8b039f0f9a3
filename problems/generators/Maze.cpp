#include "problems/generators/Maze.h"

#include "problems/generators/Chambers.h"

#include <algorithm>
#include <array>

namespace mrpp
{

namespace
{

/// Opens the walls along a randomized depth-first search.
void carve(Chambers &chambers, Random &random)
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

} // namespace

Maze::Maze()
{
    declareParam("width", width_, "1:1000000", "cells in a row");
    declareParam("height", height_, "1:1000000", "rows");
    declareParam("corridor", corridor_, "1:1000", "cells across a corridor");
}

std::string Maze::name() const
{
    return "maze " + std::to_string(width_) + "×" + std::to_string(height_) + "-" + std::to_string(corridor_);
}

void Maze::checkParameters() const
{
    requireSize(static_cast<double>(width_) * static_cast<double>(height_));
}

std::shared_ptr<const Graph> Maze::makeGraph(Seed seed) const
{
    Random random(seed);
    Chambers chambers(static_cast<std::size_t>(width_), static_cast<std::size_t>(height_),
                      static_cast<std::size_t>(corridor_));
    carve(chambers, random);
    return chambers.graph();
}

} // namespace mrpp
