#include "tests/exhaustive/Exhaustive.h"

#include "framework/Planner.h"
#include "framework/analysis/Solvability.h"
#include "framework/evaluation/Validator.h"
#include "tests/exhaustive/RandomFamilies.h"
#include "tests/exhaustive/Symmetries.h"
#include "tests/support/ConfigurationOrbits.h"
#include "tests/support/RandomCases.h"
#include "tests/support/ReasonCheck.h"
#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <thread>

namespace mrpp::test
{

namespace
{

constexpr std::size_t kDescribed = 20;

std::string describe(const Instance &instance, MotionRule rule)
{
    std::string edges;
    for (const Graph::Edge &edge : instance.graph->edges())
        edges += fmt::format("{}-{} ", edge.a, edge.b);
    return fmt::format("{} edges {}starts {} goals {}", toString(rule), edges,
                       fmt::join(instance.starts, " "), fmt::join(instance.goals, " "));
}

/// One thread's planners and counts.
class Checker
{
public:
    Checker(const Catalog &catalog, const ExhaustiveSettings &settings) : settings_(settings)
    {
        for (const std::string &name : catalog.planners.names())
        {
            const bool wanted = std::ranges::find(settings.planners, name) != settings.planners.end();
            auto planner = catalog.planners.create(name);
            if (settings.planners.empty() ? planner->specs().complete : wanted)
                planners_.emplace_back(name, std::move(planner));
        }
    }

    [[nodiscard]] const ExhaustiveResult &result() const { return result_; }

    void checkGraph(const std::shared_ptr<const Graph> &graph)
    {
        ++result_.graphs;
        for (std::size_t robots = 0; robots <= graph->vertexCount(); ++robots)
            for (const MotionRule rule : {MotionRule::pebble, MotionRule::rotation})
                checkInstances(graph, robots, rule);
    }

    void checkRandom(Seed seed)
    {
        checkRandom(seed, RandomGoals::moves);
        constexpr Seed kOthers = 5;
        if (seed % kOthers == 0)
            checkRandom(seed, RandomGoals::rotations);
        if (seed % kOthers == 1)
            checkRandom(seed, RandomGoals::chance);
    }

private:
    /// Where moves of the rule have made the instance, the oracle must say that it can be solved; elsewhere
    /// it is the judge of the planners.
    void checkRandom(Seed seed, RandomGoals goals)
    {
        const auto instance = std::make_shared<const Instance>(randomFamilyInstance(seed, goals));
        for (const MotionRule rule : {MotionRule::pebble, MotionRule::rotation})
        {
            const bool madeByMoves = goals == RandomGoals::moves ||
                                     (goals == RandomGoals::rotations && rule == MotionRule::rotation);
            const Solvability answer = solvability(*instance, rule);
            ++result_.instances;
            result_.solvable += answer.solvable ? 1U : 0U;
            if (madeByMoves && !answer.solvable)
                fail(*instance, rule, fmt::format("seed {}: the oracle says: {}", seed, answer.reason));
            askPlanners(instance, rule, madeByMoves || answer.solvable);
        }
    }

    void checkInstances(const std::shared_ptr<const Graph> &graph, std::size_t robots, MotionRule rule)
    {
        const ConfigurationOrbits orbits(*graph, robots, rule);
        const ReasonCheck check(graph, robots, rule, orbits);
        const Symmetries symmetries(*graph);
        const std::uint64_t reasons = graph->vertexCount() == settings_.vertices ? settings_.reasons : 1;
        std::uint64_t count = 0;
        for (const auto &goals : orbits.configurations())
        {
            if (!std::ranges::is_sorted(goals) || !symmetries.isFirst(goals))
                continue;
            const auto keeping = symmetries.keeping(goals);
            for (const auto &starts : orbits.configurations())
            {
                if (!Symmetries::isFirst(starts, goals, keeping))
                    continue;
                const bool forPlanners = count % settings_.every == settings_.first;
                const bool forReasons = settings_.oracle && count % reasons == 0;
                ++count;
                if (!forPlanners && !settings_.oracle)
                    continue;
                const auto instance = std::make_shared<const Instance>(Instance{graph, starts, goals});
                const bool solvable = orbits.of(starts) == orbits.of(goals);
                ++result_.instances;
                result_.solvable += solvable ? 1U : 0U;
                if (settings_.oracle)
                    checkOracle(check, *instance, rule, {solvable, forReasons});
                if (forPlanners)
                    askPlanners(instance, rule, solvable);
            }
        }
    }

    struct Expected
    {
        bool solvable;
        bool forReasons; ///< whether to check a reason
    };

    void checkOracle(const ReasonCheck &check, const Instance &instance, MotionRule rule, Expected expected)
    {
        const Solvability answer = solvability(instance, rule);
        if (answer.solvable != expected.solvable)
            fail(instance, rule, "the oracle is wrong: " + answer.reason);
        else if (!answer.solvable && expected.forReasons)
            checkReason(check, instance, rule, answer.reason);
    }

    void checkReason(const ReasonCheck &check, const Instance &instance, MotionRule rule,
                     const std::string &reason)
    {
        ++result_.reasons;
        const std::string complaint = check.complaint(instance, reason);
        if (!complaint.empty())
            fail(instance, rule, fmt::format("the reason '{}' is wrong: {}", reason, complaint));
    }

