#include "algorithms/search/Landmarks.h"

#include <algorithm>
#include <limits>

namespace mrpp
{

Landmarks::Landmarks(const Graph &graph) : distances_(graph.vertexCount() * kCount, 0)
{
    if (graph.vertexCount() == 0)
        return;
    constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();
    constexpr std::uint32_t kCutOff = std::numeric_limits<std::uint16_t>::max();
    std::vector<std::uint32_t> distance(graph.vertexCount());
    std::vector<std::uint32_t> nearest(graph.vertexCount(), kFar); // to the landmarks so far
    std::vector<Vertex> queue;
    const auto search = [&](Vertex root)
    {
        std::fill(distance.begin(), distance.end(), kFar);
        queue.assign(1, root);
        distance[root] = 0;
        for (std::size_t head = 0; head < queue.size(); ++head)
        {
            const Vertex v = queue[head];
            for (const Vertex w : graph.neighbors(v))
            {
                if (distance[w] == kFar)
                {
                    distance[w] = distance[v] + 1;
                    queue.push_back(w);
                }
            }
        }
    };

    search(0);
    Vertex landmark = queue.back();
    for (std::size_t l = 0; l < kCount; ++l)
    {
        search(landmark);
        for (Vertex v = 0; v < graph.vertexCount(); ++v)
        {
            distances_[std::size_t{v} * kCount + l] =
                static_cast<std::uint16_t>(std::min(distance[v], kCutOff));
            nearest[v] = std::min(nearest[v], distance[v]);
        }
        // A vertex of another component is infinitely far: every component gets a landmark while there are
        // any.
        landmark = static_cast<Vertex>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    }
}

std::uint32_t Landmarks::eccentricity(Vertex v) const
{
    const auto row = distances_.begin() + static_cast<std::ptrdiff_t>(v * kCount);
    return *std::max_element(row, row + kCount);
}

} // namespace mrpp
