#include "reports/explorer/GraphBlock.h"

#include "framework/analysis/Blocks.h"
#include "framework/support/Bytes.h"
#include "reports/layouts/LayoutPicture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mrpp
{

namespace
{

/// Each component beside the others: its smallest vertex in the middle, every other one on the ring of its
/// distance, beyond its parent, with an angle for each vertex below it. A ring has room for its vertices.
/// Crude, but linear.
Placement placeOnRings(const Graph &graph)
{
    struct Place
    {
        Vertex parent = kNoVertex;
        std::size_t ring = 0;
        double begin = 0; ///< angles
        double width = 2 * std::numbers::pi;
        double used = 0; ///< of the width, by children
        double below = 1;
        bool isFound = false;
    };
    std::vector<Place> places(graph.vertexCount());
    Placement placement{std::vector<Point>(graph.vertexCount()), kGraphUnit};
    double left = 0;
    for (Vertex root = 0; root < graph.vertexCount(); ++root)
    {
        if (places[root].isFound)
            continue;
        std::vector<Vertex> order = {root};
        places[root].isFound = true;
        for (std::size_t next = 0; next < order.size(); ++next)
            for (const Vertex v : graph.neighbors(order[next]))
                if (!std::exchange(places[v].isFound, true))
                {
                    places[v].parent = order[next];
                    places[v].ring = places[order[next]].ring + 1;
                    order.push_back(v);
                }
        for (std::size_t i = order.size(); --i > 0;)
            places[places[order[i]].parent].below += places[order[i]].below;
        std::vector<double> radii(places[order.back()].ring + 1, 0);
        for (const Vertex v : order)
            ++radii[places[v].ring];
        radii.front() = 0;
        for (std::size_t ring = 1; ring < radii.size(); ++ring)
            radii[ring] = std::max(radii[ring - 1] + 1, radii[ring] / (2 * std::numbers::pi));
        for (const Vertex v : order)
        {
            Place &place = places[v];
            if (place.parent != kNoVertex)
            {
                Place &parent = places[place.parent];
                place.width = parent.width * place.below / (parent.below - 1);
                place.begin = parent.begin + parent.used;
                parent.used += place.width;
            }
            const double angle = place.begin + place.width / 2;
            const double radius = radii[place.ring];
            placement.positions[v] = {(left + radii.back() + radius * std::cos(angle)) * kGraphUnit,
                                      radius * std::sin(angle) * kGraphUnit, 0};
        }
        left += 2 * radii.back() + 2;
    }
    return placement;
}

Placement place(const Graph &graph)
{
    constexpr double kSpacing = 16;
    constexpr double kDiameter = 8;
    if (graph.vertexCount() == 0)
        return {{}, kGraphUnit};
    if (auto placement = placeByCoordinates(graph, kSpacing))
        return std::move(*placement);
    try
    {
        return placeByEngine(graph, kSpacing, kDiameter);
    }
    catch (const DrawingError &)
    {
        return placeOnRings(graph);
    }
}

void writePlaces(ByteWriter &writer, const Placement &placement)
{
    const double factor = kGraphUnit / placement.spacing;
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    for (const Point &point : placement.positions)
    {
        const auto nextX = static_cast<std::uint32_t>(std::llround(point.x * factor));
        const auto nextY = static_cast<std::uint32_t>(std::llround(point.y * factor));
        writer.difference(nextX, std::exchange(x, nextX));
        writer.difference(nextY, std::exchange(y, nextY));
    }
}

} // namespace

std::vector<std::uint8_t> graphBlock(const Graph &graph)
{
    ByteWriter writer;
    writer.number(graph.vertexCount());
    writer.number(graph.edgeCount());
    writePlaces(writer, place(graph));
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        const auto around = graph.neighbors(v);
        const auto larger = std::upper_bound(around.begin(), around.end(), v);
        writer.number(static_cast<std::uint64_t>(around.end() - larger));
        Vertex previous = v;
        for (auto w = larger; w != around.end(); ++w)
            writer.number(*w - std::exchange(previous, *w));
    }
    const Blocks blocks(graph);
    std::uint32_t previous = 0;
    for (const Graph::Edge &edge : graph.edges())
    {
        const std::uint32_t block = blocks.ofEdge(edge.a, edge.b);
        writer.difference(block, std::exchange(previous, block));
    }
    writer.number(blocks.count());
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
        writer.number(blocks.vertices(block).size());
    return writer.take();
}

} // namespace mrpp
