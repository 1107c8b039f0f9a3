#include "framework/geometry/Delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace mrpp
{

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Vertex, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
} // namespace

std::vector<Graph::Edge> delaunayEdges(std::span<const Point> points)
{
    std::vector<std::pair<Kernel::Point_2, Vertex>> sites;
    sites.reserve(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
        sites.emplace_back(Kernel::Point_2(points[v].x, points[v].y), static_cast<Vertex>(v));
    Triangulation triangulation;
    triangulation.insert(sites.begin(), sites.end());

    std::vector<Graph::Edge> edges;
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge)
    {
        const Vertex a = edge->first->vertex(Triangulation::cw(edge->second))->info();
        const Vertex b = edge->first->vertex(Triangulation::ccw(edge->second))->info();
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(edges.begin(), edges.end(),
              [](const Graph::Edge &x, const Graph::Edge &y)
              { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
    return edges;
}

} // namespace mrpp
