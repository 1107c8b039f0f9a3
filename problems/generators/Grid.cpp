#include "problems/generators/Grid.h"

#include "framework/support/Error.h"
#include "problems/generators/CellMap.h"
#include "problems/generators/SpanningTree.h"

#include <cmath>

namespace mrpp
{

namespace
{

constexpr std::int64_t kUsualSide = 10;

/// Blocks `count` cells, each a random leaf of what a random spanning tree still has.
void addObstacles(CellMap &cells, std::size_t count, Random &random)
{
    auto edges = gridEdges(cells.width(), cells.height());
    edges.resize(moveSpanningTreeFirst(edges, cells.cellCount(), random));
    const auto tree = Graph::fromEdges(cells.cellCount(), edges);
    std::vector<std::size_t> degree(cells.cellCount());
    std::vector<Vertex> leaves;
    for (Vertex v = 0; v < cells.cellCount(); ++v)
    {
        degree[v] = tree->degree(v);
        if (degree[v] == 1)
            leaves.push_back(v);
    }
    for (; count > 0; --count)
    {
        std::swap(leaves[random.below(leaves.size())], leaves.back());
        const Vertex leaf = leaves.back();
        leaves.pop_back();
        cells.setCell(leaf, false);
        degree[leaf] = 0;
        for (const Vertex v : tree->neighbors(leaf))
            if (degree[v] > 0 && --degree[v] == 1)
                leaves.push_back(v);
    }
}

} // namespace

Grid::Grid()
{
    declareParam("side", side_, "0:10000", "cells along each side; 0 where width and height are given");
    declareParam("width", width_, "0:100000000", "cells in a row, with height instead of side");
    declareParam("height", height_, "0:100000000", "rows, with width instead of side");
    declareParam("obstacles", obstacles_, "0:0.95", "share of the cells that are blocked");
}

std::size_t Grid::width() const
{
    return static_cast<std::size_t>(width_ > 0 ? width_ : side_ > 0 ? side_ : kUsualSide);
}

std::size_t Grid::height() const
{
    return static_cast<std::size_t>(height_ > 0 ? height_ : side_ > 0 ? side_ : kUsualSide);
}

std::string Grid::name() const
{
    const std::string text = "grid " + std::to_string(width()) + "×" + std::to_string(height());
    return obstacles_ == 0 ? text : text + "-" + formatNumber(obstacles_);
}

void Grid::checkParameters() const
{
    if (side_ > 0 && (width_ > 0 || height_ > 0))
        throw InputError("a grid has either a side, or width and height");
    if ((width_ > 0) != (height_ > 0))
        throw InputError("width and height go together; for a square grid give its side");
    requireSize(static_cast<double>(width()) * static_cast<double>(height()));
}

std::shared_ptr<const Graph> Grid::makeGraph(Seed seed) const
{
    CellMap cells(width(), height(), true);
    const auto count =
        static_cast<std::size_t>(std::floor(obstacles_ * static_cast<double>(cells.cellCount()) + 1e-9));
    if (count > 0)
    {
        Random random(seed);
        addObstacles(cells, count, random);
    }
    return cells.graph();
}

} // namespace mrpp
