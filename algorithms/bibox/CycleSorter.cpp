#include "algorithms/bibox/CycleSorter.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace mrpp
{

namespace
{

/// The longest strictly ascending subsequence. O(k log k).
std::vector<std::size_t> longestAscending(std::span<const std::size_t> keys)
{
    constexpr auto kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> last; // of the best sequences of length 1, 2, …: the index of their last key
    std::vector<std::size_t> before(keys.size(), kNone);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
        const auto slot = std::lower_bound(last.begin(), last.end(), keys[i],
                                           [&](std::size_t j, std::size_t key) { return keys[j] < key; });
        if (slot != last.begin())
            before[i] = *(slot - 1);
        if (slot == last.end())
            last.push_back(i);
        else
            *slot = i;
    }
    std::vector<std::size_t> result;
    for (std::size_t i = last.empty() ? kNone : last.back(); i != kNone; i = before[i])
        result.push_back(i);
    std::reverse(result.begin(), result.end());
    return result;
}

} // namespace

CycleSorter::CycleSorter(Carrier &carrier, std::span<const Robot> goalRobots)
    : carrier_(carrier), board_(carrier.board()), goalRobots_(goalRobots),
      cycle_(carrier.open().ears().cycle()), places_(board_.graph().vertexCount(), 0),
      goalPlaces_(board_.robotCount(), 0), waiting_(board_.robotCount(), 0)
{
    for (std::size_t i = 0; i < cycle_.size(); ++i)
    {
        places_[cycle_[i]] = i;
        if (goalRobots_[cycle_[i]] != kNoRobot)
            goalPlaces_[goalRobots_[cycle_[i]]] = i;
    }
}

bool CycleSorter::sort()
{
    std::vector<Robot> waiting = misplaced();
    if (waiting.empty())
        return align();

    for (const Robot r : waiting)
        waiting_[r] = 1;
    const Pocket pocket = findPocket(waiting.front());
    const Robot guest = board_.occupant(pocket.vertex);
    if (guest != kNoRobot)
    {
        carrier_.makeFree(at(pocket.place));
        board_.move(guest, at(pocket.place));
    }
    while (!waiting.empty())
    {
        const Robot r = takeNearest(pocket.place, waiting);
        if (!insert(r, successor(r), pocket))
            return false;
    }
    if (guest != kNoRobot)
    {
        if (!carrier_.carry(guest, at(pocket.place)))
            return false;
        board_.move(guest, pocket.vertex);
    }
    return align();
}

/// From that place once around.
std::vector<Robot> CycleSorter::robotsFrom(std::size_t place) const
{
    std::vector<Robot> robots;
    for (std::size_t i = 0; i < cycle_.size(); ++i)
        if (!board_.isFree(at(place + i)))
            robots.push_back(board_.occupant(at(place + i)));
    return robots;
}

/// The fewest robots without whom the others stand in the cyclic order of their goals.
std::vector<Robot> CycleSorter::misplaced() const
{
    const std::vector<Robot> robots = robotsFrom(0);
    if (robots.size() < 3) // two are always in order
        return {};
    // One of the others is the first: all of them are tried on a short cycle, some on a long one.
    constexpr std::size_t kTries = 100;
    const std::size_t stride = robots.size() / kTries + 1;
    std::vector<Robot> best = robots;
    std::vector<std::size_t> keys(robots.size());
    for (std::size_t first = 0; first < robots.size() && !carrier_.stopped(); first += stride)
    {
        for (std::size_t i = 0; i < robots.size(); ++i)
            keys[i] = (goalPlaces_[robots[(first + i) % robots.size()]] + cycle_.size() -
                       goalPlaces_[robots[first]]) %
                      cycle_.size();
        const std::vector<std::size_t> kept = longestAscending(keys);
        if (robots.size() - kept.size() >= best.size())
            continue;
        best.clear();
        for (std::size_t i = 0; i < robots.size(); ++i)
            if (!std::binary_search(kept.begin(), kept.end(), i))
                best.push_back(robots[(first + i) % robots.size()]);
    }
    return best;
}

