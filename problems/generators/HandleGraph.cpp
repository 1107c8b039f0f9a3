#include "problems/generators/HandleGraph.h"

#include "problems/generators/Drawing.h"

#include <cassert>
#include <cmath>

namespace mrpp
{

HandleGraph::HandleGraph(std::size_t size) : coordinates_(circle(size))
{
    assert(size >= 3);
    for (std::size_t v = 0; v < size; ++v)
        edges_.push_back({static_cast<Vertex>(v), static_cast<Vertex>((v + 1) % size)});
}

void HandleGraph::addHandle(Vertex x, Vertex y, std::size_t inner)
{
    assert(x != y && inner >= 1 && x < vertexCount() && y < vertexCount());
    // Each handle bows out by another share of its length, away from the origin: handles that begin and end
    // at the same vertices still lie apart.
    constexpr double kGolden = 0.6180339887498949;
    const double share = static_cast<double>(handles_) * kGolden;
    const double bow = 0.2 + 0.5 * (share - std::floor(share));
    const Point from = coordinates_[x];
    const Point to = coordinates_[y];
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double outwards = (from.x + to.x) * dy - (from.y + to.y) * dx < 0 ? -bow : bow;
    ++handles_;

    Vertex last = x;
    for (std::size_t i = 1; i <= inner; ++i)
    {
        const double t = static_cast<double>(i) / static_cast<double>(inner + 1);
        const double height = outwards * 4 * t * (1 - t);
        const auto next = static_cast<Vertex>(vertexCount());
        coordinates_.push_back(drawnPoint(from.x + t * dx + height * dy, from.y + t * dy - height * dx));
        edges_.push_back({last, next});
        last = next;
    }
    edges_.push_back({last, y});
}

void HandleGraph::addRandomHandle(std::size_t inner, Random &random)
{
    const auto x = static_cast<Vertex>(random.below(vertexCount()));
    auto y = static_cast<Vertex>(random.below(vertexCount()));
    if (x == y)
        y = x == 0 ? 1 : x - 1;
    addHandle(x, y, inner);
}

} // namespace mrpp
