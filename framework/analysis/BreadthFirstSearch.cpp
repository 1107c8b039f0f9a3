#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

BreadthFirstSearch::BreadthFirstSearch(const Graph &graph)
    : graph_(&graph), stamps_(graph.vertexCount(), 0), distances_(graph.vertexCount()),
      queue_(graph.vertexCount())
{}

void BreadthFirstSearch::run(Vertex source, Vertex target)
{
    assert(source < graph_->vertexCount());
    if (++epoch_ == 0)
    {
        std::fill(stamps_.begin(), stamps_.end(), 0);
        epoch_ = 1;
    }
    reachedCount_ = 0;
    const auto reach = [this](Vertex v, std::uint32_t distance)
    {
        stamps_[v] = epoch_;
        distances_[v] = distance;
        queue_[reachedCount_++] = v;
    };
    reach(source, 0);
    if (source == target)
        return;
    for (std::size_t head = 0; head < reachedCount_; ++head)
    {
        const Vertex v = queue_[head];
        for (const Vertex w : graph_->neighbors(v))
        {
            if (stamps_[w] == epoch_)
                continue;
            reach(w, distances_[v] + 1);
            if (w == target)
                return;
        }
    }
}

std::vector<Vertex> BreadthFirstSearch::path(Vertex v) const
{
    assert(reached(v));
    std::vector<Vertex> vertices(distances_[v] + 1);
    for (std::size_t i = vertices.size() - 1; i > 0; --i)
    {
        vertices[i] = v;
        for (const Vertex w : graph_->neighbors(v))
        {
            if (stamps_[w] == epoch_ && distances_[w] + 1 == i)
            {
                v = w;
                break;
            }
        }
    }
    vertices.front() = v;
    return vertices;
}

} // namespace mrpp
