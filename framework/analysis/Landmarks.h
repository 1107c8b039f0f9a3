#pragma once
/// \file
/// Lower bounds on distances from a few landmarks: by the triangle inequality |d(l,v) − d(l,t)| ≤ d(v,t) for
/// every landmark l. They make A* fast on any graph, with or without coordinates.
///
/// Source: A. V. Goldberg, C. Harrelson, "Computing the shortest path: A* search meets graph theory", SODA
/// 2005.

#include "framework/model/Graph.h"
#include "framework/support/TerminationCondition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrpp
{

class Landmarks
{
public:
    static constexpr std::size_t kCount = 16;

    /// Picks landmarks one after another, each farthest from those before, and searches from each once.
    /// Memory 32 bytes a vertex, time kCount breadth-first searches.
    explicit Landmarks(const Graph &graph, const TerminationCondition &ptc = {});

    /// At most the number of edges between v and t; 0 says nothing. O(kCount).
    [[nodiscard]] std::uint32_t lowerBound(Vertex v, Vertex t) const
    {
        const std::uint16_t *a = distances_.data() + std::size_t{v} * kCount;
        const std::uint16_t *b = distances_.data() + std::size_t{t} * kCount;
        std::uint16_t best = 0;
        for (std::size_t i = 0; i < kCount; ++i)
        {
            const auto difference = static_cast<std::uint16_t>(a[i] > b[i] ? a[i] - b[i] : b[i] - a[i]);
            best = difference > best ? difference : best;
        }
        return best;
    }

    /// The largest distance from v to a landmark (at most 65535): small in the middle of the graph.
    [[nodiscard]] std::uint32_t eccentricity(Vertex v) const;

private:
    /// distances_[v * kCount + l], cut off at 65535, which keeps the bounds true.
    std::vector<std::uint16_t> distances_;
};

} // namespace mrpp
