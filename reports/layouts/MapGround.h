#pragma once
/// \file
/// What lies beneath the robots of a large graph's picture, drawn with cairo: of a grid the exact outlines of
/// what is free, polygons with holes on a dark ground; of any other graph its edges.

#include "framework/geometry/Outline.h"
#include "framework/model/Graph.h"
#include "reports/layouts/Placement.h"

#include <cairo.h>
#include <functional>
#include <vector>

namespace mrpp
{

/// Where a ground is drawn.
struct MapArea
{
    double left = 0;   ///< points from the left
    double bottom = 0; ///< points from the top
    double unit = 1;   ///< points between neighbours
};

class MapGround
{
public:
    /// \pre both outlive it. O(V log V + E).
    MapGround(const Graph &graph, const Placement &placement);

    /// Whether every edge goes along an axis and is as long as all others: then vertices are cells.
    [[nodiscard]] bool isGrid() const { return isGrid_; }

    /// In units, cells included.
    [[nodiscard]] Extent size() const;

    [[nodiscard]] Point at(Vertex v, const MapArea &area) const;

    void draw(cairo_t *cairo, const MapArea &area) const;

    /// Fills the cells (of other graphs: discs on the vertices) that are wanted, in the present colour.
    void fill(cairo_t *cairo, const MapArea &area, const std::function<bool(Vertex)> &isWanted) const;

private:
    const Graph &graph_;
    const Placement &placement_;
    bool isGrid_;
    std::vector<Outline> free_; ///< of a grid, in cells

    [[nodiscard]] bool areEdgesUnits() const;
    [[nodiscard]] std::vector<Rectangle> rows(const std::function<bool(Vertex)> &isWanted) const;
};

} // namespace mrpp
