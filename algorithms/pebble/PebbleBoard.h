#pragma once
/// \file
/// Where the robots stand while a solution is being made, and the moves so far. Every change is one recorded
/// move into a free vertex, or one recorded rotation of a full cycle, so that any stretch can be taken back
/// or replayed.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
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
        place(r, to);
    }

    /// All robots of a full cycle move at once, each to the next vertex of it, the last one to the first.
    /// \pre three or more vertices, each next to the following one, the last to the first; none is free
    void rotate(std::span<const Vertex> cycle)
    {
        assert(cycle.size() >= 3);
        const std::size_t first = moves_.size();
        for (std::size_t i = 0; i < cycle.size(); ++i)
        {
            const Vertex to = cycle[i + 1 < cycle.size() ? i + 1 : 0];
            assert(!isFree(cycle[i]) && graph_.hasEdge(cycle[i], to));
            moves_.push_back({occupants_[cycle[i]], cycle[i], to});
        }
        finishRotation(first);
    }

    /// Every move so far.
    [[nodiscard]] std::span<const Move> moves() const { return moves_; }

    /// A point to come back to; never within a rotation.
    using Mark = std::size_t;
    [[nodiscard]] Mark mark() const { return moves_.size(); }

    /// Takes back every move after the mark.
    void rollback(Mark mark)
    {
        while (moves_.size() > mark)
        {
            if (!rotations_.empty() && rotations_.back().first + rotations_.back().size == moves_.size())
            {
                for (const Move &turned : std::span(moves_).subspan(rotations_.back().first))
                    place(turned.robot, turned.from);
                moves_.resize(rotations_.back().first);
                rotations_.pop_back();
                continue;
            }
            const Move last = moves_.back();
            moves_.pop_back();
            occupants_[last.to] = kNoRobot;
            place(last.robot, last.from);
        }
    }

    /// Takes back every move after the mark and gives them away, for replay().
    [[nodiscard]] Solution cut(Mark mark)
    {
        std::vector<Solution::Rotation> rotations(rotations_.begin() + rotationsBefore(mark),
                                                  rotations_.end());
        for (Solution::Rotation &rotation : rotations)
            rotation.first -= mark;
        Solution moves({moves_.begin() + static_cast<std::ptrdiff_t>(mark), moves_.end()},
                       std::move(rotations));
        rollback(mark);
        return moves;
    }

    /// Makes the moves again. Where one of them undoes the last one made before, takes that one back instead;
    /// marks do not hold any more then. \pre the board is as it was before the moves
    void replay(const Solution &moves)
    {
        moves.forEachAction(
            [this](std::span<const Move> action)
            {
                if (undoesLast(action))
                    return rollback(moves_.size() - action.size());
                if (action.size() == 1)
                    return move(action.front().robot, action.front().to);
                const std::size_t first = moves_.size();
                moves_.insert(moves_.end(), action.begin(), action.end());
                finishRotation(first);
            });
    }

    /// *Reverse*: undoes the moves [first, last) by new moves, last one first, with the names of r and s
    /// exchanged: everybody but these two comes back to where they stood at `first`. A rotation is turned
    /// back.
    void reverse(Mark first, Mark last, Robot r, Robot s)
    {
        const auto renamed = [r, s](Robot robot) { return robot == r ? s : robot == s ? r : robot; };
        auto rotation = static_cast<std::size_t>(std::partition_point(rotations_.begin(), rotations_.end(),
                                                                      [last](const Solution::Rotation &done)
                                                                      { return done.first < last; }) -
                                                 rotations_.begin());
        for (Mark i = last; i > first;)
        {
            const bool turned =
                rotation > 0 && rotations_[rotation - 1].first + rotations_[rotation - 1].size == i;
            if (!turned)
            {
                const Move done = moves_[--i];
                move(renamed(done.robot), done.from);
                continue;
            }
            const std::size_t begin = rotations_[--rotation].first;
            const std::size_t newFirst = moves_.size();
            while (i > begin)
            {
                const Move done = moves_[--i];
                moves_.push_back({renamed(done.robot), done.to, done.from});
            }
            finishRotation(newFirst);
        }
    }

    /// Gives the moves away.
    [[nodiscard]] Solution takeSolution()
    {
        return {std::exchange(moves_, {}), std::exchange(rotations_, {})};
    }

private:
    void place(Robot r, Vertex v)
    {
        positions_[r] = v;
        occupants_[v] = r;
    }

    /// Whether the action takes everybody back to where they were before the last one.
    [[nodiscard]] bool undoesLast(std::span<const Move> action) const
    {
        const bool rotated =
            !rotations_.empty() && rotations_.back().first + rotations_.back().size == moves_.size();
        const std::size_t size = rotated ? rotations_.back().size : 1;
        if (action.size() != size || moves_.size() < size)
            return false;
        const auto last = std::span(moves_).last(size);
        const auto isUndone = [](const Move &done, const Move &now)
        { return done.robot == now.robot && done.from == now.to; };
        // The last one's cycle, backwards from its first move.
        const auto begin = std::find_if(action.begin(), action.end(),
                                        [&](const Move &now) { return isUndone(last.front(), now); });
        if (begin == action.end())
            return false;
        auto now = static_cast<std::size_t>(begin - action.begin());
        for (std::size_t i = size; i-- > 1;)
        {
            now = now + 1 == size ? 0 : now + 1;
            if (!isUndone(last[i], action[now]))
                return false;
        }
        return true;
    }

    /// How many rotations there were at the mark.
    [[nodiscard]] std::ptrdiff_t rotationsBefore(Mark mark) const
    {
        return std::partition_point(rotations_.begin(), rotations_.end(),
                                    [mark](const Solution::Rotation &done) { return done.first < mark; }) -
               rotations_.begin();
    }

    /// Makes the moves from `first` on, which were only recorded so far, one rotation.
    void finishRotation(std::size_t first)
    {
        rotations_.push_back({first, moves_.size() - first});
        for (const Move &turned : std::span(moves_).subspan(first))
            place(turned.robot, turned.to);
    }

    const Graph &graph_;
    std::vector<Vertex> positions_; ///< size = robots
    std::vector<Robot> occupants_;  ///< size = vertices
    std::vector<Move> moves_;
    std::vector<Solution::Rotation> rotations_; ///< ascending
};

} // namespace mrpp
