#include "reports/layouts/MapGround.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrpp
{

namespace
{

constexpr std::size_t kStrokeAtOnce = 2000; // longer paths cost memory, shorter ones size

/// What is free, in cells: exact outlines where the geometry library is there, else the rectangles
/// themselves.
std::vector<Outline> freeSpace(const std::vector<Rectangle> &rectangles)
{
#ifdef MRPP_HAS_GEOMETRY
    return outlinesOf(rectangles);
#else
    std::vector<Outline> outlines;
    for (const Rectangle &r : rectangles)
        outlines.push_back(
            {{{r.left, r.bottom, 0}, {r.right, r.bottom, 0}, {r.right, r.top, 0}, {r.left, r.top, 0}}, {}});
    return outlines;
#endif
}

} // namespace

MapGround::MapGround(const Graph &graph, const Placement &placement)
    : graph_(graph), placement_(placement), isGrid_(areEdgesUnits())
{
    if (isGrid_)
        free_ = freeSpace(rows([](Vertex) { return true; }));
}

Extent MapGround::size() const
{
    const Extent extent = extentOf(placement_);
    return {extent.width / placement_.spacing + 1, extent.height / placement_.spacing + 1};
}

Point MapGround::at(Vertex v, const MapArea &area) const
{
    const double scale = area.unit / placement_.spacing;
    return {area.left + area.unit / 2 + placement_.positions[v].x * scale,
            area.bottom - area.unit / 2 - placement_.positions[v].y * scale, 0};
}

void MapGround::draw(cairo_t *cairo, const MapArea &area) const
{
    if (!isGrid_)
    {
        cairo_set_source_rgb(cairo, 0.7, 0.7, 0.7);
        cairo_set_line_width(cairo, std::min(0.8, area.unit / 6));
        std::size_t lines = 0;
        for (const Graph::Edge &edge : graph_.edges())
        {
            const Point from = at(edge.a, area);
            const Point to = at(edge.b, area);
            cairo_move_to(cairo, from.x, from.y);
            cairo_line_to(cairo, to.x, to.y);
            if (++lines % kStrokeAtOnce == 0)
                cairo_stroke(cairo);
        }
        cairo_stroke(cairo);
        return;
    }
    const Extent cells = size();
    cairo_set_source_rgb(cairo, 0.6, 0.6, 0.6);
    cairo_rectangle(cairo, area.left, area.bottom - cells.height * area.unit, cells.width * area.unit,
                    cells.height * area.unit);
    cairo_fill(cairo);
    cairo_set_source_rgb(cairo, 0.97, 0.97, 0.97);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    const auto follow = [&](const std::vector<Point> &corners)
    {
        for (const Point &corner : corners)
            cairo_line_to(cairo, area.left + corner.x * area.unit, area.bottom - corner.y * area.unit);
        cairo_close_path(cairo);
        cairo_new_sub_path(cairo);
    };
    for (const Outline &outline : free_)
    {
        follow(outline.boundary);
        for (const std::vector<Point> &hole : outline.holes)
            follow(hole);
        cairo_fill(cairo);
    }
}

void MapGround::fill(cairo_t *cairo, const MapArea &area, const std::function<bool(Vertex)> &isWanted) const
{
    std::size_t shapes = 0;
    const auto filled = [&]
    {
        if (++shapes % kStrokeAtOnce == 0)
            cairo_fill(cairo);
    };
    if (isGrid_)
        for (const Rectangle &r : rows(isWanted))
        {
            cairo_rectangle(cairo, area.left + r.left * area.unit, area.bottom - r.top * area.unit,
                            (r.right - r.left) * area.unit, area.unit);
            filled();
        }
    else
        for (Vertex v = 0; v < graph_.vertexCount(); ++v)
            if (isWanted(v))
            {
                const Point place = at(v, area);
                cairo_new_sub_path(cairo);
                cairo_arc(cairo, place.x, place.y, std::max(0.35 * area.unit, 0.8), 0, 2 * std::numbers::pi);
                filled();
            }
    cairo_fill(cairo);
}

bool MapGround::areEdgesUnits() const
{
    constexpr double kTolerance = 1e-6;
    const double unit = placement_.spacing;
    for (const Graph::Edge &edge : graph_.edges())
    {
        const double dx = std::abs(placement_.positions[edge.a].x - placement_.positions[edge.b].x);
        const double dy = std::abs(placement_.positions[edge.a].y - placement_.positions[edge.b].y);
        if (std::min(dx, dy) > kTolerance * unit || std::abs(std::max(dx, dy) - unit) > kTolerance * unit)
            return false;
    }
    return true;
}

/// Rectangles of cells side by side, in cells from the bottom left.
std::vector<Rectangle> MapGround::rows(const std::function<bool(Vertex)> &isWanted) const
{
    std::vector<std::pair<double, double>> cells;
    for (Vertex v = 0; v < graph_.vertexCount(); ++v)
        if (isWanted(v))
            cells.emplace_back(std::round(placement_.positions[v].y / placement_.spacing),
                               std::round(placement_.positions[v].x / placement_.spacing));
    std::sort(cells.begin(), cells.end());
    std::vector<Rectangle> rectangles;
    for (const auto &[row, column] : cells)
        if (!rectangles.empty() && rectangles.back().bottom == row && rectangles.back().right == column)
            rectangles.back().right = column + 1;
        else
            rectangles.push_back({column, row, column + 1, row + 1});
    return rectangles;
}

} // namespace mrpp
