#pragma once
/// \file
/// A sequential answer: moves one after another, and rotations, in which several robots on a cycle move at
/// once.

#include "framework/model/Graph.h"

#include <cassert>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mrpp
{

/// One robot goes along one edge. 12 bytes; a solution may hold 10^8 of them.
struct Move
{
    Robot robot = 0;
    Vertex from = 0;
    Vertex to = 0;

    friend bool operator==(const Move &, const Move &) = default;
};

/// Moves in order. An *action* is one move, or one rotation: a run of moves that happen at once.
///
/// Planners append; optimizers rewrite. Appending is amortized O(1).
class Solution
{
public:
    /// The moves [first, first + size) of moves() happen at once, each robot entering the vertex that another
    /// of them leaves.
    struct Rotation
    {
        std::size_t first = 0;
        std::size_t size = 0;

        friend bool operator==(const Rotation &, const Rotation &) = default;
    };

    Solution() = default;
    /// Takes over moves that happen one after another.
    explicit Solution(std::vector<Move> moves) : moves_(std::move(moves)) {}
    /// \param rotations ascending, not overlapping, each of two moves or more, within `moves`
    Solution(std::vector<Move> moves, std::vector<Rotation> rotations);

    void append(const Move &move) { moves_.push_back(move); }
    void appendRotation(std::span<const Move> moves);

    /// Drops everything after the first `pathLength` moves. \pre the cut does not go through a rotation
    void truncate(std::size_t pathLength);
    void clear() { truncate(0); }
    void reserve(std::size_t moves) { moves_.reserve(moves); }

    [[nodiscard]] std::span<const Move> moves() const { return moves_; }
    [[nodiscard]] std::span<const Rotation> rotations() const { return rotations_; }
    [[nodiscard]] bool empty() const { return moves_.empty(); }

    /// Number of moves; a rotation of k robots counts k.
    [[nodiscard]] std::size_t pathLength() const { return moves_.size(); }

    /// Number of actions; a rotation counts one.
    [[nodiscard]] std::size_t actionCount() const;

    /// Calls `visit(std::span<const Move>)` for each action in order.
    template <class Visitor>
    void forEachAction(Visitor &&visit) const
    {
        std::size_t next = 0;
        const std::span<const Move> all = moves_;
        for (const Rotation &rotation : rotations_)
        {
            for (; next < rotation.first; ++next)
                visit(all.subspan(next, 1));
            visit(all.subspan(next, rotation.size));
            next += rotation.size;
        }
        for (; next < all.size(); ++next)
            visit(all.subspan(next, 1));
    }

    /// Depends on every move and rotation. O(moves).
    [[nodiscard]] std::string fingerprint() const;

    /// Gives the moves away, for optimizers that rewrite in place.
    [[nodiscard]] std::vector<Move> releaseMoves() &&;

    friend bool operator==(const Solution &, const Solution &) = default;

private:
    std::vector<Move> moves_;
    std::vector<Rotation> rotations_; ///< ascending
};

} // namespace mrpp
