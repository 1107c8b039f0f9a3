#include "framework/run/RunPlanner.h"

#include "framework/LateAnswer.h"
#include "framework/run/InProcessExecutor.h"
#include "tests/campaign/Fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace mrpp
{
namespace
{

using testing::HasSubstr;
using testing::StartsWith;

/// Two robots on a 2 × 4 grid: 0 → 2 and 4 → 7, five moves.
PreparedInstance question()
{
    fixtures::Lanes lanes;
    lanes.parameters().set("rows", "2");
    lanes.parameters().set("length", "4");
    return prepare(std::make_shared<const Instance>(
        Instance{lanes.makeGraph(0), std::vector<Vertex>{0, 4}, std::vector<Vertex>{2, 7}}));
}

RunResult run(const std::string &planner, const std::vector<std::string> &optimizers = {},
              const RunSettings &settings = {}, const std::stop_token &stop = {})
{
    const Catalog catalog = fixtures::catalog();
    const auto instance = catalog.planners.create(planner);
    if (planner == "walker")
        instance->parameters().set("detours", "3");
    std::vector<NamedOptimizer> chain;
    for (const std::string &name : optimizers)
        chain.push_back({name, catalog.optimizers.create(name)});
    return runPlanner(*instance, question(), chain, settings, stop);
}

void expectNoLengths(const RunRecord &record)
{
    EXPECT_EQ(record.pathLength, std::nullopt);
    EXPECT_EQ(record.actions, std::nullopt);
    EXPECT_EQ(record.makespan, std::nullopt);
    EXPECT_EQ(record.sumOfCosts, std::nullopt);
    EXPECT_EQ(record.optimizedPathLength, std::nullopt);
    EXPECT_EQ(record.solutionFingerprint, "");
    EXPECT_EQ(record.completed, 0);
}

/// Arranges its memory until it is told to stop, or for ten seconds.
class SlowStarter final : public Planner
{
public:
    SlowStarter() : Planner({.citation = "", .motion = MotionRule::pebble, .completeFor = ""}) {}
    void setup() override
    {
        const auto late = TerminationCondition::after(10);
        while (!setupCondition()() && !late())
            ;
    }
    PlannerStatus solve(const TerminationCondition &) override
    {
        solved_ = true;
        return PlannerStatus::gave_up;
    }
    [[nodiscard]] bool solveWasCalled() const { return solved_; }

private:
    bool solved_ = false;
};

TEST(RunPlanner, EndsSetupAtTheTimeLimitAndDoesNotSolveThen)
{
    SlowStarter planner;
    const RunResult result = runPlanner(planner, question(), {}, {.limits = {.time = 0.05}}, {});
    EXPECT_EQ(result.record.status, PlannerStatus::timeout);
    EXPECT_EQ(result.record.terminationReason, "walltime");
    EXPECT_EQ(result.record.reason, "setup() took all of the time limit of 0.05 s");
    EXPECT_GE(result.record.setupTime, 0.05);
    EXPECT_LT(result.record.setupTime, 5);
    EXPECT_FALSE(planner.solveWasCalled());
}

TEST(RunPlanner, EndsSetupWhenTheUserStopsIt)
{
    SlowStarter planner;
    std::stop_source stop;
    stop.request_stop();
    const RunResult result = runPlanner(planner, question(), {}, {}, stop.get_token());
    EXPECT_EQ(result.record.status, PlannerStatus::aborted);
    EXPECT_FALSE(planner.solveWasCalled());
}

TEST(RunPlanner, EndsWhenTheWholeRunHasToBeOver)
{
    SlowStarter planner;
    RunSettings settings;
    settings.until = TerminationCondition::after(0.05);
    EXPECT_EQ(runPlanner(planner, question(), {}, settings, {}).record.status, PlannerStatus::timeout);
}

TEST(Prepare, SaysLessWhereThereIsNoTime)
{
    const auto instance = question().instance;
    const PreparedInstance all = prepare(instance);
    EXPECT_EQ(all.bounds->means, BoundMeans::distances);
    EXPECT_TRUE(all.oneAtATime->solvable);
    const PreparedInstance nothing = prepare(instance, 0);
    EXPECT_EQ(nothing.fingerprint, all.fingerprint);
    EXPECT_EQ(nothing.oneAtATime.has_value(), false);
    EXPECT_EQ(nothing.withRotations.has_value(), false);
    EXPECT_EQ(nothing.bounds->means, BoundMeans::displaced);
    EXPECT_EQ(nothing.bounds->pathLength, 2U);
}

TEST(Prepare, TakesAQuarterOfTheTimeLimitOrAFifthOfASecond)
{
    EXPECT_EQ(preparationTime(60), 15);
    EXPECT_EQ(preparationTime(0.000001), 0.2);
}

/// Counts up for a fifth of a second.
class Counter final : public Planner
{
public:
    Counter() : Planner({.citation = "", .motion = MotionRule::pebble, .completeFor = ""})
    {
        addProgressProperty("count", [this] { return static_cast<double>(count_.load()); });
    }
    PlannerStatus solve(const TerminationCondition &) override
    {
        const auto enough = TerminationCondition::after(0.2);
        while (!enough())
            ++count_;
        return because(PlannerStatus::gave_up, "counted");
    }

private:
    std::atomic<std::int64_t> count_ = 0;
};

/// Solves at once and needs long to hand its answer over.
class SlowReader final : public Planner, public LateAnswer
{
public:
    SlowReader() : Planner({.citation = "", .motion = MotionRule::pebble, .completeFor = ""}) {}
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::solved; }
    PlannerStatus collect() override
    {
        const std::vector<char> text(100'000'000, 'x');
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        return text[0] == 'x' ? because(PlannerStatus::gave_up, "nothing in it") : PlannerStatus::solved;
    }
};

TEST(RunPlanner, CollectsAnswersOutsideOfTheRunsTimeAndMemory)
{
    SlowReader reader;
    const RunResult result = runPlanner(reader, question(), {}, {.limits = {.time = 0.05, .memory = 50}}, {});
    EXPECT_EQ(result.record.status, PlannerStatus::gave_up);
    EXPECT_EQ(result.record.reason, "nothing in it");
    EXPECT_LT(result.record.time.value(), 0.05);
    EXPECT_LT(result.record.memory.value(), 50);
}

TEST(RunPlanner, SamplesWhatAPlannerShowsWhileItWorks)
{
    Counter counter;
    const RunResult result = runPlanner(counter, question(), {}, {}, {});
    EXPECT_EQ(result.progress.names, std::vector<std::string>{"count"});
    const auto &samples = result.progress.samples;
    ASSERT_GE(samples.size(), 2U); // every 50 ms, on a busy machine less often
    for (std::size_t i = 1; i < samples.size(); ++i)
    {
        EXPECT_GE(samples[i].time, samples[i - 1].time);
        EXPECT_GE(samples[i].values.at(0), samples[i - 1].values.at(0));
    }
    EXPECT_GT(samples.back().values.at(0), 0);
    EXPECT_TRUE(run("walker").progress.samples.empty());
}

TEST(RunPlanner, MeasuresASolution)
{
    const RunResult result = run("walker");
    const RunRecord &record = result.record;
    EXPECT_EQ(record.status, PlannerStatus::solved);
    EXPECT_EQ(record.reason, "");
    EXPECT_EQ(record.vertices, 8);
    EXPECT_EQ(record.edges, 10);
    EXPECT_EQ(record.robots, 2);
    EXPECT_EQ(record.free, 6);
    EXPECT_EQ(record.occupancy, 0.25);
    EXPECT_EQ(record.pathLengthLowerBound, 5);
    EXPECT_EQ(record.makespanLowerBound, 3);
    EXPECT_EQ(record.pathLength, 11);
    EXPECT_EQ(record.actions, 11);
    EXPECT_EQ(record.makespan, 8); // robot 0 alone; robot 1 walks meanwhile
    EXPECT_EQ(record.sumOfCosts, 11);
    EXPECT_EQ(record.completed, 1);
    EXPECT_EQ(record.optimizedPathLength, std::nullopt);
    EXPECT_EQ(record.optimizationTime, std::nullopt);
    EXPECT_EQ(record.solutionFingerprint, result.solution.fingerprint());
    EXPECT_EQ(record.motion, "rotation");
    EXPECT_GE(record.time.value(), 0);
    EXPECT_GE(record.setupTime.value(), 0);
    EXPECT_GE(record.memory.value(), 0);
    EXPECT_LT(record.memory.value(), 5); // its own, not the process's
}

TEST(RunPlanner, MeasuresAnOptimizedSolutionBesideTheFirst)
{
    const RunResult result = run("walker", {"trimmer"});
    EXPECT_EQ(result.record.status, PlannerStatus::solved);
    EXPECT_EQ(result.record.pathLength, 11);
    EXPECT_EQ(result.record.optimizedPathLength, 5);
    EXPECT_EQ(result.record.optimizedActions, 5);
    EXPECT_EQ(result.record.optimizedMakespan, 3);
    EXPECT_EQ(result.record.optimizedSumOfCosts, 5);
    EXPECT_GE(result.record.optimizationTime.value(), 0);
    EXPECT_EQ(result.solution.pathLength(), 11U);
    EXPECT_EQ(result.optimized.pathLength(), 5U);
}

TEST(RunPlanner, LeavesMemoryOutWhereOthersShareTheProcess)
{
    EXPECT_EQ(run("walker", {}, {.ownProcess = false}).record.memory, std::nullopt);
}

/// Times the walker, whose repeats make that many detours.
RunRecord timed(std::int64_t repeats, const std::vector<std::string> &detours)
{
    const Catalog catalog = fixtures::catalog();
    std::size_t made = 0;
    const auto make = [&]
    {
        auto planner = catalog.planners.create("walker");
        planner->parameters().set("pause", "0.002");
        planner->parameters().set("detours", detours[std::min(made++, detours.size() - 1)]);
        return planner;
    };
    RunSettings settings;
    settings.timingRepeats = repeats;
    settings.warmUp = 1;
    settings.again = make;
    const auto planner = make();
    RunRecord record = runPlanner(*planner, question(), {}, settings, {}).record;
    EXPECT_EQ(made, static_cast<std::size_t>(repeats) + 1);
    return record;
}

TEST(RunPlanner, TimesRepeatedly)
{
    const RunRecord record = timed(5, {"3"});
    EXPECT_EQ(record.timed, 5);
    EXPECT_EQ(record.repeatable, "yes");
    EXPECT_EQ(record.pathLength, 11);
    EXPECT_GE(record.timeMin.value(), 0.002);
    EXPECT_LE(record.timeMin.value(), record.time.value());
    EXPECT_LE(record.time.value(), record.timeMax.value());
    EXPECT_LE(record.timeIqr.value(), *record.timeMax - *record.timeMin);
}

TEST(RunPlanner, RecordsThatARepeatGaveAnotherSolution)
{
    const RunRecord record = timed(3, {"3", "3", "3", "4"});
    EXPECT_EQ(record.status, PlannerStatus::solved);
    EXPECT_EQ(record.pathLength, 11);
    EXPECT_EQ(record.repeatable,
              "no: the same question and seed had another solution when it was solved again");
}

TEST(RunPlanner, DoesNotRepeatWhatDidNotEndWithAnAnswer)
{
    RunSettings settings;
    settings.timingRepeats = 3;
    settings.again = []() -> std::unique_ptr<Planner> { throw std::logic_error("asked again"); };
    const RunRecord record = run("thrower", {}, settings).record;
    EXPECT_EQ(record.status, PlannerStatus::crash);
    EXPECT_EQ(record.timed, std::nullopt);
    EXPECT_EQ(record.repeatable, "");
}

TEST(RunPlanner, TellsTheCpuTimeOfSolving)
{
    RunSettings settings;
    settings.limits.cpu = 0.05;
    Counter counter;
    const RunRecord record = runPlanner(counter, question(), {}, settings, {}).record;
    EXPECT_GT(record.cpuTime.value(), 0);
}

TEST(RunPlanner, CallsAnExceptionACrash)
{
    const RunRecord record = run("thrower").record;
    EXPECT_EQ(record.status, PlannerStatus::crash);
    EXPECT_EQ(record.reason, "threw: no luck");
    EXPECT_TRUE(record.time.has_value());
    expectNoLengths(record);
    EXPECT_EQ(run("ball_thrower").record.status, PlannerStatus::crash);
}

TEST(RunPlanner, CallsAnExceptionInSetupACrash)
{
    const RunRecord record = run("setup_thrower").record;
    EXPECT_EQ(record.status, PlannerStatus::crash);
    EXPECT_EQ(record.reason, "threw: no setup today");
    EXPECT_EQ(record.time, std::nullopt);
}

TEST(RunPlanner, CallsBadAllocTheMemoryLimit)
{
    const RunRecord record = run("eater").record;
    EXPECT_EQ(record.status, PlannerStatus::memory_limit);
    EXPECT_EQ(record.reason, "out of memory");
    expectNoLengths(record);
}

TEST(RunPlanner, StopsAHangingPlannerAtTheTimeLimit)
{
    const RunRecord record = run("hanger", {}, {.limits = {.time = 0.05}}).record;
    EXPECT_EQ(record.status, PlannerStatus::timeout);
    EXPECT_GE(record.time.value(), 0.05);
    EXPECT_LT(record.time.value(), 5);
    expectNoLengths(record);
}

TEST(RunPlanner, TakesNoAnswerThatComesTooLate)
{
    const RunSettings strict{.limits = {.time = 0.05}, .grace = 0.05};
    const RunResult late = run("sleeper", {}, strict);
    EXPECT_EQ(late.record.status, PlannerStatus::timeout);
    EXPECT_THAT(late.record.reason, HasSubstr("the limit is 0.05 s"));
    EXPECT_TRUE(late.solution.empty());
    expectNoLengths(late.record);

    const RunSettings gentle{.limits = {.time = 0.05}, .grace = 60};
    EXPECT_EQ(run("sleeper", {}, gentle).record.status, PlannerStatus::solved);
}

TEST(RunPlanner, PassesOnWhatThePlannerSays)
{
    EXPECT_EQ(run("quitter").record.status, PlannerStatus::gave_up);
    EXPECT_EQ(run("quitter").record.reason, "too hard");
    EXPECT_EQ(run("shrugger").record.status, PlannerStatus::crash);
    expectNoLengths(run("quitter").record);
}

/// Two robots on a triangle that is full, to change places: rotations keep their cyclic order.
PreparedInstance unsolvableQuestion()
{
    return prepare(std::make_shared<const Instance>(
        Instance{Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}}), {0, 1, 2}, {1, 0, 2}}));
}

