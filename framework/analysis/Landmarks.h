#pragma once
/// \file
/// Lower bounds on distances from a few landmarks: by the triangle inequality |d(l,v) − d(l,t)| ≤ d(v,t) for
/// every landmark l. They make A* fast on any graph, with or without coordinates, and bounds for many robots
/// cheap. They also see the middle of a graph.
///
/// Each component has landmarks of its own: nothing here depends on what else there is in the graph.
///
/// \code
/// const Landmarks landmarks(*graph);
/// if (landmarks.lowerBound(start, goal) > limit)
///     …
/// \endcode
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
    /// Of each component, or as many as it has vertices.
    static constexpr std::size_t kCount = 16;

    /// Picks the landmarks of each component one after another, each farthest from those before, and searches
    /// from each once. Memory 32 bytes a vertex, time kCount breadth-first searches of the graph.
    /// \param ptc where it says stop, the other landmarks are left out, and the bounds know less
    explicit Landmarks(const Graph &graph, const TerminationCondition &ptc = {});

    /// At most the number of edges between v and t; 0 says nothing, and where there is no path any number
    /// does not either. Consistent: seen from two neighbours, the bounds to t differ by at most one.
    /// O(kCount).
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

    /// The middle of each component, ordered by the components' smallest vertices: the vertex that is nearest
    /// to the landmark that is farthest from it (its *eccentricity*, as far as the landmarks see); one of
    /// degree three or more where there is such.
    [[nodiscard]] std::span<const Vertex> centers() const { return centers_; }

private:
    /// distances_[v * kCount + l], of the l-th landmark of v's component, cut off at 65535, which keeps the
    /// bounds true and consistent; 0 where the component has fewer landmarks.
    std::vector<std::uint16_t> distances_;
    std::vector<Vertex> centers_;
};

} // namespace mrpp
