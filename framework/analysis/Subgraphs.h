#pragma once
/// \file
/// Which robots can change places: the decomposition of a graph into *subgraphs* within which robots can be
/// permuted at will, and the assignment of robots to them.
///
/// The seeds are the 2-edge-connected components of three or more vertices (C) and every other vertex of
/// degree three or more (J). Outside the C seeds the graph is a forest, whose *corridors* run over vertices
/// of degree two from seed to seed or from a seed to a leaf. A corridor of `length` edges links its two seeds
/// to one subgraph, and belongs to it, where m free vertices of the component allow it:
///
/// | | C–C | C–J | J–J |
/// |---|---|---|---|
/// | one robot at a time, m ≥ 2 | length ≤ m−2 | length ≤ m−2 | length ≤ m−2 |
/// | with rotations, m ≥ 0 | length ≤ m | length ≤ m−1 | length ≤ m−2 |
///
/// (Links over several corridors follow, because each corridor on the way is shorter.) A corridor that links
/// nothing is a *plank* of the subgraphs at its ends: robots that stand on it belong to a subgraph if they
/// can be pulled in.
///
/// de Wilde, ter Mors, Witteveen: Push and Rotate: a Complete Multi-agent Pathfinding Algorithm, JAIR 51
/// (2014), algorithms 1 and 2; Kornhauser, Miller, Spirakis: Coordinating Pebble Motion on Graphs, FOCS 1984.
/// The limits for rotations are this project's own, checked exhaustively against brute force
/// (docs/completeness.md).
///
/// \code
/// const Blocks blocks(graph);
/// const Subgraphs subgraphs(graph, blocks, MotionRule::pebble, instance.starts);
/// const auto from = subgraphs.assignment(instance.starts); // a subgraph for each robot, or kNoSubgraph
/// const auto to = subgraphs.assignment(instance.goals);    // necessary for solvability: to == from
/// \endcode
///
/// Everything is O(V + E). A component without enough free vertices (below two, without rotations) has no
/// subgraphs; nor has a path. A polygon is one subgraph, in which robots can only be turned.

#include "framework/analysis/Blocks.h"
#include "framework/model/Graph.h"
#include "framework/model/MotionRule.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mrpp
{

inline constexpr std::uint32_t kNoSubgraph = static_cast<std::uint32_t>(-1);

/// How many free vertices there are in a component and on either side of a bridge. Building takes O(V).
class FreeCounts
{
public:
    FreeCounts(const Blocks &blocks, std::span<const Vertex> occupied);

    /// In the component of v.
    [[nodiscard]] std::uint32_t inComponent(Vertex v) const { return below(blocks_->root(v)); }
    /// On the far side of the bridge v–u, seen from v. O(1).
    [[nodiscard]] std::uint32_t beyond(Vertex v, Vertex u) const
    {
        return blocks_->parent(u) == v ? below(u) : inComponent(v) - below(v);
    }
    [[nodiscard]] bool isFree(Vertex v) const
    {
        return before_[blocks_->position(v)] != before_[blocks_->position(v) + 1];
    }

private:
    [[nodiscard]] std::uint32_t below(Vertex v) const
    {
        return before_[blocks_->position(v) + blocks_->subtreeSize(v)] - before_[blocks_->position(v)];
    }

    const Blocks *blocks_;
    std::vector<std::uint32_t> before_; ///< free vertices among the first i of the preorder
};

/// A corridor that leaves a subgraph and is not part of one.
struct Plank
{
    std::uint32_t subgraph = kNoSubgraph;    ///< that it leaves
    Vertex join = kNoVertex;                 ///< the subgraph's vertex at its beginning
    Vertex exterior = kNoVertex;             ///< its first vertex that is not the subgraph's
    Vertex end = kNoVertex;                  ///< its last one: a leaf, or the first of another subgraph
    std::uint32_t length = 0;                ///< edges from join to end
    std::uint32_t farSubgraph = kNoSubgraph; ///< the one that `end` belongs to; none where it is a leaf
};

/// The graph and the blocks must outlive it; read by many threads at once.
class Subgraphs
{
public:
    /// \param occupied where the robots stand; only their number in each component matters
    Subgraphs(const Graph &graph, const Blocks &blocks, MotionRule rule, std::span<const Vertex> occupied);

    /// Numbered by their smallest vertex.
    [[nodiscard]] std::size_t count() const { return vertexOffsets_.size() - 1; }
    [[nodiscard]] std::uint32_t of(Vertex v) const { return subgraph_[v]; } ///< or kNoSubgraph
    /// Ascending.
    [[nodiscard]] std::span<const Vertex> vertices(std::uint32_t subgraph) const
    {
        return {vertices_.data() + vertexOffsets_[subgraph], vertices_.data() + vertexOffsets_[subgraph + 1]};
    }
    /// Those that leave a subgraph, ordered by join, then exterior. A plank between two subgraphs is in both
    /// lists, once in each direction.
    [[nodiscard]] std::span<const Plank> planks(std::uint32_t subgraph) const
    {
        return {planks_.data() + plankOffsets_[subgraph], planks_.data() + plankOffsets_[subgraph + 1]};
    }

    /// Calls visit(v) for exterior … end of a plank, in this order, until it returns false. O(length).
    template <class Visit>
    void walk(const Plank &plank, Visit &&visit) const
    {
        Vertex previous = plank.join;
        Vertex v = plank.exterior;
        while (visit(v) && v != plank.end)
            v = onwards(std::exchange(previous, v), v);
    }

    /// The subgraph of the robot on each of these vertices (all that are occupied), or kNoSubgraph for one
    /// that no subgraph can reach: it can never pass another robot. O(V).
    ///
    /// With m1 the free vertices on the near side of a plank, seen from its join, a subgraph reaches the
    /// first m1−1 robots on it (with rotations, m1 where the join lies in a C seed); it may lose the robot on
    /// a join itself.
    [[nodiscard]] std::vector<std::uint32_t> assignment(std::span<const Vertex> occupied) const;

private:
    struct Corridors;
    [[nodiscard]] bool isSeed(Vertex v) const
    {
        return graph_->degree(v) >= 3 || blocks_->inTwoEdgeComponent(v);
    }
    /// The other neighbour of a vertex of degree two.
    [[nodiscard]] Vertex onwards(Vertex previous, Vertex v) const
    {
        const auto around = graph_->neighbors(v);
        return around[around[0] == previous ? 1 : 0];
    }
    void follow(Corridors &corridors, Vertex join, Vertex exterior, std::uint32_t limit) const;
    void number(Corridors &corridors, std::span<const std::uint8_t> seeds);
    void sortPlanks(std::span<Plank> unlinked);
    [[nodiscard]] bool keepsOccupant(std::span<const Plank> planksAtJoin, const FreeCounts &free) const;

    const Graph *graph_;
    const Blocks *blocks_;
    bool rotations_;
    std::vector<std::uint32_t> subgraph_; ///< size V
    std::vector<std::uint32_t> vertexOffsets_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> plankOffsets_;
    std::vector<Plank> planks_;
};

} // namespace mrpp
