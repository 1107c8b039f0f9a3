#include "algorithms/TrailPlanner.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "algorithms/pebble/PebbleOperations.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace mrpp
{

namespace
{

/// Moves one robot to another place in the order, or exchanges two.
void perturb(std::vector<Robot> &order, Random &random)
{
    if (order.empty())
        return;
    const auto a = order.begin() + static_cast<std::ptrdiff_t>(random.below(order.size()));
    const auto b = order.begin() + static_cast<std::ptrdiff_t>(random.below(order.size()));
    if (random.below(3) == 0)
        std::iter_swap(a, b);
    else if (a < b)
        std::rotate(a, a + 1, b + 1);
    else
        std::rotate(b, a, a + 1);
}

} // namespace

TrailPlanner::Preparation::Preparation(const Instance &instance, MotionRule rule, Landmarks landmarksOfGraph,
                                       Blocks blocksOfGraph, const TerminationCondition &ptc)
    : landmarks(std::move(landmarksOfGraph)), blocks(std::move(blocksOfGraph)),
      subgraphs(*instance.graph, blocks, rule, instance.starts),
      assignment(subgraphs.assignment(instance.starts)), priorities(subgraphs, instance, assignment),
      unswappable(mrpp::unswappable(instance)), farFirst(mrpp::farFirst(instance, landmarks)),
      confining(BlockRoute::isWorthwhile(blocks) ? &blocks : nullptr)
{
    const Components components(*instance.graph);
    std::vector<char> counted(components.count(), 0);
    for (const Vertex start : instance.starts)
        if (const std::uint32_t c = components.of(start); std::exchange(counted[c], 1) == 0)
            vertices += components.size(c);
    if (!ptc() && !isObviouslySolvable(instance, components))
        verdict = solvability(instance, rule, ptc).value_or(Solvability{});
}

/// Whether all robots of each component in which somebody moves belong to one subgraph, wherever they are:
/// then any permutation can be reached. Spares the question in the usual cases.
bool TrailPlanner::Preparation::isObviouslySolvable(const Instance &instance,
                                                    const Components &components) const
{
    const std::vector<std::uint32_t> atGoals = subgraphs.assignment(instance.goals);
    std::vector<char> moving(components.count(), 0);
    std::vector<std::uint32_t> only(components.count(), kNoSubgraph);
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        if (components.of(instance.starts[r]) != components.of(instance.goals[r]))
            return false;
        moving[components.of(instance.starts[r])] |= instance.starts[r] != instance.goals[r] ? 1 : 0;
    }
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        const std::uint32_t component = components.of(instance.starts[r]);
        if (moving[component] == 0)
            continue;
        std::uint32_t &one = only[component];
        one = one == kNoSubgraph ? atGoals[r] : one;
        if (unswappable[r] != 0 || one == kNoSubgraph || one != atGoals[r] || one != assignment[r])
            return false;
    }
    return true;
}

TrailPlanner::TrailPlanner(PlannerSpecs specs) : RestartingPlanner(std::move(specs))
{
    declareParam(
        "order", order_, "far_first,given,random",
        "who plans first within a subgraph: goals far from the graph's centre, the instance's order, "
        "or chance");
    declareParam("swap_price", swapPrice_, "0:25",
                 "steps that a robot goes around rather than swap with one that has arrived");
    addProgressProperty("fallbacks",
                        [this] { return static_cast<double>(fallbacks_.load(std::memory_order_relaxed)); });
}

void TrailPlanner::clear()
{
    Planner::clear();
    prepared_.reset();
    mostMoves_ = std::numeric_limits<std::size_t>::max();
    fallbacks_ = 0;
}

void TrailPlanner::setup()
{
    const TerminationCondition &ptc = setupCondition();
    Landmarks landmarks(graph(), ptc);
    if (ptc())
        return;
    Blocks blocks(graph());
    if (ptc())
        return;
    prepared_ = std::make_unique<const Preparation>(instance(), specs().motion, std::move(landmarks),
                                                    std::move(blocks), ptc);
}

