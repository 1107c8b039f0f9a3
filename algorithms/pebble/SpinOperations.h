#pragma once
/// \file
/// The moves of Push and Spin: push, rotate, and swaps by *spins*. Where Push and Swap needs two free
/// vertices at a junction to exchange two neighbours, a cycle and one free vertex do:
///
/// * **cycle–bridge (CB)**: one robot of the pair stands on a vertex of the cycle, its *entry*, the other one
///   beside it, *outside* the cycle. The first one steps aside on the cycle, the second one enters, the cycle
///   turns, the first one leaves, and the second one takes its place;
/// * **cycle–cycle (CC)**: both stand on the cycle. It turns until one of them is on an entry whose outside
/// is
///   free; that one steps out, the other one follows onto the entry;
/// * **bridge–bridge (BB)**: both stand off the cycle. They go to it together (*multipush*) until the first
/// one
///   is on the entry.
///
/// What led to the exchange is reversed with the two names exchanged, so that everybody else is where they
/// were. Cycles are the shortest through the pair or the entry, found by one breadth-first search, and turn
/// the shorter way round.
///
/// Source: E. T. S. Alotaibi, H. Al-Rawi, "Push and spin: a complete multi-robot path planning algorithm",
/// ICARCV 2016; "A complete multi-robot path-planning algorithm", Autonomous Agents and Multi-Agent Systems
/// 32 (2018) 693–740.
///
/// A public operation that returns false has left the board, and the moves so far, as they were: it cannot be
/// done, or the termination condition says stop.

#include "algorithms/pebble/CycleSearch.h"
#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/PebbleOperations.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/analysis/Blocks.h"
#include "framework/analysis/Subgraphs.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrpp
{

class SpinOperations
{
public:
    /// Keeps references to all of them.
    SpinOperations(PebbleBoard &board, const Blocks &blocks, const TerminationCondition &ptc);

    /// From now on chance breaks ties, and leaves out some ways to swap. Null (at first): nothing is left to
    /// chance. Keeps the pointer.
    void setRandom(Random *random)
    {
        random_ = random;
        pebble_.setRandom(random);
    }

    /// From now on only robots of one subgraph swap: elsewhere no swap can work, and it is not tried. Keeps
    /// the reference and the pointer.
    /// \param assignment the subgraph of each robot, or kNoSubgraph; size = robots
    void restrictSwaps(const Subgraphs &subgraphs, std::span<const std::uint32_t> assignment)
    {
        assignment_ = assignment;
        pebble_.restrictSwaps(subgraphs, assignment);
    }

    /// *Push*: r goes to the neighbouring vertex v, whose occupant gives way; or a full cycle turns with
    /// both, where that takes fewer moves. The marked robots stay. \param stay nonzero where a robot must not
    /// move; null: all may
    bool push(Robot r, Vertex v, const std::vector<char> *stay);

    /// *Swap*: the neighbours r and s exchange places, and every other robot is where it was: by a spin, or
    /// by an exchange at a junction, whichever takes fewest moves of those tried. False where none works, or
    /// where the termination condition says stop.
    bool swap(Robot r, Robot s);

    /// *Rotate*: every robot on the cycle goes one vertex on, from cycle[i] to cycle[i+1] and from the last
    /// to the first: at once where the cycle is full, else one after another into its holes. \param cycle
    /// three vertices or more, each next to the one before, the first next to the last
    bool rotate(std::span<const Vertex> cycle);

    /// The vertices onto which push() moves somebody only when nothing else is near.
    void avoid(std::span<const Vertex> vertices) { pebble_.avoid(vertices); }

private:
    using Cycle = std::vector<Vertex>;
    struct Pair
    {
        Robot first;  ///< leads, when the two go somewhere
        Robot second; ///< follows
    };

    [[nodiscard]] bool canSwap(Robot r, Robot s) const;
    [[nodiscard]] bool isEntry(Vertex v) const
    {
        return graph_.degree(v) >= 3 && blocks_.inTwoEdgeComponent(v);
    }
    [[nodiscard]] std::vector<std::uint32_t> distancesToEntries() const;
    void spinsOnCycle(Pair pair);
    void spinOnCycle(Pair pair, std::size_t entry, Vertex outside);
    bool freeOutside(Pair pair, Vertex outside);
    bool pullIn(Pair pair, Vertex outside);
    bool stepOut(Pair pair, Vertex outside);
    void hold(char value);
    void spinsOutside(Pair pair);
    void spinOutside(Pair pair);
    bool multipush(Pair pair);
    bool openCycle(Pair pair);
    bool makeHole(Vertex outside);
    bool openThroughThird(Pair pair);
    void complete(PebbleBoard::Mark start, Pair pair);
    void exchange(Vertex outside);
    void exchangeByFullTurn(Vertex outside, std::size_t hole);
    void exchangeBetweenHoles(Vertex outside, std::size_t first, std::size_t last);
    void exchangeAtJunction(Pair pair, const PebbleOperations::SwapLimits &limits);
    void tryOut(PebbleBoard::Mark start);
    [[nodiscard]] bool isEnough() const;
    [[nodiscard]] bool isWorthTrying(std::size_t leastMoves);
    void giveUp(PebbleBoard::Mark start);
    /// The robot on one vertex goes to a neighbouring one.
    void shift(Vertex from, Vertex to) { board_.move(board_.occupant(from), to); }

    PebbleBoard &board_;
    const Graph &graph_;
    const Blocks &blocks_;
    const TerminationCondition &ptc_;
    PebbleOperations pebble_;
    Random *random_ = nullptr;
    std::span<const std::uint32_t> assignment_; ///< empty: any two robots may swap
    FreeCounts free_;
    /// From each vertex to the nearest one at which spinsOutside() may exchange a pair; kUnreachable where
    /// there is none.
    std::vector<std::uint32_t> toEntry_;
    CycleSearch cycles_;
    StampedSearch siteSearch_;             ///< of spinsOutside
    std::vector<std::uint32_t> siteSteps_; ///< from the pair, of vertices that it visited
    StampedSearch freeSearch_;             ///< of makeHole
    Cycle pairCycle_;                      ///< through the pair, of spinsOnCycle
    Cycle cycle_;                          ///< on which the exchange happens; its first vertex is the entry
    Cycle turned_;                         ///< the same the other way round
    std::vector<Vertex> path_;             ///< of spinsOutside
    std::vector<char> held_;               ///< nonzero for robots on the cycle, of hold(); size = robots
    Solution best_;                        ///< of the swaps tried out
    bool found_ = false;                   ///< whether there is one
    std::size_t tries_ = 0;                ///< ways to swap that were tried for this pair
    std::size_t spent_ = 0;                ///< moves that these took
};

} // namespace mrpp