TEST(RunPlanner, DoesNotBelieveThatASolvableInstanceIsInfeasible)
{
    const RunRecord lie = run("prover").record;
    EXPECT_EQ(lie.status, PlannerStatus::invalid);
    EXPECT_EQ(lie.reason, "called a solvable instance infeasible: proof");
    EXPECT_EQ(lie.solvable, "yes");

    const auto prover = fixtures::catalog().planners.create("prover");
    const RunRecord truth = runPlanner(*prover, unsolvableQuestion(), {}, {}, {}).record;
    EXPECT_EQ(truth.status, PlannerStatus::infeasible);
    EXPECT_EQ(truth.reason, "proof");
}

TEST(RunPlanner, SaysWhetherTheInstanceIsSolvableUnderThePlannersRule)
{
    const auto recordOf = [](const char *name, const PreparedInstance &prepared)
    { return runPlanner(*fixtures::catalog().planners.create(name), prepared, {}, {}, {}).record; };
    const RunRecord unsolvable = recordOf("quitter", unsolvableQuestion());
    EXPECT_EQ(unsolvable.status, PlannerStatus::gave_up);
    EXPECT_EQ(unsolvable.solvable, "no");
    EXPECT_EQ(unsolvable.unsolvableReason, "robot 0 cannot leave 0 for its goal 1: no vertex is free");
    EXPECT_EQ(recordOf("turner", unsolvableQuestion()).unsolvableReason,
              "the cyclic order 0, 1, 2 of robots on the polygon {0, 1, 2} would have to become 0, 2, 1");

    const PreparedInstance turn = prepare(std::make_shared<const Instance>(
        Instance{Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}}), {0, 1, 2}, {1, 2, 0}}));
    EXPECT_EQ(recordOf("quitter", turn).solvable, "no");
    EXPECT_EQ(recordOf("turner", turn).solvable, "yes");
    EXPECT_EQ(recordOf("turner", turn).unsolvableReason, "");
}

