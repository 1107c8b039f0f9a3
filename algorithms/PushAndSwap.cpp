#include "algorithms/PushAndSwap.h"

#include "algorithms/pebble/Priorities.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace mrpp
{

namespace
{

/// One attempt: a board, an order of robots, and who has arrived.
class Attempt
{
public:
    /// \param unswappable nonzero where a robot cannot be swapped: those that have arrived are walls to it
    Attempt(const Instance &instance, PebbleBoard board, PathFinder &paths, std::vector<Robot> order,
            PathFinder::Cost swapPrice, const std::vector<char> &unswappable, const TerminationCondition &ptc)
        : instance_(instance), paths_(paths), order_(std::move(order)), unswappable_(unswappable), ptc_(ptc),
          board_(std::move(board)), operations_(board_, ptc), swapPrice_(PathFinder::kStep * (1 + swapPrice)),
          arrived_(instance.robotCount(), 0)
    {}

    PlannerStatus run()
    {
        // Each robot may be sent back on the way a few times, on average, before this order is given up.
        constexpr std::size_t kSetbacksPerRobot = 4;
        const std::size_t mostSetbacks = 50 + kSetbacksPerRobot * instance_.robotCount();
        while (const auto robot = nextRobot())
        {
            if (!travel(*robot))
                return ptc_() ? PlannerStatus::timeout : PlannerStatus::gave_up;
            arrived_[*robot] = 1;
            resolveAll();
            if (setbacks_ > mostSetbacks)
            {
                reason_ = "robots that had arrived were pushed away again and again; the last was robot " +
                          std::to_string(lastSetback_) + ", whose goal is vertex " +
                          std::to_string(instance_.goals[lastSetback_]);
                return PlannerStatus::gave_up;
            }
        }
        return PlannerStatus::solved;
    }

    [[nodiscard]] const std::string &reason() const { return reason_; }
    [[nodiscard]] Solution takeSolution() { return board_.takeSolution(); }

private:
    [[nodiscard]] bool atGoal(Robot r) const { return board_.position(r) == instance_.goals[r]; }

    /// The robot to plan next: one that blocks the return of another, one that was sent back, the next in
    /// order.
    std::optional<Robot> nextRobot()
    {
        while (!urgent_.empty())
        {
            const Robot r = urgent_.back();
            urgent_.pop_back();
            if (arrived_[r] == 0)
                return r;
        }
        while (next_ < order_.size())
        {
            const Robot r = order_[next_++];
            if (arrived_[r] == 0)
                return r;
        }
        return std::nullopt;
    }

    /// Brings r to its goal.
    bool travel(Robot r)
    {
        const PathFinder::Cost arrivedPrice = unswappable_[r] != 0 ? PathFinder::kImpassable : swapPrice_;
        const auto enterCost = [&](Vertex v) -> PathFinder::Cost
        {
            const Robot other = board_.occupant(v);
            if (other == kNoRobot)
                return PathFinder::kStep;
            // A robot that still has to go somewhere is pushed for about one move, which is worth no detour.
            return arrived_[other] == 0 ? PathFinder::kStep + 1 : arrivedPrice;
        };
        while (!atGoal(r))
        {
            const std::vector<Vertex> path =
                paths_.find(board_.position(r), instance_.goals[r], enterCost, ptc_);
            if (path.empty())
            {
                reason_ = "robot " + std::to_string(r) + " has no way from vertex " +
                          std::to_string(board_.position(r)) + " to its goal " +
                          std::to_string(instance_.goals[r]);
                return false;
            }
            operations_.avoid(path);
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                if (ptc_() || !step(r, path[i]))
                    return false;
                resolve();
            }
        }
        return true;
    }

    /// r goes to the neighbouring vertex v: by a push, else by a swap, else by pushing away robots that have
    /// arrived, which then have to travel again.
    bool step(Robot r, Vertex v)
    {
        if (operations_.push(r, v, &arrived_))
            return true;
        const Robot s = board_.occupant(v);
        if (operations_.swap(r, s))
        {
            if (arrived_[s] != 0)
                displaced_.push_back(s);
            return true;
        }
        const PebbleBoard::Mark mark = board_.mark();
        if (!operations_.push(r, v, nullptr))
        {
            reason_ = "robot " + std::to_string(r) + " on vertex " + std::to_string(board_.position(r)) +
                      " can neither push robot " + std::to_string(s) + " off vertex " + std::to_string(v) +
                      " nor swap with it";
            return false;
        }
        for (const Move &move : board_.moves().subspan(mark))
            if (arrived_[move.robot] != 0)
                sendAgain(move.robot);
        return true;
    }

    void sendAgain(Robot s)
    {
        arrived_[s] = 0;
        urgent_.push_back(s);
        ++setbacks_;
        lastSetback_ = s;
    }

    /// *Resolve*: robots that had arrived and were swapped one vertex back return as soon as their goals are
    /// free, the last one first.
    void resolve()
    {
        while (!displaced_.empty())
        {
            const Robot s = displaced_.back();
            const Vertex goal = instance_.goals[s];
            // One that was pushed away since travels again by itself.
            if (!atGoal(s) && arrived_[s] != 0)
            {
                if (!board_.isFree(goal) || !board_.graph().hasEdge(board_.position(s), goal))
                    return;
                board_.move(s, goal);
            }
            displaced_.pop_back();
        }
    }

    /// After a robot arrived nobody stands on the way back of the displaced ones but robots that were swapped
    /// there: these travel on next; whoever else cannot return travels again.
    void resolveAll()
    {
        resolve();
        while (!displaced_.empty())
        {
            const Robot s = displaced_.back();
            const Robot blocker = board_.occupant(instance_.goals[s]);
            if (blocker != kNoRobot && blocker != lastBlocker_ && arrived_[blocker] == 0 &&
                board_.graph().hasEdge(board_.position(s), instance_.goals[s]))
            {
                lastBlocker_ = blocker;
                urgent_.push_back(blocker);
                return;
            }
            displaced_.pop_back();
            if (!atGoal(s) && arrived_[s] != 0)
                sendAgain(s);
            resolve();
        }
        lastBlocker_ = kNoRobot;
    }

    const Instance &instance_;
    PathFinder &paths_;
    std::vector<Robot> order_;
    const std::vector<char> &unswappable_;
    const TerminationCondition &ptc_;
    PebbleBoard board_;
    PebbleOperations operations_;
    PathFinder::Cost swapPrice_;   ///< of a vertex on which a robot stands that has arrived
    std::vector<char> arrived_;    ///< nonzero once a robot was brought to its goal; size = robots
    std::vector<Robot> displaced_; ///< arrived, then swapped off their goals; a stack
    std::vector<Robot> urgent_;    ///< to be planned before the others; a stack
    std::size_t next_ = 0;         ///< in order_
    std::size_t setbacks_ = 0;     ///< how often an arrived robot had to travel again
    Robot lastSetback_ = 0;
    Robot lastBlocker_ = kNoRobot;
    std::string reason_;
};

} // namespace

