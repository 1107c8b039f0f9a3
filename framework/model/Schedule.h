#pragma once
/// \file
/// A parallel answer: steps, each a set of moves that happen at once. Waits are not written.

#include "framework/model/Solution.h"

#include <span>
#include <vector>

namespace mrpp
{

class Schedule
{
public:
    Schedule() = default;
    /// \param moves  all moves, step by step
    /// \param ends   for each step the index behind its last move; ascending, the last is moves.size()
    Schedule(std::vector<Move> moves, std::vector<std::size_t> ends);

    void appendStep(std::span<const Move> moves);

    /// Number of steps.
    [[nodiscard]] std::size_t makespan() const { return ends_.size(); }
    [[nodiscard]] std::size_t pathLength() const { return moves_.size(); }
    [[nodiscard]] std::span<const Move> moves() const { return moves_; }
    [[nodiscard]] std::span<const Move> step(std::size_t index) const
    {
        const std::size_t first = index == 0 ? 0 : ends_[index - 1];
        return std::span<const Move>(moves_).subspan(first, ends_[index] - first);
    }

    /// The same answer one action after another: in each step the heads of chains first, closed cycles as
    /// rotations. \pre no step enters a vertex twice and no two robots swap along an edge
    /// O(moves + vertexCount).
    [[nodiscard]] Solution toSolution(std::size_t vertexCount) const;

    /// One step for each action.
    [[nodiscard]] static Schedule fromActions(const Solution &solution);

    friend bool operator==(const Schedule &, const Schedule &) = default;

private:
    std::vector<Move> moves_;
    std::vector<std::size_t> ends_;
};

} // namespace mrpp
