#pragma once
/// \file
/// Planar roadmaps: random points of a square, joined by some edges of their Delaunay triangulation. Built
/// without CGAL (MRPP_WITH_CGAL, see framework/geometry/Delaunay.h), the family says so and is refused.
///
/// \code
/// - roadmap: {vertices: 1000, mean_degree: 3, robots: 50}
/// \endcode
///
/// Promises: connected; planar, also as it is drawn; vertices · mean_degree / 2 edges, rounded, at least what
/// connects the graph and at most what the triangulation has (a mean degree just below 6). The edges kept are
/// a random spanning tree of the triangulation (SpanningTree.h) and a uniformly random choice of the others.
/// Vertices are numbered as they are drawn. O(V log V) expected.

#include "problems/generators/Generator.h"

namespace mrpp
{

class Roadmap : public Generator
{
public:
    Roadmap();

    [[nodiscard]] std::string name() const override { return "roadmap " + std::to_string(vertices_); }
    [[nodiscard]] std::string missing() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

private:
    std::int64_t vertices_ = 100;
    double meanDegree_ = 3;
};

} // namespace mrpp
