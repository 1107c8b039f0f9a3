#pragma once
/// \file
/// Operations with a single blank within the part of a biconnected graph that is not *locked* yet, named as
/// in BIBOX: bring the blank somewhere, carry a robot, fill a handle.
///
/// Source: P. Surynek, "A novel approach to path planning for multiple robots in bi-connected graphs", ICRA
/// 2009, and "An application of pebble motion on graphs to abstract multi-robot path planning", ICTAI 2009.

#include "algorithms/pebble/OneBlankBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <span>
#include <vector>

namespace mrpp
{

/// A path whose inner vertices belong to no earlier part of an ear decomposition: x, inner …, y with x ≠ y.
struct Handle
{
    Vertex x = 0;
    std::vector<Vertex> inner;
    Vertex y = 0;
};

class BlankOperations
{
public:
    /// Keeps references to both. Every vertex is unlocked.
    BlankOperations(OneBlankBoard &board, const TerminationCondition &ptc);

    void lock(Vertex v) { locked_[v] = 1; }
    void unlock(Vertex v) { locked_[v] = 0; }
    [[nodiscard]] bool isLocked(Vertex v) const { return locked_[v] != 0; }

    /// The operations below return false only when the termination condition says stop, and leave the board
    /// in the middle of what they did. \pre the unlocked vertices are a cycle or biconnected

    /// The blank goes to v along a shortest path that does not touch `avoid`.
    bool bringBlank(Vertex v, Vertex avoid = kNoVertex);

    /// Brings the one whose target is `robot` to v: each step of a shortest path needs the blank ahead of it.
    bool carry(Vertex robot, Vertex v);

    /// Fills the inner vertices of a handle with those that have to be there; the blank ends outside of them.
    /// \pre without the inner vertices the unlocked ones are a cycle or biconnected, and the blank's target
    /// is among them
    bool fill(const Handle &handle);

    /// Takes back every step after the mark.
    bool takeBack(OneBlankBoard::Mark mark);

    /// The beginning of fillFromX(): the one that has to be next to y is put next to x, and the blank on y.
    bool enterFirst(const Handle &handle);

    /// Takes the one that enterFirst() put next to x out, and puts it there once more, with a push in
    /// between: then the blank has gone through the handle three times, and filling it leaves a permutation
    /// of the other parity where that makes a difference. \pre the vertices that are unlocked besides the
    /// inner ones are a cycle
    bool enterFirstAgain(const Handle &handle);

    /// As fill(), not choosing between x and y: all enter from x. After enterFirst(), the number of times
    /// that the blank goes through the handle is even or odd by the number of its inner vertices alone.
    bool fillFromX(const Handle &handle);

private:
    bool extract(const Handle &handle, std::size_t pushes);
    void walkThrough(const Handle &handle, bool fromY);
    [[nodiscard]] std::vector<Vertex> reducedWalkSince(OneBlankBoard::Mark mark) const;
    [[nodiscard]] bool isFilled(const Handle &handle) const;
    void setLocked(std::span<const Vertex> vertices, bool locked);
    /// Walks to the first vertex that satisfies `wanted`.
    template <class Wanted>
    bool walkToFirst(Vertex avoid, Wanted &&wanted);

    OneBlankBoard &board_;
    const Graph &graph_;
    const TerminationCondition &ptc_;
    std::vector<char> locked_; ///< size = vertices
    StampedSearch blankSearch_;
    StampedSearch robotSearch_;
    std::vector<std::uint32_t> distances_; ///< to where a robot is carried
    std::vector<Vertex> path_;
};

} // namespace mrpp
