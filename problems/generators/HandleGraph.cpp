#include "problems/generators/HandleGraph.h"

#include <cassert>

namespace mrpp
{

HandleGraph::HandleGraph(std::size_t size) : vertexCount_(size)
{
    assert(size >= 3);
    for (std::size_t v = 0; v < size; ++v)
        edges_.push_back({static_cast<Vertex>(v), static_cast<Vertex>((v + 1) % size)});
}

void HandleGraph::addHandle(Vertex x, Vertex y, std::size_t inner)
{
    assert(x != y && inner >= 1 && x < vertexCount() && y < vertexCount());
    Vertex last = x;
    for (std::size_t i = 0; i < inner; ++i)
    {
        const auto next = static_cast<Vertex>(vertexCount_++);
        edges_.push_back({last, next});
        last = next;
    }
    edges_.push_back({last, y});
}

void HandleGraph::addRandomHandle(std::size_t inner, Random &random)
{
    const auto x = static_cast<Vertex>(random.below(vertexCount()));
    auto y = static_cast<Vertex>(random.below(vertexCount()));
    if (x == y)
        y = x == 0 ? 1 : x - 1;
    addHandle(x, y, inner);
}

} // namespace mrpp
