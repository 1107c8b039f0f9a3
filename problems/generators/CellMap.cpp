#include "problems/generators/CellMap.h"

namespace mrpp
{

std::shared_ptr<const Graph> CellMap::graph() const
{
    std::vector<Vertex> above(width_,
                              kNoVertex); ///< the last vertex of each column, if it is in the row above
    std::vector<Graph::Edge> edges;
    std::vector<Point> points;
    for (std::size_t y = 0; y < height(); ++y)
    {
        Vertex left = kNoVertex;
        for (std::size_t x = 0; x < width_; ++x)
        {
            Vertex here = kNoVertex;
            if (isFree(x, y))
            {
                here = static_cast<Vertex>(points.size());
                points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
                if (left != kNoVertex)
                    edges.push_back({left, here});
                if (above[x] != kNoVertex)
                    edges.push_back({above[x], here});
            }
            left = above[x] = here;
        }
    }
    const std::size_t vertices = points.size(); // before the points are moved away
    return Graph::fromEdges(vertices, edges, std::move(points), YAxis::down);
}

} // namespace mrpp
