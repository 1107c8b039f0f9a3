#pragma once
/// \file
/// Outlines of areas that are put together from rectangles, by CGAL with exact arithmetic: islands, holes and
/// corners that only touch come out as they are. In the library mrpp::geometry, which is built with
/// MRPP_WITH_CGAL.

#include "framework/model/Graph.h"

#include <span>
#include <vector>

namespace mrpp
{

struct Rectangle
{
    double left = 0;
    double bottom = 0;
    double right = 0;
    double top = 0;
};

/// A connected area: its outer boundary counterclockwise, those of its holes clockwise; no three points in a
/// row lie on one line.
struct Outline
{
    std::vector<Point> boundary;
    std::vector<std::vector<Point>> holes;
};

/// The union of the rectangles. \pre left < right, bottom < top. O((n + k) log n) for n rectangles whose
/// edges meet k times.
[[nodiscard]] std::vector<Outline> outlinesOf(std::span<const Rectangle> rectangles);

} // namespace mrpp
