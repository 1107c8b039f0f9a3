#include "problems/generators/CycleLeaves.h"

#include "problems/generators/Drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrpp
{

CycleLeaves::CycleLeaves()
{
    declareParam("cycle_size", cycleSize_, "3:100000000", "vertices of each cycle");
    declareParam("bridge_length", bridgeLength_, "1:100000000",
                 "edges between the two cycles, or between the middle and each cycle where there are more");
    declareParam("cycles", cycles_, "2:10000000", "how many cycles");
}

std::string CycleLeaves::name() const
{
    return "cycle_leaves " + std::to_string(cycles_) + "×" + std::to_string(cycleSize_) + "-" +
           std::to_string(bridgeLength_);
}

void CycleLeaves::checkParameters() const
{
    requireSize(static_cast<double>(cycles_) * static_cast<double>(cycleSize_ + bridgeLength_) + 1);
}

std::shared_ptr<const Graph> CycleLeaves::makeGraph(Seed) const
{
    const auto cycles = static_cast<std::size_t>(cycles_);
    const auto size = static_cast<std::size_t>(cycleSize_);
    const auto length = static_cast<std::size_t>(bridgeLength_);
    const std::vector<Point> ring = circle(size);
    const double radius = ring.front().x;
    // The arms are long enough for the cycles at their ends to lie apart.
    const double arm = static_cast<double>(length) / (cycles == 2 ? 2 : 1);
    const double step = 2 * std::numbers::pi / static_cast<double>(cycles);
    const double reach =
        std::max(arm, (radius + 0.5) / std::sin(std::min(step, std::numbers::pi) / 2) - radius);

    std::vector<Graph::Edge> edges;
    std::vector<Point> points;
    for (std::size_t c = 0; c < cycles; ++c)
    {
        const double turnX = std::cos(step * static_cast<double>(c));
        const double turnY = std::sin(step * static_cast<double>(c));
        const auto first = static_cast<Vertex>(points.size());
        for (std::size_t i = 0; i < size; ++i)
        {
            const double x = reach + radius - ring[i].x; // the first one is nearest to the middle
            points.push_back(drawnPoint(x * turnX - ring[i].y * turnY, x * turnY + ring[i].y * turnX));
            edges.push_back({first + static_cast<Vertex>(i), first + static_cast<Vertex>((i + 1) % size)});
        }
    }
    const auto addPath = [&](Vertex from, Point to, std::size_t edgeCount)
    {
        const Point begin = points[from];
        Vertex last = from;
        for (std::size_t i = 1; i < edgeCount; ++i)
        {
            const double t = static_cast<double>(i) / static_cast<double>(edgeCount);
            points.push_back(drawnPoint(begin.x + t * (to.x - begin.x), begin.y + t * (to.y - begin.y)));
            edges.push_back({last, static_cast<Vertex>(points.size() - 1)});
            last = static_cast<Vertex>(points.size() - 1);
        }
        return last;
    };
    if (cycles == 2)
    {
        const auto other = static_cast<Vertex>(size);
        edges.push_back({addPath(0, points[other], length), other});
    }
    else
    {
        std::vector<Vertex> ends;
        for (std::size_t c = 0; c < cycles; ++c)
            ends.push_back(addPath(static_cast<Vertex>(c * size), Point{}, length));
        const auto middle = static_cast<Vertex>(points.size());
        points.emplace_back();
        for (const Vertex end : ends)
            edges.push_back({end, middle});
    }
    const std::size_t vertices = points.size(); // before the points are moved away
    return Graph::fromEdges(vertices, edges, std::move(points));
}

} // namespace mrpp
