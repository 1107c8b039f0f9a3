#include "algorithms/Mapp.h"

#include "algorithms/mapp/Traffic.h"

#include <algorithm>
#include <string>

namespace mrpp
{

namespace
{

/// Who is missing in the end, and why the first of them was not sure to arrive; "" where nobody is.
std::string describeRest(const Instance &instance, const PebbleBoard &board, const mapp::Units *units,
                         std::size_t slidable)
{
    std::size_t missing = 0;
    Robot first = kNoRobot;
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        if (board.position(r) == instance.goals[r])
            continue;
        ++missing;
        first = std::min(first, r);
    }
    if (missing == 0)
        return {};
    return std::to_string(missing) + " of " + std::to_string(instance.robotCount()) +
           " robots are not at their goals; the " + std::to_string(slidable) +
           " that were provided for (SLIDABLE) are. The first one missing is robot " + std::to_string(first) +
           ": " + units->refusal(first);
}

} // namespace

Mapp::Mapp()
    : RestartingPlanner(
          {.citation = "K.-H. C. Wang, A. Botea, MAPP: a Scalable Multi-Agent Path Planning Algorithm with "
                       "Tractability and Completeness Guarantees, JAIR 42 (2011) 55-90",
           .motion = MotionRule::pebble,
           .completeFor = "instances whose robots are all SLIDABLE; of any instance, those that are arrive",
           .version = 2, // 2: paths within their weights, landmarks of components
           .provesInfeasibility = false})
{
    declareParam("target_isolation", targetIsolation_, "ordered,strict",
                 "goals may be crossed by robots that go first (TI), or by nobody");
    declareParam("tunnels", tunnels_, "",
                 "passages without a way around are taken if there is room behind them (AC)");
    declareParam("repositioning", repositioning_, "counting,undo",
                 "robots are taken back as far as needed (RC), or all the way");
    declareParam("attempt_all", attemptAll_, "", "robots that are not SLIDABLE try, too");
    declareParam("alternate_length", alternateLength_, "2:1000",
                 "most steps of an alternate path; a goal on it counts four more");
    declareParam("crossing_price", crossingPrice_, "0:28",
                 "steps that a path goes around rather than cross another robot's goal");
    addProgressProperty("slidable", [this] { return static_cast<double>(slidable_); });
    addProgressProperty("arrived", [this] { return static_cast<double>(arrived_); });
}

void Mapp::clear()
{
    Planner::clear();
    landmarks_.reset();
    slidable_ = 0;
    arrived_ = 0;
}

void Mapp::setup()
{
    landmarks_ = std::make_unique<Landmarks>(graph(), setupCondition());
}

mapp::Settings Mapp::settings() const
{
    return {.orderedGoals = targetIsolation_ == "ordered",
            .tunnels = tunnels_,
            .counting = repositioning_ == "counting",
            .attemptAll = attemptAll_,
            .longestDetour = static_cast<std::uint32_t>(alternateLength_),
            .crossingPrice = static_cast<PathFinder::Cost>(crossingPrice_)};
}

std::vector<Robot> Mapp::slidableRobots() const
{
    const mapp::Settings settings = this->settings();
    PathFinder paths(graph(), *landmarks_);
    const PebbleBoard board(instance());
    const mapp::Units units(instance(), board, paths, settings, nullptr, {});
    std::vector<Robot> robots;
    for (Robot r = 0; r < instance().robotCount(); ++r)
        if (units.isSlidable(r))
            robots.push_back(r);
    return robots;
}

RestartingPlanner::Outcome Mapp::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    const mapp::Settings settings = this->settings();
    PathFinder paths(graph(), *landmarks_);
    PebbleBoard board(instance());
    if (ptc())
        return {PlannerStatus::timeout, {}, {}};
    Random random(attemptSeed(number));
    const std::size_t robots = instance().robotCount();
    std::size_t slidable = 0;
    std::size_t home = 0;
    std::unique_ptr<const mapp::Units> latest; // of the last round that brought somebody home, or the first
    PebbleBoard::Mark useful = board.mark();   // what comes after it brought nobody home
    // After a round everybody is planned for anew, as long as that brings more robots home: who was at home
    // is SLIDABLE then, and may be passed.
    for (std::size_t round = 0, before = 0; home < robots && (round == 0 || home > before); ++round)
    {
        before = home;
        std::vector<char> solved(robots, 0);
        auto units = std::make_unique<mapp::Units>(instance(), board, paths, settings,
                                                   number == 0 ? nullptr : &random, ptc);
        if (ptc())
            return {PlannerStatus::timeout, {}, {}};
        if (round == 0)
            slidable_ = slidable = units->slidableCount();
        mapp::Traffic traffic(instance(), *units, settings, board, solved, ptc);
        PebbleBoard::Mark fruitful = board.mark();
        std::size_t now = 0;
        for (std::size_t arrived = 1; arrived > 0 && now < robots;)
        {
            arrived = traffic.progression();
            now += arrived;
            if (ptc() && now < robots)
                return {PlannerStatus::timeout, {}, {}};
            if (arrived > 0)
                fruitful = board.mark();
            if (now < robots)
                traffic.repositioning();
            arrived_ = std::max<std::size_t>(arrived_, now);
        }
        if (now > home)
        {
            home = now;
            useful = fruitful;
        }
        if (round == 0 || home > before)
            latest = std::move(units);
        if (!settings.attemptAll)
            break;
    }
    board.rollback(useful);
    std::string reason = describeRest(instance(), board, latest.get(), slidable);
    return {reason.empty() ? PlannerStatus::solved : PlannerStatus::partial, std::move(reason),
            board.takeSolution()};
}

} // namespace mrpp
