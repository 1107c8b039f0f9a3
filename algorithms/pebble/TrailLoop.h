#pragma once
/// \file
/// The main loop of Push and Rotate (*solve*): robots go home one after another, and those that had arrived
/// and had to give way are brought back along a *trail*.
///
/// The trail is the walk of the robots that travelled since everybody who had arrived was at home. A robot
/// that had arrived and was swapped away stands on the trail, one edge from its goal, which is the trail's
/// next vertex. Unwinding the trail brings these robots back, the last first; where another robot stands on
/// such a goal, that one travels next, and the trail grows. Where the trail closes, the closed piece is a
/// cycle of the graph, and everybody on it goes one vertex on: *rotate*.
///
/// Source: B. de Wilde, A. W. ter Mors, C. Witteveen, "Push and Rotate: a complete multi-agent pathfinding
/// algorithm", JAIR 51 (2014) 443–492, algorithms 6–8. Differences: paths go around robots that have arrived
/// when that is cheaper than a swap; the trail is unwound as soon as it can be; a closed piece of two
/// vertices is no cycle and becomes a push or a swap; where neither push nor swap works, because the robot
/// in the way belongs to a subgraph that is planned later, robots that have arrived are pushed away and
/// travel again.

#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/search/BlockRoute.h"
#include "algorithms/search/PathFinder.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// What the loop asks of a planner's operations. Each returns false where it cannot be done, and has changed
/// nothing then.
template <class T>
concept TrailOperations = requires(T operations, Robot r, Vertex v, const std::vector<char> *stay,
                                   std::span<const Vertex> vertices)
{
    /// r goes to the neighbouring vertex v, whose occupant gives way; robots with stay[robot] ≠ 0 stay.
    {
        operations.push(r, v, stay)
        } -> std::same_as<bool>;
    /// Two neighbours exchange places; all others are where they were.
    {
        operations.swap(r, r)
        } -> std::same_as<bool>;
    /// Every robot on the cycle goes one vertex on; all others are where they were.
    {
        operations.rotate(vertices)
        } -> std::same_as<bool>;
    /// Do not push robots onto these vertices where another one is near.
    operations.avoid(vertices);
};

/// Prices of paths and when to give up.
struct TrailSettings
{
    /// Of entering a vertex with a robot that has still to travel, and with one that has arrived. At most
    /// PathFinder::kMaxEnterCost, `noise` added.
    PathFinder::Cost waitingPrice = PathFinder::kStep * 2;
    PathFinder::Cost arrivedPrice = PathFinder::kStep * 11;
    /// Chance adds 0 … noise to the price of each vertex. \pre a power of two less one
    PathFinder::Cost noise = 0;
    std::uint64_t noiseSeed = 0;
    /// Of the graph: paths are looked for only in the blocks between their ends. Null: everywhere.
    const Blocks *blocks = nullptr;
    /// Nonzero where a robot cannot be swapped (on a path or a polygon): arrived robots are walls to it.
    const std::vector<char> *unswappable = nullptr;
    std::size_t mostMoves = std::numeric_limits<std::size_t>::max();
    std::size_t mostSetbacks = std::numeric_limits<std::size_t>::max();

    /// Prices of chance, for an attempt that is to differ from others.
    void randomizePrices(Random &random)
    {
        arrivedPrice = PathFinder::kStep * static_cast<PathFinder::Cost>(1 + random.below(25));
        waitingPrice = PathFinder::kStep + static_cast<PathFinder::Cost>(random.below(6));
        noise = static_cast<PathFinder::Cost>((1U << random.below(3)) - 1);
        noiseSeed = random.bits();
    }
};

template <TrailOperations Operations>
class TrailLoop
{
public:
    enum class End
    {
        solved,
        stuck,  ///< no way on, or over a limit; reason() says which
        stopped ///< by the termination condition
    };

    using Settings = TrailSettings;

    /// Keeps references to all of them.
    TrailLoop(const Instance &instance, PebbleBoard &board, Operations &operations, PathFinder &paths,
              const TerminationCondition &ptc, const Settings &settings)
        : instance_(instance), board_(board), operations_(operations), paths_(paths), ptc_(ptc),
          settings_(settings), arrived_(instance.robotCount(), 0), ranks_(instance.robotCount()),
          places_(instance.graph->vertexCount(), kNowhere)
    {
        if (settings.blocks != nullptr)
            route_.emplace(*settings.blocks);
    }

    /// Brings every robot home, in this order where nothing else is asked for.
    /// \param order each robot once
    [[nodiscard]] End run(std::span<const Robot> order)
    {
        order_ = order;
        for (std::size_t i = 0; i < order.size(); ++i)
            ranks_[order[i]] = i;
        for (Robot r = nextRobot(); r != kNoRobot; r = nextRobot())
        {
            if (!travel(r))
                return ptc_() ? End::stopped : End::stuck;
            arrived_[r] = 1;
            unwind();
        }
        return End::solved;
    }

