#pragma once
/// \file
/// The moves that Push and Swap and its successors share, named as in the papers: clear vertex, push,
/// multipush, clear, exchange, swap, rotate.
///
/// Sources: R. Luna, K. E. Bekris, "Push and Swap: fast cooperative path-finding with completeness
/// guarantees", IJCAI 2011, pp. 294–300; B. de Wilde, A. W. ter Mors, C. Witteveen, "Push and Rotate: a
/// complete multi-agent pathfinding algorithm", JAIR 51 (2014) 443–492, whose *clear* has all four stages.
///
/// A public operation that returns false has left the board, and the moves so far, as they were: it cannot be
/// done, or the termination condition says stop.

#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/analysis/Subgraphs.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <initializer_list>
#include <limits>
#include <vector>

namespace mrpp
{

/// Nonzero for the robots that no swap can help, as they live on a path or a polygon; size = robots. O(V +
/// E).
[[nodiscard]] std::vector<char> unswappable(const Instance &instance);

class PebbleOperations
{
public:
    /// Vertices that a search must not touch: a few named ones, and those on which marked robots stand.
    struct Blocked
    {
        std::initializer_list<Vertex> vertices;
        const std::vector<char> *robots = nullptr; ///< nonzero where the robot must stay; size = robots
        bool cycle = false;                        ///< also the cycle on which rotate() works
    };

    /// Keeps references to both.
    PebbleOperations(PebbleBoard &board, const TerminationCondition &ptc);

    /// From now on chance breaks ties: which way to push, where to swap. Null (at first): the numbers of the
    /// vertices do. Keeps the pointer.
    void setRandom(Random *random) { random_ = random; }

    /// From now on only robots of one subgraph swap, and only at its vertices: elsewhere no swap can work,
    /// and it is not tried. Keeps the reference and the pointer.
    /// \param assignment the subgraph of each robot, or kNoSubgraph; size = robots
    void restrictSwaps(const Subgraphs &subgraphs, std::span<const std::uint32_t> assignment)
    {
        subgraphs_ = &subgraphs;
        assignment_ = assignment;
    }

    /// Frees v: pushes its occupant, and those in the way, one vertex each towards the nearest free vertex,
    /// or one nearly as near that is not avoided (see avoid()). False where v is blocked or no free vertex
    /// can be reached. O(edges of the vertices visited).
    bool clearVertex(Vertex v, const Blocked &blocked);

    /// *Push*: r goes to the neighbouring vertex v, whose occupant gives way; the marked robots stay.
    /// \param stay nonzero where a robot must not be pushed; null: all may
    bool push(Robot r, Vertex v, const std::vector<char> *stay);

    /// *Swap*: the neighbours r and s exchange places, and every other robot is where it was. They go
    /// together to a vertex of degree three or more (multipush), its neighbourhood is cleared, they exchange
    /// there, and what led there is reversed. The nearest such vertices are tried first. False where none
    /// works, or where the termination condition says stop.
    bool swap(Robot r, Robot s) { return swap(r, s, {}); }

    /// How far a swap looks.
    struct SwapLimits
    {
        /// Only at vertices where it may take so few moves.
        std::size_t moves = std::numeric_limits<std::size_t>::max();
        std::size_t junctions = std::numeric_limits<std::size_t>::max(); ///< at most so many vertices
    };
    bool swap(Robot r, Robot s, const SwapLimits &limits);

    /// *Rotate*: every robot on the cycle goes one vertex on, from cycle[i] to cycle[i+1] and from the last
    /// to the first. On a full cycle one robot is pushed off first, and comes back by a swap. All other
    /// robots are where they were. False where that fails, or where the termination condition says stop.
    /// \param cycle three vertices or more, each next to the one before, the first next to the last
    bool rotate(std::span<const Vertex> cycle);

    /// The vertices onto which clearVertex() pushes somebody only when nothing else is near.
    void avoid(std::span<const Vertex> vertices);

private:
    /// Calls visit(w) for the neighbours of v, in an order of chance where there is one.
    template <class Visit>
    void forNeighbors(Vertex v, const Visit &visit)
    {
        const std::span<const Vertex> around = graph_.neighbors(v);
        if (random_ == nullptr)
        {
            for (const Vertex w : around)
                visit(w);
            return;
        }
        const std::uint64_t bits = random_->bits();
        const bool backwards = (bits & 1U) != 0;
        std::size_t i = around.empty() ? 0 : (bits >> 1) % around.size();
        for (std::size_t left = around.size(); left > 0; --left)
        {
            visit(around[i]);
            if (backwards)
                i = i == 0 ? around.size() - 1 : i - 1;
            else
                i = i + 1 == around.size() ? 0 : i + 1;
        }
    }
    /// The same for clear() and exchange(), as a list that is valid until the next call.
    std::span<const Vertex> aroundJunction(Vertex junction);
    [[nodiscard]] bool canSwap(Robot r, Robot s) const;
    [[nodiscard]] bool isJunctionOf(Robot r, Vertex v) const;
    void cascade(std::span<const Vertex> cycle, std::size_t hole);
    bool multipush(Robot leader, Robot follower, std::span<const Vertex> path);
    bool clear(Robot r, Robot s, Vertex junction);
    bool clearThroughFree(Vertex junction, Vertex beside, Vertex free);
    bool clearThroughBeside(Robot r, Robot s, Vertex junction, Vertex free);
    bool clearByBackingOff(Robot r, Robot s, Vertex junction, Vertex free);
    void exchange(Robot onJunction, Robot beside, Vertex junction);

    PebbleBoard &board_;
    const Graph &graph_;
    const TerminationCondition &ptc_;
    Random *random_ = nullptr;
    const Subgraphs *subgraphs_ = nullptr;      ///< null: any two robots may swap anywhere
    std::span<const std::uint32_t> assignment_; ///< of robots to subgraphs
    StampedSearch freeSearch_;                  ///< of clearVertex
    StampedSearch junctionSearch_;              ///< of swap
    std::vector<Vertex> path_;                  ///< of swap
    std::vector<Vertex> around_;                ///< of aroundJunction
    std::vector<std::uint32_t> avoidStamps_;
    std::uint32_t avoidStamp_ = 0;
    std::vector<std::uint32_t> cycleStamps_;
    std::uint32_t cycleStamp_ = 0;
};

} // namespace mrpp