/// The shorter way around, in steps.
std::size_t CycleSorter::distance(std::size_t a, std::size_t b) const
{
    const std::size_t ahead = (a + cycle_.size() - b) % cycle_.size();
    return std::min(ahead, cycle_.size() - ahead);
}

/// One that is free if there is one, else the nearest to the first robot that has to use it.
CycleSorter::Pocket CycleSorter::findPocket(Robot user) const
{
    Pocket best;
    std::pair<bool, std::size_t> bestKey;
    for (std::size_t i = 0; i < cycle_.size(); ++i)
        for (const Vertex v : board_.graph().neighbors(cycle_[i]))
        {
            if (carrier_.open().isOpen(v))
                continue;
            const std::pair<bool, std::size_t> key(!board_.isFree(v), distance(place(user), i));
            if (best.vertex == kNoVertex || key < bestKey)
            {
                best = {i, v};
                bestKey = key;
            }
        }
    assert(best.vertex != kNoVertex);
    return best;
}

Robot CycleSorter::takeNearest(std::size_t place, std::vector<Robot> &robots) const
{
    const auto nearest = std::min_element(
        robots.begin(), robots.end(),
        [&](Robot a, Robot b) { return distance(this->place(a), place) < distance(this->place(b), place); });
    const Robot r = *nearest;
    robots.erase(nearest);
    return r;
}

/// The next robot behind the goal of r that is on the cycle to stay.
Robot CycleSorter::successor(Robot r) const
{
    for (std::size_t i = 1; i < cycle_.size(); ++i)
    {
        const Robot next = goalRobots_[at(goalPlaces_[r] + i)];
        if (next != kNoRobot && waiting_[next] == 0)
            return next;
    }
    return kNoRobot;
}

/// r waits in the pocket until the robot before which it belongs has just passed.
bool CycleSorter::insert(Robot r, Robot before, const Pocket &pocket)
{
    if (!carrier_.carry(r, at(pocket.place)))
        return false;
    board_.move(r, pocket.vertex);
    if (!carrier_.carry(before, at(pocket.place + 1)))
        return false;
    carrier_.makeFree(at(pocket.place), at(pocket.place + 1));
    board_.move(r, at(pocket.place));
    waiting_[r] = 0;
    return true;
}

/// Everybody goes to the goal, all in the direction in which the moves are fewest.
bool CycleSorter::align()
{
    const std::vector<Robot> robots = robotsFrom(0);
    if (robots.empty())
        return true;
    const auto size = static_cast<std::ptrdiff_t>(cycle_.size());
    // How far each has to go, if the first one does not go beyond the place where places begin.
    std::vector<std::ptrdiff_t> way(robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i)
    {
        const std::size_t behindFirst =
            (goalPlaces_[robots[i]] + cycle_.size() - goalPlaces_[robots.front()]) % cycle_.size();
        way[i] = static_cast<std::ptrdiff_t>(goalPlaces_[robots.front()] + behindFirst) -
                 static_cast<std::ptrdiff_t>(place(robots[i]));
    }
    const auto moves = [&](std::ptrdiff_t turns)
    {
        std::ptrdiff_t sum = 0;
        for (const std::ptrdiff_t w : way)
            sum += std::abs(w + turns * size);
        return sum;
    };
    std::ptrdiff_t turns = 0;
    for (const std::ptrdiff_t other : {-1, 1})
        if (moves(other) < moves(turns))
            turns = other;

    std::vector<std::ptrdiff_t> left(board_.robotCount(), 0);
    for (std::size_t i = 0; i < robots.size(); ++i)
        left[robots[i]] = way[i] + turns * size;
    std::vector<Robot> stack;
    for (const Robot robot : robots)
    {
        stack.assign({robot});
        while (!stack.empty())
        {
            const Robot r = stack.back();
            if (left[r] == 0)
            {
                stack.pop_back();
                continue;
            }
            if (carrier_.stopped())
                return false;
            const std::ptrdiff_t step = left[r] > 0 ? 1 : -1;
            const Vertex next = at(place(r) + cycle_.size() + static_cast<std::size_t>(step));
            if (board_.isFree(next))
            {
                board_.move(r, next);
                left[r] -= step;
            }
            else
            {
                stack.push_back(board_.occupant(next));
            }
        }
    }
    return true;
}

} // namespace mrpp