    /// Why the loop got stuck: names robots and vertices.
    [[nodiscard]] const std::string &reason() const { return reason_; }
    /// How often a robot that had arrived had to travel again.
    [[nodiscard]] std::size_t setbacks() const { return setbacks_; }

private:
    static constexpr std::uint32_t kNowhere = static_cast<std::uint32_t>(-1);

    [[nodiscard]] bool atGoal(Robot r) const { return board_.position(r) == instance_.goals[r]; }
    [[nodiscard]] bool isDisplaced(Robot r) const { return r != kNoRobot && arrived_[r] != 0 && !atGoal(r); }

    Robot nextRobot()
    {
        if (const Robot r = std::exchange(urgent_, kNoRobot); r != kNoRobot)
            return r;
        while (next_ < order_.size() && arrived_[order_[next_]] != 0)
            ++next_;
        return next_ < order_.size() ? order_[next_] : kNoRobot;
    }

    /// Brings r to its goal.
    bool travel(Robot r)
    {
        if (trail_.empty() || trail_.back() != board_.position(r))
            appendToTrail(board_.position(r));
        const bool unswappable = settings_.unswappable != nullptr && (*settings_.unswappable)[r] != 0;
        const PathFinder::Cost arrivedPrice = unswappable ? PathFinder::kImpassable : settings_.arrivedPrice;
        const auto enterCost = [&](Vertex v) -> PathFinder::Cost
        {
            if (route_ && !route_->has(v))
                return PathFinder::kImpassable;
            const Robot other = board_.occupant(v);
            if (other == kNoRobot)
                return PathFinder::kStep + noise(v);
            // One that still has to go somewhere is pushed for about one move, which is hardly worth a
            // detour.
            if (arrived_[other] == 0)
                return settings_.waitingPrice + noise(v);
            return arrivedPrice == PathFinder::kImpassable ? arrivedPrice : arrivedPrice + noise(v);
        };
        while (!atGoal(r))
        {
            if (route_)
                route_->lead(board_.position(r), instance_.goals[r]);
            const std::vector<Vertex> &path =
                paths_.find(board_.position(r), instance_.goals[r], enterCost, ptc_);
            if (path.empty())
            {
                explain("robot " + std::to_string(r) + " has no way from vertex " +
                        std::to_string(board_.position(r)) + " to its goal " +
                        std::to_string(instance_.goals[r]));
                return false;
            }
            operations_.avoid(path);
            for (std::size_t i = 1; i < path.size(); ++i)
                if (ptc_() || !step(r, path[i]))
                    return false;
        }
        return true;
    }

    [[nodiscard]] PathFinder::Cost noise(Vertex v) const
    {
        if (settings_.noise == 0)
            return 0;
        const std::uint64_t mixed = (v ^ settings_.noiseSeed) * 0x9e3779b97f4a7c15U;
        return static_cast<PathFinder::Cost>(mixed >> 40U) & settings_.noise;
    }

    /// r goes to the neighbouring vertex v, and the trail with it.
    bool step(Robot r, Vertex v)
    {
        if (board_.mark() > settings_.mostMoves)
        {
            explain("more than " + std::to_string(settings_.mostMoves) + " moves");
            return false;
        }
        if (places_[v] != kNowhere)
        {
            if (!closeTrail(r, v))
                return false;
        }
        else if (!pushOrSwap(r, v))
        {
            return false;
        }
        appendToTrail(v);
        unwindEarly();
        return true;
    }

    /// r goes to v, where the trail was before: everybody on the closed piece goes one vertex on.
    bool closeTrail(Robot r, Vertex v)
    {
        cycle_.assign(trail_.begin() + places_[v], trail_.end());
        shortenTrail(places_[v]);
        if (cycle_.size() < 3)
            return pushOrSwap(r, v);
        const std::size_t before = displacedOnCycle();
        if (!operations_.rotate(cycle_))
        {
            explain("the cycle through vertices " + std::to_string(cycle_[0]) + " and " +
                    std::to_string(cycle_[1]) + " cannot be turned");
            return false;
        }
        displaced_ -= before;
        displaced_ += displacedOnCycle();
        return true;
    }

    [[nodiscard]] std::size_t displacedOnCycle() const
    {
        return static_cast<std::size_t>(std::count_if(
            cycle_.begin(), cycle_.end(), [this](Vertex v) { return isDisplaced(board_.occupant(v)); }));
    }

