#pragma once
/// \file
/// Exact distances between many pairs of vertices of one graph, each by a search of its own that visits few
/// vertices: two balls that meet half-way, which is good where a few edges lead everywhere, or A* with
/// landmark bounds, which is good on maps. Both count the vertices that they visit.
///
/// \code
/// LandmarkSearch search(*graph, landmarks);
/// for (Robot r = 0; r < robots; ++r)
///     sum += search.distance(starts[r], goals[r]);
/// \endcode

#include "framework/analysis/Landmarks.h"
#include "framework/model/Graph.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace mrpp
{

/// Breadth-first searches from both ends: each time the one with fewer vertices on its rim grows by a whole
/// level. Holds 4 bytes a vertex; the graph must outlive it.
class BidirectionalSearch
{
public:
    explicit BidirectionalSearch(const Graph &graph) : graph_(&graph), owner_(graph.vertexCount(), 0) {}

    /// Edges on a shortest path, or kUnreachable. O(V + E).
    [[nodiscard]] std::uint32_t distance(Vertex a, Vertex b);

    /// Vertices visited in all searches so far.
    [[nodiscard]] std::uint64_t visits() const { return visits_; }

private:
    void nextQuery();
    bool grow(std::vector<Vertex> &rim, std::uint32_t own, std::uint32_t other);

    const Graph *graph_;
    std::vector<std::uint32_t> owner_; ///< markA_ in the ball of a, markA_ + 1 in that of b, less elsewhere
    std::uint32_t markA_ = 0;
    std::vector<Vertex> rimA_;
    std::vector<Vertex> rimB_;
    std::vector<Vertex> next_;
    std::uint64_t visits_ = 0;
};

/// A* with the landmarks' bounds, which are consistent: no vertex is visited twice. Holds 8 bytes a vertex;
/// graph and landmarks must outlive it.
class LandmarkSearch
{
public:
    LandmarkSearch(const Graph &graph, const Landmarks &landmarks)
        : graph_(&graph), landmarks_(&landmarks), labels_(graph.vertexCount())
    {}

    /// Edges on a shortest path, or kUnreachable. O(16 (V + E)).
    [[nodiscard]] std::uint32_t distance(Vertex from, Vertex to);

    /// Vertices visited in all searches so far.
    [[nodiscard]] std::uint64_t visits() const { return visits_; }

private:
    struct Label
    {
        std::uint32_t distance = 0;
        std::uint32_t stamp = 0; ///< of the search that reached the vertex last
    };
    using Open = std::pair<Vertex, std::uint32_t>; ///< with the distance that it was reached at

    void nextQuery();
    void reach(Vertex v, std::uint32_t distance, std::uint32_t total);

    const Graph *graph_;
    const Landmarks *landmarks_;
    std::vector<Label> labels_;
    std::uint32_t stamp_ = 0;
    /// By distance + bound, modulo their number: from a vertex to the next one that sum grows by 0, 1 or 2.
    std::array<std::vector<Open>, 3> buckets_;
    std::uint64_t visits_ = 0;
};

} // namespace mrpp
