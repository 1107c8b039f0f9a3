#pragma once
/// \file
/// Distances from a vertex, over and over on one graph: arrays are stamped, never cleared, so that a search
/// costs what it touches.
///
/// \code
/// BreadthFirstSearch search(*graph);
/// for (Vertex goal : goals)
/// {
///     search.run(goal);
///     use(search.distance(start));
/// }
/// \endcode

#include "framework/model/Graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrpp
{

/// The distance to a vertex that no path leads to.
inline constexpr std::uint32_t kUnreachable = static_cast<std::uint32_t>(-1);

/// Holds 12 bytes a vertex. Not for several threads at once; the graph must outlive it.
class BreadthFirstSearch
{
public:
    /// O(V).
    explicit BreadthFirstSearch(const Graph &graph);

    /// Visits everything that can be reached from the source. O(V + E).
    void run(Vertex source) { run(source, kNoVertex); }

    /// Stops as soon as `target` is reached; vertices that are farther away may then seem unreachable.
    void run(Vertex source, Vertex target);

    /// Edges on a shortest path from the last run's source, or kUnreachable.
    [[nodiscard]] std::uint32_t distance(Vertex v) const
    {
        return stamps_[v] == epoch_ ? distances_[v] : kUnreachable;
    }
    [[nodiscard]] bool reached(Vertex v) const { return stamps_[v] == epoch_; }

    /// The vertices that were reached, nearest first; those of equal distance in an order that depends on
    /// the graph alone.
    [[nodiscard]] std::span<const Vertex> order() const { return {queue_.data(), reachedCount_}; }

    /// The shortest path from the source to `v`, both included, that goes to the smallest vertex where it has
    /// a choice, seen from `v`. \pre reached(v). O(its length · degree).
    [[nodiscard]] std::vector<Vertex> path(Vertex v) const;

private:
    const Graph *graph_;
    std::uint32_t epoch_ = 0;
    std::size_t reachedCount_ = 0;
    std::vector<std::uint32_t> stamps_;    ///< equal to epoch_ where the last run came
    std::vector<std::uint32_t> distances_; ///< valid where stamped
    std::vector<Vertex> queue_;
};

} // namespace mrpp
