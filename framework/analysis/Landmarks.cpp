#include "framework/analysis/Landmarks.h"

#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/Components.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace mrpp
{

namespace
{

/// The vertices of one component after another, ascending within each.
std::vector<Vertex> componentwise(const Components &components, std::size_t vertexCount)
{
    std::vector<std::size_t> next(components.count(), 0);
    for (std::uint32_t c = 1; c < components.count(); ++c)
        next[c] = next[c - 1] + components.size(c - 1);
    std::vector<Vertex> vertices(vertexCount);
    for (Vertex v = 0; v < vertexCount; ++v)
        vertices[next[components.of(v)]++] = v;
    return vertices;
}

} // namespace

Landmarks::Landmarks(const Graph &graph, const TerminationCondition &ptc)
    : distances_(graph.vertexCount() * kCount, 0)
{
    constexpr std::uint32_t kCutOff = std::numeric_limits<std::uint16_t>::max();
    const Components components(graph);
    const std::vector<Vertex> vertices = componentwise(components, graph.vertexCount());
    BreadthFirstSearch search(graph);
    std::vector<std::uint32_t> nearest(graph.vertexCount(), kUnreachable); // to the landmarks so far
    std::vector<std::uint32_t> eccentricities(graph.vertexCount(), 0);
    const auto moreCentral = [&](Vertex a, Vertex b)
    {
        return std::pair(graph.degree(a) < 3, eccentricities[a]) <
               std::pair(graph.degree(b) < 3, eccentricities[b]);
    };
    auto end = vertices.begin();
    for (std::uint32_t c = 0; c < components.count(); ++c)
    {
        const auto begin = std::exchange(end, end + static_cast<std::ptrdiff_t>(components.size(c)));
        Vertex landmark = *begin;
        for (std::size_t l = 0; l < kCount && nearest[landmark] > 0 && end - begin > 1 && !ptc(); ++l)
        {
            search.run(landmark);
            landmark = *begin;
            for (auto v = begin; v != end; ++v)
            {
                const std::uint32_t distance = search.distance(*v);
                distances_[std::size_t{*v} * kCount + l] =
                    static_cast<std::uint16_t>(std::min(distance, kCutOff));
                eccentricities[*v] = std::max(eccentricities[*v], distance);
                nearest[*v] = std::min(nearest[*v], distance);
                landmark = nearest[*v] > nearest[landmark] ? *v : landmark;
            }
        }
        centers_.push_back(*std::min_element(begin, end, moreCentral));
    }
}

} // namespace mrpp
