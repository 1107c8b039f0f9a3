#include "problems/generators/Drawing.h"

#include "problems/generators/ForceDrawing.h"

#include <cmath>
#include <numbers>

namespace mrpp
{

Point drawnPoint(double x, double y)
{
    constexpr double kUnit = 1000;
    return {std::round(x * kUnit) / kUnit + 0.0, std::round(y * kUnit) / kUnit + 0.0, 0}; // + 0.0: never −0
}

std::vector<Point> circle(std::size_t size)
{
    const double step = 2 * std::numbers::pi / static_cast<double>(size);
    const double radius = size < 2 ? 0 : 0.5 / std::sin(step / 2);
    std::vector<Point> points;
    points.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
    {
        const double angle = step * static_cast<double>(i);
        points.push_back(drawnPoint(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return points;
}

std::shared_ptr<const Graph> drawnGraph(std::size_t vertexCount, std::span<const Graph::Edge> edges)
{
    const auto plain = Graph::fromEdges(vertexCount, edges);
    return Graph::fromEdges(vertexCount, edges, forceDrawing(*plain));
}

} // namespace mrpp
