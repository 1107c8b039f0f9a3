#include "framework/analysis/Landmarks.h"

#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>
#include <limits>

namespace mrpp
{

Landmarks::Landmarks(const Graph &graph, const TerminationCondition &ptc)
    : distances_(graph.vertexCount() * kCount, 0)
{
    if (graph.vertexCount() == 0)
        return;
    constexpr std::uint32_t kCutOff = std::numeric_limits<std::uint16_t>::max();
    BreadthFirstSearch search(graph);
    std::vector<std::uint32_t> nearest(graph.vertexCount(), kUnreachable); // to the landmarks so far
    search.run(0);
    Vertex landmark = search.order().back();
    for (std::size_t l = 0; l < kCount && !ptc(); ++l)
    {
        search.run(landmark);
        for (Vertex v = 0; v < graph.vertexCount(); ++v)
        {
            distances_[std::size_t{v} * kCount + l] =
                static_cast<std::uint16_t>(std::min(search.distance(v), kCutOff));
            nearest[v] = std::min(nearest[v], search.distance(v));
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
