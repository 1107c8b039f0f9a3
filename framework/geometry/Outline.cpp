#include "framework/geometry/Outline.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <iterator>
#include <list>

namespace mrpp
{

namespace
{

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

std::vector<Point> cornersOf(const Polygon &polygon)
{
    std::vector<Point> corners;
    const std::size_t size = polygon.size();
    for (std::size_t i = 0; i < size; ++i)
    {
        const auto &before = polygon[(i + size - 1) % size];
        const auto &here = polygon[i];
        if (!CGAL::collinear(before, here, polygon[(i + 1) % size]))
            corners.push_back({CGAL::to_double(here.x()), CGAL::to_double(here.y()), 0});
    }
    return corners;
}

} // namespace

std::vector<Outline> outlinesOf(std::span<const Rectangle> rectangles)
{
    std::vector<Polygon> parts;
    for (const Rectangle &r : rectangles)
    {
        Polygon &part = parts.emplace_back();
        part.push_back({r.left, r.bottom});
        part.push_back({r.right, r.bottom});
        part.push_back({r.right, r.top});
        part.push_back({r.left, r.top});
    }
    CGAL::Polygon_set_2<Kernel> area;
    area.join(parts.begin(), parts.end());
    std::list<PolygonWithHoles> pieces;
    area.polygons_with_holes(std::back_inserter(pieces));
    std::vector<Outline> outlines;
    for (const PolygonWithHoles &piece : pieces)
    {
        Outline &outline = outlines.emplace_back();
        outline.boundary = cornersOf(piece.outer_boundary());
        for (auto hole = piece.holes_begin(); hole != piece.holes_end(); ++hole)
            outline.holes.push_back(cornersOf(*hole));
    }
    return outlines;
}

} // namespace mrpp