TEST(RunPlanner, DoesNotBelieveAnEmptySolution)
{
    const RunResult result = run("liar");
    EXPECT_EQ(result.record.status, PlannerStatus::invalid);
    EXPECT_FALSE(result.record.reason.empty());
    expectNoLengths(result.record);
}

TEST(RunPlanner, RefusesAnIllegalMoveAndKeepsNothingOfIt)
{
    const RunResult result = run("jumper", {"trimmer"});
    EXPECT_EQ(result.record.status, PlannerStatus::invalid);
    EXPECT_FALSE(result.record.reason.empty());
    EXPECT_TRUE(result.solution.empty());
    expectNoLengths(result.record);
}

TEST(RunPlanner, MeasuresAPartialSolution)
{
    const RunResult result = run("half", {"trimmer"});
    EXPECT_EQ(result.record.status, PlannerStatus::partial);
    EXPECT_EQ(result.record.reason, "only robot 0");
    EXPECT_EQ(result.record.pathLength, 2);
    EXPECT_EQ(result.record.completed, 0.5);
    EXPECT_EQ(result.record.optimizedPathLength, std::nullopt);
    EXPECT_EQ(result.solution.pathLength(), 2U);
}

TEST(RunPlanner, ChecksTheMovesOfAPartialSolution)
{
    EXPECT_EQ(run("bad_half").record.status, PlannerStatus::invalid);
}

