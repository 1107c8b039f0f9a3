#include "problems/generators/Roadmap.h"

#ifdef MRPP_WITH_CGAL
#include "framework/geometry/Delaunay.h"
#endif
#include "framework/support/Error.h"
#include "problems/generators/SpanningTree.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

#ifdef MRPP_WITH_CGAL

namespace
{

/// Distinct random points of a square as large as `count` cells, to a thousandth.
std::vector<Point> randomPoints(std::size_t count, Random &random)
{
    constexpr std::uint64_t kUnit = 1000;
    const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count)))) * kUnit;
    std::vector<std::uint64_t> places;
    while (places.size() < count)
    {
        for (std::size_t missing = count - places.size(); missing > 0; --missing)
            places.push_back(random.below(side * side));
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
    }
    random.shuffle(std::span(places));
    std::vector<Point> points;
    points.reserve(count);
    for (const std::uint64_t place : places)
    {
        const std::uint64_t column = place % side;
        const std::uint64_t row = place / side;
        points.push_back({static_cast<double>(column) / kUnit, static_cast<double>(row) / kUnit, 0});
    }
    return points;
}

} // namespace

std::string Roadmap::missing() const
{
    return {};
}

std::shared_ptr<const Graph> Roadmap::makeGraph(Seed seed) const
{
    Random random(seed);
    const auto vertices = static_cast<std::size_t>(vertices_);
    std::vector<Point> points = randomPoints(vertices, random);
    auto edges = delaunayEdges(points);
    const std::size_t needed = moveSpanningTreeFirst(edges, vertices, random);
    const auto wanted = static_cast<std::size_t>(std::round(meanDegree_ * static_cast<double>(vertices) / 2));
    edges.resize(std::clamp(wanted, needed, edges.size())); // behind the tree, the edges are in random order
    return Graph::fromEdges(vertices, edges, std::move(points));
}

#else

std::string Roadmap::missing() const
{
    return "planar roadmaps need CGAL, and this mrppsim was built without it; build it with "
           "-DMRPP_WITH_CGAL=ON";
}

std::shared_ptr<const Graph> Roadmap::makeGraph(Seed) const
{
    throw InputError(missing());
}

#endif

Roadmap::Roadmap()
{
    declareParam("vertices", vertices_, "1:10000000", "how many vertices");
    declareParam("mean_degree", meanDegree_, "0:6",
                 "edges · 2 / vertices; kept between a tree and the whole triangulation");
}

} // namespace mrpp
