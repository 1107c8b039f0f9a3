#pragma once
/// \file
/// Where the robots stand while a solution is being made, and the moves so far. Every change is one recorded
/// move into a free vertex, so that any stretch can be taken back or replayed.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"

#include <cassert>
#include <span>
#include <vector>

namespace mrpp
{

class PebbleBoard
{
public:
    explicit PebbleBoard(const Instance &instance)
        : graph_(*instance.graph), positions_(instance.starts), occupants_(graph_.vertexCount(), kNoRobot)
    {
        for (Robot r = 0; r < positions_.size(); ++r)
            occupants_[positions_[r]] = r;
    }

    [[nodiscard]] const Graph &graph() const { return graph_; }
    [[nodiscard]] std::size_t robotCount() const { return positions_.size(); }
    [[nodiscard]] Vertex position(Robot r) const { return positions_[r]; }
    /// kNoRobot where the vertex is free.
    [[nodiscard]] Robot occupant(Vertex v) const { return occupants_[v]; }
    [[nodiscard]] bool isFree(Vertex v) const { return occupants_[v] == kNoRobot; }

    /// \pre `to` is free and next to the robot
    void move(Robot r, Vertex to)
    {
        assert(isFree(to) && graph_.hasEdge(positions_[r], to));
        moves_.push_back({r, positions_[r], to});
        occupants_[positions_[r]] = kNoRobot;
        occupants_[to] = r;
        positions_[r] = to;
    }

    /// Every move so far.
    [[nodiscard]] std::span<const Move> moves() const { return moves_; }

    /// A point to come back to.
    using Mark = std::size_t;
    [[nodiscard]] Mark mark() const { return moves_.size(); }

    /// Takes back every move after the mark.
    void rollback(Mark mark)
    {
        while (moves_.size() > mark)
        {
            const Move last = moves_.back();
            moves_.pop_back();
            occupants_[last.to] = kNoRobot;
            occupants_[last.from] = last.robot;
            positions_[last.robot] = last.from;
        }
    }

    /// *Reverse*: undoes the moves [first, last) by new moves, last one first, with the names of r and s
    /// exchanged: everybody but these two comes back to where they stood at `first`.
    void reverse(Mark first, Mark last, Robot r, Robot s)
    {
        for (Mark i = last; i-- > first;)
        {
            const Move done = moves_[i];
            move(done.robot == r ? s : done.robot == s ? r : done.robot, done.from);
        }
    }

    /// Gives the moves away.
    [[nodiscard]] Solution takeSolution() { return Solution(std::move(moves_)); }

private:
    const Graph &graph_;
    std::vector<Vertex> positions_; ///< size = robots
    std::vector<Robot> occupants_;  ///< size = vertices
    std::vector<Move> moves_;
};

} // namespace mrpp