TEST(RunPlanner, DoesNotAskAPlannerThatRejects)
{
    const RunRecord record = run("picky").record;
    EXPECT_EQ(record.status, PlannerStatus::unsupported);
    EXPECT_EQ(record.reason, "not my kind");
    EXPECT_EQ(record.setupTime, std::nullopt);
    EXPECT_EQ(record.time, std::nullopt);
}

TEST(RunPlanner, DoesNotAskAPlannerOfAWiderMotionRule)
{
    EXPECT_EQ(run("turner").record.status, PlannerStatus::partial);
    const RunRecord record = run("turner", {}, {.motion = MotionRule::following}).record;
    EXPECT_EQ(record.status, PlannerStatus::unsupported);
    EXPECT_EQ(record.reason,
              "its solutions need the motion rule 'rotation', which is wider than 'following'");
    EXPECT_EQ(record.motion, "following");
}

TEST(RunPlanner, NamesTheOptimizerThatSpoilsASolution)
{
    const RunResult broken = run("walker", {"trimmer", "breaker"});
    EXPECT_EQ(broken.record.status, PlannerStatus::invalid);
    EXPECT_THAT(broken.record.reason, StartsWith("optimizer 'breaker' broke the solution: "));
    EXPECT_TRUE(broken.solution.empty());
    expectNoLengths(broken.record);

    const RunRecord longer = run("walker", {"stretcher"}).record;
    EXPECT_EQ(longer.status, PlannerStatus::invalid);
    EXPECT_EQ(longer.reason, "optimizer 'stretcher' lengthened the solution from 11 to 13 moves");

    const RunRecord failed = run("walker", {"failing"}).record;
    EXPECT_EQ(failed.status, PlannerStatus::crash);
    EXPECT_EQ(failed.reason, "optimizer 'failing' threw: lost count");
}