    /// Planners whose solvable instances are those of this rule.
    void askPlanners(const std::shared_ptr<const Instance> &instance, MotionRule rule, bool solvable)
    {
        for (auto &[name, planner] : planners_)
            if ((planner->specs().motion == MotionRule::rotation) == (rule == MotionRule::rotation))
                ask(name, *planner, instance, solvable);
    }

    void ask(const std::string &name, Planner &planner, const std::shared_ptr<const Instance> &instance,
             bool solvable)
    {
        PlannerTally &tally = result_.planners[name];
        const PlannerSpecs &specs = planner.specs();
        planner.setInstance(instance);
        planner.setSeed(1);
        if (planner.reasonToReject(*instance))
        {
            ++tally.rejected;
            return;
        }
        planner.setup();
        const PlannerStatus status = planner.solve(TerminationCondition::after(60));
        std::string wrong;
        if (status == PlannerStatus::solved)
            wrong = validate(*instance, planner.solution(), specs.motion).violation;
        if (status == PlannerStatus::unsupported)
            ++tally.rejected;
        else if (status == PlannerStatus::solved)
            ++tally.solved;
        else if (!solvable && status == PlannerStatus::infeasible)
            ++tally.infeasible;
        else if (!solvable && !specs.provesInfeasibility)
            ++tally.unsolved;
        else if (solvable && !specs.complete && status != PlannerStatus::infeasible)
            ++tally.unsolved;
        else
            wrong = fmt::format("ended as {}: {}", toString(status), planner.reason());
        if (wrong.empty())
            return;
        ++tally.failures;
        fail(*instance, specs.motion,
             fmt::format("{} ({}): {}", name, solvable ? "solvable" : "unsolvable", wrong));
    }

    void fail(const Instance &instance, MotionRule rule, const std::string &what)
    {
        ++result_.failures;
        if (result_.descriptions.size() < kDescribed)
            result_.descriptions.push_back(what + "\n    " + describe(instance, rule));
    }

    const ExhaustiveSettings &settings_;
    std::vector<std::pair<std::string, std::unique_ptr<Planner>>> planners_;
    ExhaustiveResult result_;
};

void join(ExhaustiveResult &all, const ExhaustiveResult &part)
{
    all.graphs += part.graphs;
    all.instances += part.instances;
    all.solvable += part.solvable;
    all.reasons += part.reasons;
    all.failures += part.failures;
    for (const auto &[name, tally] : part.planners)
    {
        PlannerTally &sum = all.planners[name];
        sum.solved += tally.solved;
        sum.infeasible += tally.infeasible;
        sum.unsolved += tally.unsolved;
        sum.rejected += tally.rejected;
        sum.failures += tally.failures;
    }
    for (const std::string &description : part.descriptions)
        if (all.descriptions.size() < kDescribed)
            all.descriptions.push_back(description);
}

/// Does the items 0 … count−1 in threads, each with a checker of its own.
template <class Work>
ExhaustiveResult inThreads(const Catalog &catalog, const ExhaustiveSettings &settings, std::size_t count,
                           Work &&work)
{
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::size_t done = 0;
    ExhaustiveResult all;
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < settings.threads; ++t)
            threads.emplace_back(
                [&]
                {
                    Checker checker(catalog, settings);
                    for (std::size_t i = next++; i < count; i = next++)
                    {
                        work(checker, i);
                        const std::scoped_lock lock(mutex);
                        ++done;
                        if (settings.progress)
                            settings.progress(done, count);
                    }
                    const std::scoped_lock lock(mutex);
                    join(all, checker.result());
                });
    }
    return all;
}

} // namespace

ExhaustiveResult checkSmallGraphs(const Catalog &catalog, const ExhaustiveSettings &settings)
{
    std::vector<std::shared_ptr<const Graph>> graphs;
    for (std::size_t n = settings.vertices; n > 0; --n) // the slow ones first
        for (auto &graph : connectedGraphs(n))
            graphs.push_back(std::move(graph));
    return inThreads(catalog, settings, graphs.size(),
                     [&](Checker &checker, std::size_t i) { checker.checkGraph(graphs[i]); });
}

ExhaustiveResult checkRandomInstances(const Catalog &catalog, const ExhaustiveSettings &settings)
{
    constexpr std::size_t kBatch = 1000;
    const std::size_t batches = (settings.random + kBatch - 1) / kBatch;
    return inThreads(catalog, settings, batches,
                     [&](Checker &checker, std::size_t batch)
                     {
                         const std::size_t end = std::min<std::size_t>(settings.random, (batch + 1) * kBatch);
                         for (std::size_t seed = batch * kBatch; seed < end; ++seed)
                             checker.checkRandom(seed);
                     });
}

std::string describe(const ExhaustiveResult &result)
{
    std::string text = fmt::format("{} graphs, {} instances, {} solvable, {} reasons checked\n",
                                   result.graphs, result.instances, result.solvable, result.reasons);
    for (const auto &[name, tally] : result.planners)
        text += fmt::format(
            "{:<16} solved {}, proved infeasible {}, unsolved {}, not its class {}, failures {}\n", name,
            tally.solved, tally.infeasible, tally.unsolved, tally.rejected, tally.failures);
    text += fmt::format("failures: {}\n", result.failures);
    for (const std::string &description : result.descriptions)
        text += "  " + description + "\n";
    return text;
}

} // namespace mrpp::test
