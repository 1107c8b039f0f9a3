#pragma once
/// \file
/// The moves that Push and Swap and its successors share, named as in the papers: clear vertex, push,
/// multipush, clear, exchange, swap.
///
/// Sources: R. Luna, K. E. Bekris, "Push and Swap: fast cooperative path-finding with completeness
/// guarantees", IJCAI 2011, pp. 294–300; B. de Wilde, A. W. ter Mors, C. Witteveen, "Push and Rotate: a
/// complete multi-agent pathfinding algorithm", JAIR 51 (2014) 443–492, whose *clear* has all four stages.
///
/// A public operation that returns false has left the board, and the moves so far, as they were.

#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <initializer_list>
#include <vector>

namespace mrpp
{

class PebbleOperations
{
public:
    /// Vertices that a search must not touch: a few named ones, and those on which marked robots stand.
    struct Blocked
    {
        std::initializer_list<Vertex> vertices;
        const std::vector<char> *robots = nullptr; ///< nonzero where the robot must stay; size = robots
    };

    /// Keeps references to both.
    PebbleOperations(PebbleBoard &board, const TerminationCondition &ptc);

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
    bool swap(Robot r, Robot s);

    /// The vertices onto which clearVertex() pushes somebody only when nothing else is near.
    void avoid(std::span<const Vertex> vertices);

private:
    bool multipush(Robot leader, Robot follower, std::span<const Vertex> path);
    bool clear(Robot r, Robot s, Vertex junction);
    bool clearThroughFree(Vertex junction, Vertex beside, Vertex free);
    bool clearThroughBeside(Robot r, Robot s, Vertex junction, Vertex free);
    bool clearByBackingOff(Robot r, Robot s, Vertex junction, Vertex free);
    void exchange(Robot onJunction, Robot beside, Vertex junction);

    PebbleBoard &board_;
    const Graph &graph_;
    const TerminationCondition &ptc_;
    StampedSearch freeSearch_;     ///< of clearVertex
    StampedSearch junctionSearch_; ///< of swap
    std::vector<Vertex> path_;     ///< of swap
    std::vector<std::uint32_t> avoidStamps_;
    std::uint32_t avoidStamp_ = 0;
};

} // namespace mrpp