    /// r goes to the neighbouring vertex v: by a push, else by a swap, else by pushing away robots that have
    /// arrived, which then have to travel again.
    bool pushOrSwap(Robot r, Vertex v)
    {
        if (operations_.push(r, v, &arrived_))
            return true;
        const Robot s = board_.occupant(v);
        const bool wasDisplaced = isDisplaced(s);
        if (operations_.swap(r, s))
        {
            displaced_ -= wasDisplaced ? 1 : 0;
            displaced_ += isDisplaced(s) ? 1 : 0;
            return true;
        }
        if (ptc_())
            return false;
        const PebbleBoard::Mark mark = board_.mark();
        if (!operations_.push(r, v, nullptr))
        {
            explain("robot " + std::to_string(r) + " on vertex " + std::to_string(board_.position(r)) +
                    " can neither push robot " + std::to_string(s) + " off vertex " + std::to_string(v) +
                    " nor swap with it");
            return false;
        }
        return sendAgainSince(mark);
    }

    /// Robots that had arrived and are not at home travel again.
    bool sendAgainSince(PebbleBoard::Mark mark)
    {
        for (const Move &move : board_.moves().subspan(mark))
            sendAgain(move.robot);
        for (const Vertex v : trail_)
            sendAgain(board_.occupant(v));
        for (const Vertex v : cycle_)
            sendAgain(board_.occupant(v));
        shortenTrail(0);
        displaced_ = 0;
        blocked_ = false;
        if (setbacks_ <= settings_.mostSetbacks)
            return true;
        explain("robots that had arrived were pushed away again and again; the last was robot " +
                std::to_string(lastSetback_) + ", whose goal is vertex " +
                std::to_string(instance_.goals[lastSetback_]));
        return false;
    }

    void sendAgain(Robot s)
    {
        if (!isDisplaced(s))
            return;
        arrived_[s] = 0;
        next_ = std::min(next_, ranks_[s]);
        ++setbacks_;
        lastSetback_ = s;
    }

    void appendToTrail(Vertex v)
    {
        places_[v] = static_cast<std::uint32_t>(trail_.size());
        trail_.push_back(v);
    }

    void shortenTrail(std::size_t size)
    {
        while (trail_.size() > size)
        {
            places_[trail_.back()] = kNowhere;
            trail_.pop_back();
        }
    }

    /// After a robot arrived: those that gave way return, the last first. Where another robot stands on such
    /// a goal, that one travels next.
    void unwind()
    {
        while (!trail_.empty())
        {
            const Robot s = board_.occupant(trail_.back());
            if (isDisplaced(s))
            {
                const Robot blocker = board_.occupant(instance_.goals[s]);
                if (blocker != kNoRobot)
                {
                    displaced_ -= isDisplaced(blocker) ? 1 : 0;
                    arrived_[blocker] = 0;
                    urgent_ = blocker;
                    return;
                }
                board_.move(s, instance_.goals[s]);
                --displaced_;
            }
            shortenTrail(trail_.size() - 1);
        }
        blocked_ = false;
    }

    /// While a robot is still on its way: the whole trail behind it is unwound where nobody is in the way of
    /// those that return, and nothing happens otherwise.
    void unwindEarly()
    {
        if (displaced_ > 0)
        {
            if (blocked_)
                return;
            const PebbleBoard::Mark mark = board_.mark();
            for (std::size_t i = trail_.size() - 1; i-- > 0;)
            {
                const Robot s = board_.occupant(trail_[i]);
                if (!isDisplaced(s))
                    continue;
                if (!board_.isFree(instance_.goals[s]))
                {
                    // The last to give way waits until the vertex between it and its goal is free.
                    blocked_ = i + 2 < trail_.size();
                    board_.rollback(mark);
                    return;
                }
                board_.move(s, instance_.goals[s]);
            }
            displaced_ = 0;
        }
        blocked_ = false;
        const Vertex here = trail_.back();
        shortenTrail(0);
        appendToTrail(here);
    }

    void explain(std::string reason) { reason_ = std::move(reason); }

    const Instance &instance_;
    PebbleBoard &board_;
    Operations &operations_;
    PathFinder &paths_;
    const TerminationCondition &ptc_;
    Settings settings_;
    std::optional<BlockRoute> route_; ///< of the robot that travels
    std::span<const Robot> order_;
    std::size_t next_ = 0;           ///< in order_
    Robot urgent_ = kNoRobot;        ///< travels next
    std::vector<char> arrived_;      ///< nonzero once a robot was brought home; size = robots
    std::vector<std::size_t> ranks_; ///< of the robots in order_
    std::vector<Vertex> trail_; ///< a walk, each vertex once; its end is where the robot on its way stands
    std::vector<std::uint32_t> places_; ///< of the vertices on the trail; kNowhere for others
    std::vector<Vertex> cycle_;         ///< the piece of the trail that closed last
    std::size_t displaced_ = 0;         ///< robots that arrived and are not at home
    bool blocked_ = false;              ///< somebody else is in the way of those that return
    std::size_t setbacks_ = 0;
    Robot lastSetback_ = 0;
    std::string reason_;
};

} // namespace mrpp
