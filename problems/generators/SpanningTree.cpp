#include "problems/generators/SpanningTree.h"

#include <algorithm>
#include <numeric>

namespace mrpp
{

std::vector<Graph::Edge> gridEdges(std::size_t width, std::size_t height)
{
    std::vector<Graph::Edge> edges;
    edges.reserve(2 * width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
        {
            const auto cell = static_cast<Vertex>(y * width + x);
            if (x + 1 < width)
                edges.push_back({cell, cell + 1});
            if (y + 1 < height)
                edges.push_back({cell, cell + static_cast<Vertex>(width)});
        }
    return edges;
}

std::size_t moveSpanningTreeFirst(std::vector<Graph::Edge> &edges, std::size_t vertices, Random &random)
{
    random.shuffle(std::span(edges));
    std::vector<Vertex> parent(vertices);
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&parent](Vertex v)
    {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    const auto rest = std::stable_partition(edges.begin(), edges.end(),
                                            [&](const Graph::Edge &edge)
                                            {
                                                const Vertex a = find(edge.a);
                                                const Vertex b = find(edge.b);
                                                parent[std::max(a, b)] = std::min(a, b);
                                                return a != b;
                                            });
    return static_cast<std::size_t>(rest - edges.begin());
}

} // namespace mrpp