TEST(RunPlanner, EndsEarlyWhereItIsStopped)
{
    std::stop_source stop;
    stop.request_stop();
    const RunRecord record = run("hanger", {}, {}, stop.get_token()).record;
    EXPECT_EQ(record.status, PlannerStatus::aborted);
    EXPECT_LT(record.setupTime.value(), 5);
    EXPECT_FALSE(record.time.has_value()); // solve() was not called any more
}

TEST(RunPlanner, CallsGrowthBeyondTheLimitTheMemoryLimit)
{
    class Glutton final : public Planner
    {
    public:
        Glutton() : Planner({}) {}
        PlannerStatus solve(const TerminationCondition &) override
        {
            food_.assign(std::size_t{64} << 20, 'x');
            return because(PlannerStatus::gave_up, "full");
        }

    private:
        std::vector<char> food_;
    };
    Glutton few;
    const RunRecord record = runPlanner(few, question(), {}, {.limits = {.memory = 20}}, {}).record;
    EXPECT_EQ(record.status, PlannerStatus::memory_limit);
    EXPECT_THAT(record.reason, HasSubstr("the limit is 20 MB"));
    Glutton many;
    EXPECT_EQ(runPlanner(many, question(), {}, {.limits = {.memory = 2000}}, {}).record.status,
              PlannerStatus::gave_up);
}

} // namespace
} // namespace mrpp
