#include "reports/layouts/Placement.h"

#include "framework/model/DrawingCoordinates.h"
#include "reports/layouts/GraphvizGraph.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace mrpp
{

namespace
{

constexpr double kDiameters = 0.6; ///< of a vertex and the gap beside it, in spacings

/// What a tenth of the places have their nearest one within. \param places sorted
double crampedDistance(const std::vector<std::pair<double, double>> &places)
{
    std::vector<double> nearest;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        double least = std::numeric_limits<double>::infinity();
        const auto isBeyond = [&](std::size_t j)
        {
            const double across = places[j].first - places[i].first;
            least = std::min(least, std::hypot(across, places[j].second - places[i].second));
            return std::abs(across) > least;
        };
        for (std::size_t j = i; j-- > 0 && !isBeyond(j);)
            ;
        for (std::size_t j = i + 1; j < places.size() && !isBeyond(j); ++j)
            ;
        nearest.push_back(least);
    }
    const auto tenth = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 10);
    std::nth_element(nearest.begin(), tenth, nearest.end());
    return *tenth;
}

} // namespace

DrawingScale drawingScale(std::size_t vertices)
{
    constexpr std::size_t kNumbered = 400;
    constexpr std::size_t kMedium = 1500;
    if (vertices <= kNumbered)
        return {true, 58, 31, 3, 2};
    if (vertices <= kMedium)
        return {false, 24, 13, 2.2, 1.4};
    return {false, 14, 8, 1.6, 1};
}

std::optional<Placement> placeByCoordinates(const Graph &graph, double spacing)
{
    if (!graph.hasCoordinates())
        return std::nullopt;
    std::vector<Point> positions = drawingCoordinates(graph);
    double least[2] = {positions.front().x, positions.front().y};
    double most[2] = {least[0], least[1]};
    const double up = graph.yAxis() == YAxis::down ? -1 : 1;
    for (Point &position : positions)
    {
        if (!std::isfinite(position.x) || !std::isfinite(position.y))
            return std::nullopt;
        position.y *= up;
        position.z = 0;
    }
    least[1] = most[1] = positions.front().y;
    for (const Point &position : positions)
    {
        least[0] = std::min(least[0], position.x);
        least[1] = std::min(least[1], position.y);
        most[0] = std::max(most[0], position.x);
        most[1] = std::max(most[1], position.y);
    }

    std::vector<std::pair<double, double>> places;
    places.reserve(positions.size());
    for (const Point &position : positions)
        places.emplace_back(position.x, position.y);
    std::sort(places.begin(), places.end());
    if (std::adjacent_find(places.begin(), places.end()) != places.end())
        return std::nullopt;

    std::vector<double> lengths;
    for (const Graph::Edge &edge : graph.edges())
        lengths.push_back(
            std::hypot(positions[edge.a].x - positions[edge.b].x, positions[edge.a].y - positions[edge.b].y));
    double unit = 1;
    if (!lengths.empty())
    {
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        unit = *middle;
    }
    if (places.size() <= kLargestGraph)
        unit = std::min(unit, std::max(unit / 2, crampedDistance(places) / kDiameters));
    constexpr double kLargestPage = 14000; // points; PDF ends at 200 inches
    constexpr double kFinest = 1e-7;       // of the extent: nothing is drawn finer
    const double widest = std::max(most[0] - least[0], most[1] - least[1]);
    unit = std::max(unit, widest * kFinest);
    const double extent = std::max(widest, unit);
    const double factor = std::min(spacing / unit, kLargestPage / extent);
    for (Point &position : positions)
    {
        position.x = (position.x - least[0]) * factor;
        position.y = (position.y - least[1]) * factor;
    }
    return Placement{std::move(positions), unit * factor};
}

Placement placeByEngine(const Graph &graph, double spacing, double diameter)
{
    if (graph.vertexCount() > kLargestForceLayout)
        throw DrawingError(fmt::format("{} vertices without coordinates are too many for Graphviz to arrange "
                                       "(at most {})",
                                       graph.vertexCount(), kLargestForceLayout));
    GraphvizGraph drawing;
    drawing.setDefault(GraphvizGraph::Kind::graph, "overlap", "prism");
    drawing.setDefault(GraphvizGraph::Kind::graph, "start", "1");
    drawing.setDefault(GraphvizGraph::Kind::graph, "K", inches(spacing));
    drawing.setDefault(GraphvizGraph::Kind::node, "shape", "circle");
    drawing.setDefault(GraphvizGraph::Kind::node, "fixedsize", "true");
    drawing.setDefault(GraphvizGraph::Kind::node, "label", "");
    drawing.setDefault(GraphvizGraph::Kind::node, "width", inches(diameter * 1.4));
    drawing.setDefault(GraphvizGraph::Kind::edge, "len", inches(spacing));
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        drawing.addNode();
    for (const Graph::Edge &edge : graph.edges())
        drawing.addEdge(edge.a, edge.b);
    return {drawing.arrange(graph.vertexCount() <= kLargestSpringLayout ? "neato" : "sfdp"), spacing};
}

Placement placeGraph(const Graph &graph)
{
    if (graph.vertexCount() == 0)
        throw DrawingError("the graph has no vertices");
    const DrawingScale scale = drawingScale(graph.vertexCount());
    if (std::optional<Placement> placement = placeByCoordinates(graph, scale.spacing))
        return *std::move(placement);
    if (graph.vertexCount() > kLargestGraph)
        throw DrawingError(fmt::format("{} vertices are too many for Graphviz (at most {}), and there are no "
                                       "coordinates to draw a map from",
                                       graph.vertexCount(), kLargestGraph));
    return placeByEngine(graph, scale.spacing, scale.diameter);
}

Extent extentOf(const Placement &placement)
{
    Extent extent;
    for (const Point &position : placement.positions)
    {
        extent.width = std::max(extent.width, position.x);
        extent.height = std::max(extent.height, position.y);
    }
    return extent;
}

} // namespace mrpp
