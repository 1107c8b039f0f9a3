#include "problems/generators/Drawing.h"

#include "framework/analysis/BreadthFirstSearch.h"

#include <cmath>
#include <numbers>

namespace mrpp
{

Point drawnPoint(double x, double y)
{
    constexpr double kUnit = 1000;
    return {std::round(x * kUnit) / kUnit + 0.0, std::round(y * kUnit) / kUnit + 0.0, 0}; // + 0.0: never −0
}

std::vector<Point> circle(std::size_t size)
{
    const double step = 2 * std::numbers::pi / static_cast<double>(size);
    const double radius = size < 2 ? 0 : 0.5 / std::sin(step / 2);
    std::vector<Point> points;
    points.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
    {
        const double angle = step * static_cast<double>(i);
        points.push_back(drawnPoint(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return points;
}

std::vector<Point> radialDrawing(const Graph &graph, Vertex root)
{
    BreadthFirstSearch search(graph);
    search.run(root);
    const auto order = search.order();

    // The tree: the parent is the smallest neighbour that is nearer to the root.
    std::vector<Vertex> parent(graph.vertexCount(), kNoVertex);
    for (const Vertex v : order)
        for (const Vertex u : graph.neighbors(v))
            if (parent[v] == kNoVertex && search.distance(u) < search.distance(v))
                parent[v] = u;
    std::vector<double> leaves(graph.vertexCount(), 0);
    for (auto v = order.rbegin(); v != order.rend(); ++v)
    {
        if (leaves[*v] == 0)
            leaves[*v] = 1;
        if (parent[*v] != kNoVertex)
            leaves[parent[*v]] += leaves[*v];
    }

    // Sectors in turns (1 is the whole circle), handed out to the children one after another.
    std::vector<double> next(graph.vertexCount(), 0);
    std::vector<Point> points(graph.vertexCount());
    for (const Vertex v : order)
    {
        double middle = 0;
        if (parent[v] != kNoVertex)
        {
            const double width = leaves[v] / leaves[root];
            const double begin = next[parent[v]];
            next[parent[v]] += width;
            next[v] = begin;
            middle = begin + width / 2;
        }
        const double angle = 2 * std::numbers::pi * middle;
        const double radius = search.distance(v);
        points[v] = drawnPoint(radius * std::cos(angle), radius * std::sin(angle));
    }
    return points;
}

Vertex middleVertex(const Graph &graph)
{
    BreadthFirstSearch search(graph);
    search.run(0);
    search.run(search.order().back());
    const auto path = search.path(search.order().back());
    return path[path.size() / 2];
}

std::shared_ptr<const Graph> drawnGraph(std::size_t vertexCount, std::span<const Graph::Edge> edges)
{
    const auto plain = Graph::fromEdges(vertexCount, edges);
    return Graph::fromEdges(vertexCount, edges, radialDrawing(*plain, middleVertex(*plain)));
}

} // namespace mrpp
