#include "algorithms/mapp/Units.h"

#include "algorithms/mapp/GoalOrder.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace mrpp::mapp
{

Units::Units(const Instance &instance, const PebbleBoard &board, PathFinder &paths, const Settings &settings,
             Random *random, const TerminationCondition &ptc)
    : instance_(instance), board_(board), settings_(settings), isGoal_(board.graph().vertexCount(), 0),
      robotsHere_(board.graph().vertexCount(), kNoRobot),
      alternates_(board.graph(), isGoal_, settings.longestDetour), offsets_(1, 0), crossedOffsets_(1, 0),
      stamps_(board.graph().vertexCount(), 0)
{
    const std::size_t robots = instance.robotCount();
    offsets_.reserve(robots + 1);
    refusals_.assign(robots, Refusal::none);
    for (Robot r = 0; r < robots; ++r)
    {
        isGoal_[instance.goals[r]] = 1;
        robotsHere_[instance.goals[r]] = r;
    }
    for (Robot r = 0; r < robots; ++r)
    {
        if (ptc())
            return;
        plan(r, paths, ptc);
        numbers_.resize(path_.size(), Alternates::kNone);
        offsets_.push_back(static_cast<std::uint32_t>(path_.size()));
        findCrossed(r);
    }
    isolateGoals();
    if (!ptc())
        rankUnits(random, ptc);
}

std::size_t Units::slidableCount() const
{
    std::size_t count = 0;
    for (Robot r = 0; r < refusals_.size(); ++r)
        count += isSlidable(r) ? 1U : 0U;
    return count;
}

/// Finds the path of r and what belongs to it, or says why it has none.
void Units::plan(Robot r, PathFinder &paths, const TerminationCondition &ptc)
{
    const Vertex start = board_.position(r);
    const Vertex goal = instance_.goals[r];
    const PathFinder::Cost crossing = PathFinder::kStep * (1 + settings_.crossingPrice);
    ++stamp_;
    for (const Vertex v : board_.graph().neighbors(start))
        if (!board_.isFree(v))
            stamps_[v] = stamp_; // would be no initial blank
    const auto enterCost = [&](Vertex v) -> PathFinder::Cost
    {
        if (stamps_[v] == stamp_ && v != goal)
            return PathFinder::kImpassable;
        return isGoal_[v] != 0 && v != goal ? crossing : PathFinder::kStep;
    };
    const auto *path = &paths.find(start, goal, enterCost, ptc);
    if (path->empty() || (path->size() == 2 && !board_.isFree(goal)))
        refusals_[r] = Refusal::noBlank;
    if (path->empty())
    {
        ++stamp_; // it cannot start by itself, but may be set free
        path = &paths.find(start, goal, enterCost, ptc);
    }
    if (path->empty())
    {
        refusals_[r] = Refusal::noPath;
        return;
    }
    path_.insert(path_.end(), path->begin(), path->end());
    numbers_.resize(path_.size(), Alternates::kNone);
    findAlternates(r);
}

/// *Alternate connectivity* of the path that was planned last.
void Units::findAlternates(Robot r)
{
    const Vertex *l = path_.data() + offsets_[r];
    const std::size_t size = path_.size() - offsets_[r];
    bool connected = true;
    for (std::size_t i = 1; i + 2 < size; ++i)
    {
        const std::uint32_t number = alternates_.find(l[i - 1], l[i], l[i + 1], instance_.goals[r]);
        numbers_[offsets_[r] + i] = number;
        connected &= number != Alternates::kNone;
    }
    if (!connected && refusals_[r] == Refusal::none && (!settings_.tunnels || !bufferTunnels(r)))
        refusals_[r] = Refusal::noAlternate;
}

/// Finds a zone for each tunnel; false, and no zones, where one has none.
bool Units::bufferTunnels(Robot r)
{
    const std::span<const Vertex> l(path_.data() + offsets_[r], path_.size() - offsets_[r]);
    const std::size_t zonesBefore = zones_.size();
    std::size_t zoneBegin = 0;
    ++stamp_; // marks the alternate paths that are used before the zone is
    for (std::size_t i = 1; i + 2 < l.size(); ++i)
    {
        if (numbers_[offsets_[r] + i] != Alternates::kNone)
        {
            for (const Vertex v : alternates_.path(numbers_[offsets_[r] + i]))
                stamps_[v] = stamp_;
            continue;
        }
        const std::size_t first = i;
        while (i + 3 < l.size() && numbers_[offsets_[r] + i + 1] == Alternates::kNone)
            ++i;
        const std::size_t behind = bufferBehind(r, l, first, i, zoneBegin);
        if (behind == 0 && (first + 1 < zoneBegin || !keepFree(r, l, first, i)))
        {
            zones_.resize(zonesBefore);
            zoneOffsets_.resize(zonesBefore + 1);
            zoneVertices_.resize(zoneOffsets_.back());
            return false;
        }
        zoneBegin = std::max(zoneBegin, behind);
    }
    return true;
}

/// A buffer zone behind the tunnel of the steps first … last: the next vertices of the path that are in no
/// zone before it and not marked, until there is one free for each step, and some more, so that others are
/// not held up. They do not reach to the goal.
/// \returns the index after the zone; 0 where the path is too short
std::size_t Units::bufferBehind(Robot r, std::span<const Vertex> l, std::size_t first, std::size_t last,
                                std::size_t zoneBegin)
{
    constexpr std::uint32_t kMore = 4;
    const auto need = static_cast<std::uint32_t>(last - first + 1);
    std::uint32_t free = 0;
    std::size_t next = std::max(zoneBegin, last + 2);
    for (; next + 1 < l.size() && free < need + kMore; ++next)
    {
        if (stamps_[l[next]] == stamp_)
            continue;
        free += board_.isFree(l[next]) ? 1U : 0U;
        zoneVertices_.push_back(l[next]);
    }
    if (free < need)
    {
        zoneVertices_.resize(zoneOffsets_.back());
        return 0;
    }
    addZone({r, static_cast<std::uint32_t>(last), need});
    return next;
}

/// Where there is no room behind the tunnel, but nobody in it either, it is a zone itself that stays free.
bool Units::keepFree(Robot r, std::span<const Vertex> l, std::size_t first, std::size_t last)
{
    const std::span<const Vertex> entered = l.subspan(first + 1, last - first + 1);
    if (!std::all_of(entered.begin(), entered.end(),
                     [&](Vertex v) { return board_.isFree(v) && stamps_[v] != stamp_; }))
        return false;
    zoneVertices_.insert(zoneVertices_.end(), entered.begin(), entered.end());
    addZone({r, static_cast<std::uint32_t>(last), static_cast<std::uint32_t>(entered.size())});
    return true;
}

void Units::addZone(const Zone &zone)
{
    zones_.push_back(zone);
    zoneOffsets_.push_back(static_cast<std::uint32_t>(zoneVertices_.size()));
}

/// The goals of others on the path of r, and on its alternate paths.
void Units::findCrossed(Robot r)
{
    ++stamp_;
    const auto touch = [&](Vertex v)
    {
        const Robot other = robotsHere_[v];
        if (other == kNoRobot || other == r || stamps_[v] == stamp_)
            return;
        stamps_[v] = stamp_;
        crossed_.push_back(other);
    };
    const std::span<const Vertex> l = path(r);
    for (std::size_t i = 0; i < l.size(); ++i)
    {
        touch(l[i]);
        for (const Vertex v : alternate(r, i))
            touch(v);
    }
    crossedOffsets_.push_back(static_cast<std::uint32_t>(crossed_.size()));
}

/// Takes SLIDABLE from r, and from the robot whose goal is where r may stay, and so on.
/// \returns all of them
std::vector<Robot> Units::refuse(Robot r, Refusal why)
{
    std::vector<Robot> lost;
    for (bool first = true; r != kNoRobot && (first || refusals_[r] == Refusal::none); first = false)
    {
        if (refusals_[r] == Refusal::none)
            refusals_[r] = first ? why : Refusal::goalTaken;
        lost.push_back(r);
        r = robotsHere_[board_.position(r)];
    }
    return lost;
}

/// *Target isolation*, strict: no goal is touched.
void Units::isolateGoals()
{
    for (Robot r = 0; r < refusals_.size(); ++r)
    {
        if (refusals_[r] != Refusal::none)
            refuse(r, refusals_[r]);
        if (!settings_.orderedGoals && length(r) > 0)
            for (const Robot other : crossed(r))
                refuse(other, Refusal::goalCrossed);
    }
}

/// Orders the robots so that nobody goes before one whose paths touch its goal. Where these touch each
/// other's goals in a circle, one of the circle is no longer SLIDABLE.
void Units::rankUnits(Random *random, const TerminationCondition &ptc)
{
    using Next = std::tuple<std::uint64_t, std::uint64_t, Robot>; // path length, tie-break, robot
    std::priority_queue<Next, std::vector<Next>, std::greater<>> ready;
    GoalOrder goals(*this);
    const auto key = [&](Robot r)
    {
        const std::uint32_t steps = length(r);
        return random == nullptr ? Next(steps, r, r)
                                 : Next(steps + random->below(steps + 1), random->bits(), r);
    };
    for (const Robot r : goals.takeReady())
        ready.push(key(r));
    for (;;)
    {
        while (!ready.empty())
        {
            const Robot r = std::get<2>(ready.top());
            ready.pop();
            order_.push_back(r);
            goals.remove(r);
            for (const Robot other : goals.takeReady())
                ready.push(key(other));
        }
        const Robot r = ptc() ? kNoRobot : goals.fromCircle();
        if (r == kNoRobot)
            break;
        for (const Robot lost : refuse(r, Refusal::goalOrder))
            goals.remove(lost);
        for (const Robot other : goals.takeReady())
            ready.push(key(other));
    }
    const std::size_t sure = order_.size();
    for (Robot r = 0; r < refusals_.size(); ++r)
        if (settings_.attemptAll && !isSlidable(r) && length(r) > 0)
            order_.push_back(r);
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(sure), order_.end(),
              [&](Robot a, Robot b) { return std::pair(length(a), a) < std::pair(length(b), b); });
}

std::string Units::refusal(Robot r) const
{
    const std::string goal = "vertex " + std::to_string(instance_.goals[r]);
    switch (refusals_[r])
    {
    case Refusal::noPath:
        return "no path leads to its goal, " + goal;
    case Refusal::noBlank:
        return "no neighbouring vertex on a way to its goal, " + goal + ", is free";
    case Refusal::noAlternate:
        return "its way to " + goal +
               " has a passage that cannot be gone around, and too few free vertices "
               "behind it";
    case Refusal::goalCrossed:
        return "others need to pass over its goal, " + goal;
    case Refusal::goalOrder:
        return "its path to " + goal + " and other robots' paths cross each other's goals";
    case Refusal::goalTaken:
        return "a robot that is not provided for stands on its goal, " + goal;
    case Refusal::none:
        break;
    }
    return {};
}

} // namespace mrpp::mapp
