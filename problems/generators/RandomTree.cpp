#include "problems/generators/RandomTree.h"

namespace mrpp
{

std::vector<Graph::Edge> uniformTree(std::size_t vertices, Random &random)
{
    std::vector<Graph::Edge> edges;
    if (vertices < 2)
        return edges;
    edges.reserve(vertices - 1);
    std::vector<Vertex> sequence(vertices - 2);
    std::vector<std::uint32_t> degree(vertices, 1);
    for (Vertex &v : sequence)
    {
        v = static_cast<Vertex>(random.below(vertices));
        ++degree[v];
    }
    // The smallest leaf is joined to the sequence's next vertex; `scan` has passed all leaves below it but
    // the one that the last step may have made.
    Vertex scan = 0;
    while (degree[scan] != 1)
        ++scan;
    Vertex leaf = scan;
    for (const Vertex v : sequence)
    {
        edges.push_back({leaf, v});
        if (--degree[v] == 1 && v < scan)
        {
            leaf = v;
            continue;
        }
        do
            ++scan;
        while (degree[scan] != 1);
        leaf = scan;
    }
    edges.push_back({leaf, static_cast<Vertex>(vertices - 1)});
    return edges;
}

std::vector<Graph::Edge> recursiveTree(std::size_t vertices, Random &random)
{
    std::vector<Graph::Edge> edges;
    edges.reserve(vertices);
    for (std::size_t v = 1; v < vertices; ++v)
        edges.push_back({static_cast<Vertex>(random.below(v)), static_cast<Vertex>(v)});
    return edges;
}

} // namespace mrpp
