#include "algorithms/optimizers/RedundancyRemoval.h"

#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrpp
{

namespace
{

/// An arrival of a robot at a vertex: numbers below `robots` are the arrivals at the starts, the others the
/// targets of the moves, in order.
using Arrival = std::uint32_t;
constexpr Arrival kNone = static_cast<Arrival>(-1);

/// All arrivals, linked by robot and by vertex.
class Arrivals
{
public:
    Arrivals(const Instance &instance, std::vector<Move> &moves,
             std::span<const Solution::Rotation> rotations)
        : instance_(instance), moves_(moves), robots_(static_cast<Arrival>(instance.robotCount())),
          nextOfRobot_(robots_ + moves.size(), kNone), nextAtVertex_(nextOfRobot_.size(), kNone),
          previousAtVertex_(nextOfRobot_.size(), kNone)
    {
        std::vector<Arrival> lastOfRobot(robots_, kNone);
        std::vector<Arrival> lastAtVertex(instance.graph->vertexCount(), kNone);
        for (Arrival a = 0; a < nextOfRobot_.size(); ++a)
        {
            Arrival &ofRobot = lastOfRobot[robot(a)];
            if (ofRobot != kNone)
                nextOfRobot_[ofRobot] = a;
            ofRobot = a;
            Arrival &atVertex = lastAtVertex[vertex(a)];
            previousAtVertex_[a] = atVertex;
            if (atVertex != kNone)
                nextAtVertex_[atVertex] = a;
            atVertex = a;
        }
        if (!rotations.empty())
            countRotated(rotations);
    }

    [[nodiscard]] std::size_t size() const { return nextOfRobot_.size(); }

    /// Removes the robot's walks that begin with arrival a and come back with nobody having been there; and
    /// those that this makes redundant.
    void removeFrom(Arrival a)
    {
        waiting_.push_back(a);
        while (!waiting_.empty())
        {
            const Arrival first = waiting_.back();
            waiting_.pop_back();
            while (isRedundantFrom(first))
                removeWalk(first, nextAtVertex_[first]);
        }
    }

    /// The moves that are left, in order.
    [[nodiscard]] Solution take(std::span<const Solution::Rotation> rotations)
    {
        std::size_t kept = 0;
        std::size_t next = 0;
        std::vector<Solution::Rotation> shifted;
        for (std::size_t i = 0; i < moves_.size(); ++i)
        {
            if (next < rotations.size() && rotations[next].first == i)
            {
                shifted.push_back({kept, rotations[next].size});
                ++next;
            }
            if (moves_[i].robot != kNoRobot)
                moves_[kept++] = moves_[i];
        }
        moves_.resize(kept);
        return {std::move(moves_), std::move(shifted)};
    }

private:
    [[nodiscard]] Robot robot(Arrival a) const { return a < robots_ ? a : moves_[a - robots_].robot; }
    [[nodiscard]] Vertex vertex(Arrival a) const
    {
        return a < robots_ ? instance_.starts[a] : moves_[a - robots_].to;
    }
    [[nodiscard]] bool isRemoved(Arrival a) const { return robot(a) == kNoRobot; }

    [[nodiscard]] bool isRedundantFrom(Arrival a) const
    {
        if (isRemoved(a))
            return false;
        const Arrival back = nextAtVertex_[a];
        return back != kNone && robot(back) == robot(a) &&
               (rotated_.empty() || rotated_[back] == rotated_[a]);
    }

    /// Deletes the robot's arrivals after `first` up to and including `last`.
    void removeWalk(Arrival first, Arrival last)
    {
        Arrival a = nextOfRobot_[first];
        nextOfRobot_[first] = nextOfRobot_[last];
        for (bool more = true; more;)
        {
            more = a != last;
            const Arrival before = previousAtVertex_[a];
            const Arrival after = nextAtVertex_[a];
            if (before != kNone)
                nextAtVertex_[before] = after;
            if (after != kNone)
                previousAtVertex_[after] = before;
            if (before != kNone && after != kNone && before != first && robot(before) == robot(after))
                waiting_.push_back(before);
            moves_[a - robots_].robot = kNoRobot;
            a = nextOfRobot_[a];
        }
    }

    /// rotated_[a] = how many of its robot's moves up to a are part of a rotation.
    void countRotated(std::span<const Solution::Rotation> rotations)
    {
        rotated_.assign(size(), 0);
        for (const Solution::Rotation &rotation : rotations)
            for (std::size_t i = 0; i < rotation.size; ++i)
                rotated_[robots_ + rotation.first + i] = 1;
        for (Robot r = 0; r < robots_; ++r)
            for (Arrival a = r; nextOfRobot_[a] != kNone; a = nextOfRobot_[a])
                rotated_[nextOfRobot_[a]] += rotated_[a];
    }

    const Instance &instance_;
    std::vector<Move> &moves_; ///< a removed move's robot is kNoRobot
    Arrival robots_;
    std::vector<Arrival> nextOfRobot_;
    std::vector<Arrival> nextAtVertex_;
    std::vector<Arrival> previousAtVertex_;
    std::vector<std::uint32_t> rotated_; ///< empty without rotations
    std::vector<Arrival> waiting_;       ///< arrivals from which a walk may have become redundant
};

} // namespace

Solution RedundancyRemoval::improve(const Instance &instance, Solution solution,
                                    const TerminationCondition &ptc) const
{
    // Arrivals are numbered with 32 bits; a longer solution is left as it is.
    if (solution.pathLength() + instance.robotCount() >= kNone)
        return solution;
    const std::vector<Solution::Rotation> rotations(solution.rotations().begin(), solution.rotations().end());
    std::vector<Move> moves = std::move(solution).releaseMoves();
    Arrivals arrivals(instance, moves, rotations);
    constexpr Arrival kPollInterval = 4096;
    for (Arrival a = 0; a < arrivals.size(); ++a)
    {
        if (a % kPollInterval == 0 && ptc())
            break;
        arrivals.removeFrom(a);
    }
    return arrivals.take(rotations);
}

} // namespace mrpp