PushAndSwap::PushAndSwap()
    : RestartingPlanner(
          {.citation =
               "R. Luna, K. E. Bekris, Push and Swap: Fast Cooperative Path-Finding with Completeness "
               "Guarantees, IJCAI 2011, pp. 294-300",
           .motion = MotionRule::pebble,
           .completeFor = "not complete; made for connected graphs with at least two free vertices",
           .version = 2, // 2: paths within their weights, landmarks of components
           .provesInfeasibility = false})
{
    declareParam("order", order_, "far_first,given,random",
                 "who plans first: goals far from the graph's centre, the instance's order, or chance");
    declareParam("attempts", attempts_, "1:1000",
                 "how many orders are tried where one fails; from the second on they are random");
    declareParam("swap_price", swapPrice_, "0:25",
                 "steps that a robot goes around rather than swap with one that has arrived");
}

void PushAndSwap::clear()
{
    Planner::clear();
    landmarks_.reset();
    farFirst_.clear();
    unswappable_.clear();
}

void PushAndSwap::setup()
{
    landmarks_ = std::make_unique<Landmarks>(graph(), setupCondition());
    if (setupCondition()())
        return;
    farFirst_ = farFirst(instance(), *landmarks_);
    unswappable_ = unswappable(instance());
}

std::vector<Robot> PushAndSwap::priorities(std::uint64_t attempt, std::int64_t retry) const
{
    const bool byChance = attempt > 0 || retry > 0 || order_ == "random";
    if (!byChance && order_ == "far_first")
        return farFirst_;
    std::vector<Robot> order(instance().robotCount());
    std::iota(order.begin(), order.end(), 0);
    if (byChance)
        Random(deriveSeed(attemptSeed(attempt), "order", retry)).shuffle(std::span(order));
    return order;
}

RestartingPlanner::Outcome PushAndSwap::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    PathFinder paths(graph(), *landmarks_);
    if (ptc())
        return {PlannerStatus::timeout, {}, {}};
    std::string reason;
    for (std::int64_t retry = 0; retry < attempts_; ++retry)
    {
        std::vector<Robot> order = priorities(number, retry);
        PebbleBoard board(instance());
        if (ptc())
            return {PlannerStatus::timeout, {}, {}};
        Attempt attempt(instance(), std::move(board), paths, std::move(order),
                        static_cast<PathFinder::Cost>(swapPrice_), unswappable_, ptc);
        const PlannerStatus status = attempt.run();
        if (status == PlannerStatus::solved)
            return {status, {}, attempt.takeSolution()};
        if (retry == 0)
            reason = attempt.reason();
        if (status != PlannerStatus::gave_up)
            return {status, reason, {}};
    }
    return {PlannerStatus::gave_up, reason, {}};
}

} // namespace mrpp
