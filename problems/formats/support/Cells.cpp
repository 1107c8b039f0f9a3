#include "problems/formats/support/Cells.h"

#include "framework/support/Error.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

Cells::Cells(const Graph &graph)
{
    const auto refuse = [](const std::string &why)
    { throw InputError("this graph does not lie on a grid's cells: " + why); };
    if (graph.vertexCount() > 0 && !graph.hasCoordinates())
        refuse("its vertices have no coordinates");
    constexpr double largest = 1 << 30;
    cells_.reserve(graph.vertexCount());
    order_.reserve(graph.vertexCount());
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        const Point &p = graph.coordinate(v);
        if (p.x != std::floor(p.x) || p.y != std::floor(p.y) || p.x < 0 || p.y < 0 || p.x >= largest ||
            p.y >= largest)
            refuse("its coordinates must be columns and rows, whole numbers from 0 on");
        cells_.emplace_back(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y));
        const auto [x, y] = cells_.back();
        width_ = std::max(width_, x + 1);
        height_ = std::max(height_, y + 1);
        order_.emplace_back(std::uint64_t{y} << 32 | x, v);
    }
    if (!std::is_sorted(order_.begin(), order_.end()))
        std::sort(order_.begin(), order_.end());
    if (std::adjacent_find(order_.begin(), order_.end(),
                           [](const auto &a, const auto &b) { return a.first == b.first; }) != order_.end())
        refuse("two vertices share a cell");
}

Vertex Cells::vertexAt(std::int64_t x, std::int64_t y) const
{
    if (x < 0 || y < 0 || x >= width_ || y >= height_)
        return kNoVertex;
    const std::uint64_t key = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
    const auto found = std::lower_bound(order_.begin(), order_.end(), std::pair(key, Vertex{0}));
    return found != order_.end() && found->first == key ? found->second : kNoVertex;
}

std::string cellName(std::int64_t x, std::int64_t y)
{
    return "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

InstanceBuilder::InstanceBuilder(std::shared_ptr<const Graph> graph, std::string file)
    : file_(std::move(file)), instance_{std::move(graph), {}, {}},
      startLine_(instance_.graph->vertexCount(), 0), goalLine_(instance_.graph->vertexCount(), 0)
{}

void InstanceBuilder::addStart(Vertex v, std::size_t line, std::size_t column)
{
    add(instance_.starts, startLine_, "start", v, line, column);
}

void InstanceBuilder::addGoal(Vertex v, std::size_t line, std::size_t column)
{
    add(instance_.goals, goalLine_, "goal", v, line, column);
}

void InstanceBuilder::add(std::vector<Vertex> &places, std::vector<std::size_t> &lineOf, const char *role,
                          Vertex v, std::size_t line, std::size_t column)
{
    if (lineOf[v] != 0)
        throw ParseError({file_, line, column}, "vertex " + std::to_string(v) + " is the " + role +
                                                    " of the robot in line " + std::to_string(lineOf[v]) +
                                                    " too; robots need distinct " + role + "s");
    lineOf[v] = line;
    places.push_back(v);
}

} // namespace mrpp
