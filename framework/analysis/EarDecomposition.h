#pragma once
/// \file
/// Open ear decompositions: a biconnected graph as a first cycle to which *handles* (ears) are added one
/// after another, each a path x – w1 – … – wl – y between two different vertices that are there already,
/// whose *interior* w1 … wl is new. Edges that would be handles without an interior are left out, so that the
/// vertices are shared out among the cycle and the handles.
///
/// \code
/// const EarDecomposition ears(graph, shortCycle(graph));
/// for (std::size_t i = ears.handleCount(); i-- > 0;)  // before handle i there are only vertices of level ≤
/// i
///     fill(ears.handle(i));
/// \endcode
///
/// What there is before each handle is biconnected, or the cycle. A graph has many decompositions; `Growth`
/// says which kind is made:
///
/// - `shortest`: every time the shortest handle that there is, of several the one that was found first, so
///   that the graph grows like a ball around the cycle. A search from everything that is there already, kept
///   up to date; near-linear where short handles are near (a grid of 10^5 vertices: some 50 ms).
/// - `depthFirst`: the chains of J. M. Schmidt, "A simple test on 2-vertex- and 2-edge-connectivity",
///   Information Processing Letters 113(7), 2013. O(V + E), but with handles as long as depth-first search
///   makes them.

#include "framework/model/Graph.h"
#include "framework/support/Random.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

class EarDecomposition
{
public:
    enum class Growth
    {
        shortest,
        depthFirst
    };

    /// \param cycle three or more vertices, each next to its successor, the last one to the first
    /// \param shuffle where given, ties are broken by chance
    /// \pre the graph is biconnected (one block of three or more vertices, and nothing beside it)
    EarDecomposition(const Graph &graph, std::span<const Vertex> cycle, Growth growth = Growth::shortest,
                     std::optional<Seed> shuffle = std::nullopt);

    [[nodiscard]] std::span<const Vertex> cycle() const { return path(0); }
    [[nodiscard]] std::size_t handleCount() const { return offsets_.size() - 2; }

    /// x, w1, …, wl, y; l ≥ 1.
    [[nodiscard]] std::span<const Vertex> handle(std::size_t i) const { return path(i + 1); }
    /// w1, …, wl.
    [[nodiscard]] std::span<const Vertex> interior(std::size_t i) const
    {
        return handle(i).subspan(1, handle(i).size() - 2);
    }

    /// When a vertex is added: 0 on the cycle, i + 1 in the interior of handle i.
    [[nodiscard]] std::uint32_t level(Vertex v) const { return levels_[v]; }

private:
    static constexpr std::uint32_t kNew = static_cast<std::uint32_t>(-1);

    [[nodiscard]] std::span<const Vertex> path(std::size_t i) const
    {
        return {paths_.data() + offsets_[i], paths_.data() + offsets_[i + 1]};
    }
    [[nodiscard]] bool isNew(Vertex v) const { return levels_[v] == kNew; }
    void add(std::span<const Vertex> path);
    void growDepthFirst(const Graph &graph, Random *random);
    void growShortest(const Graph &graph, Random *random);

    std::vector<std::size_t> offsets_ = {0};
    std::vector<Vertex> paths_; ///< the cycle, then the handles with their ends
    std::vector<std::uint32_t> levels_;
};

/// A shortest cycle through v; empty where there is none. O(V + E), less where it is short.
[[nodiscard]] std::vector<Vertex> shortestCycleThrough(const Graph &graph, Vertex v);

/// A shortest cycle, or the shortest that was found in the time of some thirty searches of the whole graph;
/// of several, the one through the smallest vertex. Empty in a forest. O(V + E).
[[nodiscard]] std::vector<Vertex> shortCycle(const Graph &graph);

} // namespace mrpp