RestartingPlanner::Outcome TrailPlanner::attempt(std::uint64_t number, const TerminationCondition &ptc) const
{
    if (!prepared_->verdict.solvable)
        return {PlannerStatus::infeasible, prepared_->verdict.reason, {}};
    Random random(attemptSeed(number));
    if (number > 0)
        return searchNearby(random, ptc);

    const Choices first = firstChoices(random);
    if (ptc())
        return {PlannerStatus::timeout, {}, {}};
    Outcome outcome = runMainLoop(first, nullptr, ptc);
    // Other orders, then the long way that always works.
    constexpr int kOtherOrders = 10;
    for (int i = 0; i < kOtherOrders && outcome.status == PlannerStatus::gave_up; ++i)
        outcome = runMainLoop(randomChoices(random), &random, ptc);
    if (outcome.status == PlannerStatus::gave_up)
        outcome = fallBack(ptc);
    // What is so much longer before redundancy removal is not shorter after it.
    constexpr std::size_t kMostLengthening = 2;
    if (outcome.status == PlannerStatus::solved)
        mostMoves_ = kMostLengthening * outcome.solution.pathLength();
    return outcome;
}

TrailPlanner::Choices TrailPlanner::firstChoices(Random &random) const
{
    Choices choices{.order = prepared_->farFirst, .settings = settings()};
    if (order_ != "far_first")
        std::iota(choices.order.begin(), choices.order.end(), Robot{0});
    if (order_ == "random")
        random.shuffle(std::span(choices.order));
    return choices;
}

TrailPlanner::Choices TrailPlanner::randomChoices(Random &random) const
{
    Choices choices{.order = prepared_->farFirst, .settings = settings()};
    if (random.below(2) == 0)
        random.shuffle(std::span(choices.order));
    for (int i = 0; i < 3; ++i)
        perturb(choices.order, random);
    choices.settings.randomizePrices(random);
    return choices;
}

TrailSettings TrailPlanner::settings() const
{
    // How often robots may be sent back on the way, on average, before an order is given up.
    constexpr std::size_t kSetbacksPerRobot = 4;
    return {.arrivedPrice = PathFinder::kStep * (1 + static_cast<PathFinder::Cost>(swapPrice_)),
            .blocks = prepared_->confining,
            .unswappable = &prepared_->unswappable,
            .mostSetbacks = 50 + kSetbacksPerRobot * instance().robotCount()};
}

/// An attempt of chance. On small graphs, where a run of the main loop takes microseconds, it goes on from
/// the best choices so far by small changes.
RestartingPlanner::Outcome TrailPlanner::searchNearby(Random &random, const TerminationCondition &ptc) const
{
    constexpr std::size_t kMostRuns = 8;
    constexpr std::size_t kVertices = 512; ///< over all runs
    const std::size_t runs =
        std::clamp<std::size_t>(kVertices / std::max<std::size_t>(1, prepared_->vertices), 1, kMostRuns);
    Choices choices = randomChoices(random);
    choices.settings.mostMoves = mostMoves_;
    Choices tried = choices;
    Outcome best = runMainLoop(choices, &random, ptc);
    if (runs == 1)
        return best;
    std::size_t fewest = lengthWithoutRedundancy(best, ptc);
    for (std::size_t i = 1; i < runs && !ptc(); ++i)
    {
        tried.order = choices.order;
        tried.settings = choices.settings;
        perturb(tried.order, random);
        perturb(tried.order, random);
        if (random.below(4) == 0)
            tried.settings.randomizePrices(random);
        Outcome outcome = runMainLoop(tried, &random, ptc);
        const std::size_t length = lengthWithoutRedundancy(outcome, ptc);
        if (length > fewest)
            continue;
        fewest = length;
        best = std::move(outcome);
        std::swap(choices, tried);
    }
    return best;
}

std::size_t TrailPlanner::lengthWithoutRedundancy(const Outcome &outcome,
                                                  const TerminationCondition &ptc) const
{
    if (outcome.status != PlannerStatus::solved)
        return std::numeric_limits<std::size_t>::max();
    return RedundancyRemoval().improve(instance(), outcome.solution, ptc).pathLength();
}

RestartingPlanner::Outcome TrailPlanner::runMainLoop(const Choices &choices, Random *random,
                                                     const TerminationCondition &ptc) const
{
    return start({&choices, random, ptc});
}

RestartingPlanner::Outcome TrailPlanner::fallBack(const TerminationCondition &ptc) const
{
    ++fallbacks_;
    return start({nullptr, nullptr, ptc});
}

/// Those on paths and polygons.
std::vector<Robot> TrailPlanner::unswappableRobots() const
{
    std::vector<Robot> robots;
    for (Robot r = 0; r < instance().robotCount(); ++r)
        if (prepared_->unswappable[r] != 0)
            robots.push_back(r);
    return robots;
}

} // namespace mrpp
