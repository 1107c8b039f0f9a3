#include "framework/run/RunPlanner.h"

#include "framework/LateAnswer.h"
#include "framework/evaluation/Metrics.h"
#include "framework/evaluation/Validator.h"
#include "framework/run/RepeatedTiming.h"
#include "framework/support/Config.h"
#include "framework/support/HarnessError.h"
#include "framework/system/CpuTime.h"
#include "framework/system/Memory.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/core.h>
#include <new>

namespace mrpp
{

namespace
{

constexpr MotionRule kCondenseUnder = MotionRule::following;

class Stopwatch
{
public:
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// How far the process grows above what it held at the beginning.
class MemoryWatch
{
public:
    explicit MemoryWatch(bool measure) : measure_(measure && forgetPeakMemory()), atStart_(peakMemory()) {}

    /// Notes the growth, which has its limit.
    void note(RunRecord &record, double limit) const
    {
        if (!measure_)
            return;
        const double growth = std::max(0.0, peakMemory() - atStart_);
        record.memory = growth;
        if (growth <= limit)
            return;
        record.status = PlannerStatus::memory_limit;
        record.terminationReason = "memory";
        record.reason = "grew by " + formatNumber(std::round(growth)) + " MB; the limit is " +
                        formatNumber(limit) + " MB";
    }

private:
    /// What earlier runs freed goes back to the system first, so that this run's growth is its own.
    static bool forgetPeakMemory()
    {
        releaseFreeMemory();
        return resetPeakMemory();
    }

    bool measure_;
    double atStart_; // MB
};

void end(RunRecord &record, PlannerStatus status, std::string reason)
{
    record.status = status;
    record.reason = std::move(reason);
}

/// Runs `work`; what it throws becomes the run's end. \param who begins the reason: "", "optimizer 'x': "
template <class Work>
void guarded(RunRecord &record, const std::string &who, Work &&work)
{
    try
    {
        work();
    }
    catch (const HarnessError &)
    {
        throw;
    }
    catch (const std::bad_alloc &)
    {
        end(record, PlannerStatus::memory_limit, who + "out of memory");
        record.terminationReason = "memory";
    }
    catch (const std::exception &error)
    {
        end(record, PlannerStatus::crash, who + "threw: " + error.what());
    }
    catch (...)
    {
        end(record, PlannerStatus::crash, who + "threw something that is no std::exception");
    }
}

/// \param rule the planner's own
void describeInstance(RunRecord &record, const PreparedInstance &prepared, MotionRule rule)
{
    record.rule = toString(rule);
    if (const auto &answer = prepared.solvability(rule))
    {
        record.solvable = answer->solvable ? "yes" : "no";
        record.unsolvableReason = answer->reason;
    }
    const Instance &instance = *prepared.instance;
    record.vertices = static_cast<std::int64_t>(instance.graph->vertexCount());
    record.edges = static_cast<std::int64_t>(instance.graph->edgeCount());
    record.robots = static_cast<std::int64_t>(instance.robotCount());
    record.free = static_cast<std::int64_t>(instance.freeCount());
    record.occupancy = instance.occupancy();
    record.instanceFingerprint = prepared.fingerprint;
    if (prepared.bounds)
    {
        record.pathLengthLowerBound = static_cast<std::int64_t>(prepared.bounds->pathLength);
        record.makespanLowerBound = static_cast<std::int64_t>(prepared.bounds->makespan);
        record.sumOfCostsLowerBound = record.pathLengthLowerBound;
        record.pathLengthBoundName = record.makespanBoundName = record.sumOfCostsBoundName =
            toString(prepared.bounds->means);
    }
    record.boundTime = prepared.boundTime;
    record.completed = measure(instance, Solution(), kCondenseUnder).completed;
}

void begin(RunPhase phase, const RunSettings &settings, const RunRecord &record)
{
    if (settings.onPhase)
        settings.onPhase(phase, record);
}

bool hasSolution(const RunRecord &record)
{
    return record.status == PlannerStatus::solved || record.status == PlannerStatus::partial;
}

/// An answer that came too late is none; and which limit it was that came first.
void judgeLimits(RunRecord &record, const RunSettings &settings)
{
    const auto tooLate = [&](double spent, double limit, const char *clock, const char *reason)
    {
        if (hasSolution(record) && spent > limit + settings.grace)
            end(record, PlannerStatus::timeout,
                fmt::format("answered after {} s{}; the limit is {} s", formatNumber(spent), clock,
                            formatNumber(limit)));
        if (record.status == PlannerStatus::timeout && (spent >= limit || settings.until()))
            record.terminationReason = reason;
    };
    tooLate(*record.time, settings.limits.time, "", "walltime");
    if (settings.limits.cpu && record.cpuTime)
        tooLate(*record.cpuTime, *settings.limits.cpu, " of CPU time", "cputime-soft");
    if (record.terminationReason == "cputime-soft" && record.reason.empty())
        record.reason =
            fmt::format("the CPU time limit of {} s came first", formatNumber(*settings.limits.cpu));
}

void endInSetup(RunRecord &record, const RunSettings &settings, const std::stop_token &stop)
{
    if (stop.stop_requested())
        return end(record, PlannerStatus::aborted, "stopped by the user");
    end(record, PlannerStatus::timeout,
        fmt::format("setup() took all of the time limit of {} s", formatNumber(settings.limits.time)));
    record.terminationReason = "walltime";
}

/// setup() and solve(), timed; the status is the planner's word, which nobody has checked yet.
void plan(Planner &planner, const RunSettings &settings, const std::stop_token &stop, RunRecord &record,
          Progress &progress)
{
    const auto withinTime = [&]
    {
        return TerminationCondition::after(settings.limits.time) || TerminationCondition::when(stop) ||
               settings.until;
    };
    begin(RunPhase::setup, settings, record);
    const Stopwatch setup;
    const TerminationCondition setupEnds = withinTime();
    planner.setSetupCondition(setupEnds);
    guarded(record, "", [&] { planner.setup(); });
    record.setupTime = setup.seconds();
    if (record.status == PlannerStatus::unknown && setupEnds())
        endInSetup(record, settings, stop);
    if (record.status != PlannerStatus::unknown)
        return;

    begin(RunPhase::solve, settings, record);
    const CpuWatch cpu;
    auto ptc = withinTime();
    if (settings.limits.cpu && settings.ownProcess)
        ptc = ptc || cpu.limit(*settings.limits.cpu);
    ProgressSampler sampler(planner);
    const Stopwatch solve;
    guarded(record, "",
            [&]
            {
                record.status = planner.solve(ptc);
                record.reason = planner.reason();
            });
    record.time = solve.seconds();
    if (settings.ownProcess)
        record.cpuTime = cpu.seconds();
    progress = sampler.finish();
    judgeLimits(record, settings);
    if (stop.stop_requested() && record.status != PlannerStatus::solved)
        end(record, PlannerStatus::aborted, "stopped by the user");
    else if (record.status == PlannerStatus::unknown)
        end(record, PlannerStatus::crash, "ended with the status 'unknown'");
}

/// Takes the answer over, which is no part of the run's time.
void collect(Planner &planner, const RunSettings &settings, RunRecord &record)
{
    if (!hasSolution(record))
        return;
    begin(RunPhase::check, settings, record);
    if (auto *late = dynamic_cast<LateAnswer *>(&planner))
        guarded(record, "",
                [&]
                {
                    record.status = late->collect();
                    record.reason = planner.reason();
                });
}

/// Further timings of a run that ended with an answer.
void repeat(const RunSettings &settings, const PreparedInstance &prepared, const RunRecord &before,
            const std::stop_token &stop, const Solution &solution, RunRecord &record)
{
    using enum PlannerStatus;
    const PlannerStatus status = record.status;
    if (!record.time || !(hasSolution(record) || status == infeasible || status == gave_up))
        return;
    RepeatedTiming timing(record, solution.fingerprint());
    for (std::int64_t i = 1; i < settings.timingRepeats && !stop.stop_requested(); ++i)
    {
        const std::unique_ptr<Planner> planner = settings.again();
        planner->setInstance(prepared.instance);
        RunRecord again = before;
        Progress progress;
        plan(*planner, settings, stop, again, progress);
        if (stop.stop_requested())
            return;
        collect(*planner, settings, again);
        timing.add(again, planner->solution().fingerprint());
    }
    timing.note(record);
}

/// Why that is no answer; empty where it is one.
std::string complaint(const Instance &instance, const Solution &solution, MotionRule rule, bool mustComplete)
{
    const Verdict verdict = validate(instance, solution, rule);
    return verdict.legal && (verdict.complete || !mustComplete) ? std::string() : verdict.violation;
}

/// The optimizers in their order, each one's answer checked; leaves the run as `invalid` or `crash` where one
/// fails.
void optimize(RunResult &result, MotionRule rule, std::span<const NamedOptimizer> optimizers,
              const TerminationCondition &ptc)
{
    RunRecord &record = result.record;
    const Instance &instance = *result.instance;
    Solution current = result.solution;
    record.optimizationTime = 0;
    for (const auto &[name, optimizer] : optimizers)
    {
        const std::string who = "optimizer '" + name + "'";
        const std::size_t before = current.pathLength();
        const Stopwatch watch;
        guarded(record, who + " ",
                [&, &improver = *optimizer]
                { current = improver.improve(instance, std::move(current), ptc); });
        *record.optimizationTime += watch.seconds();
        if (record.status != PlannerStatus::solved)
            return;
        if (const std::string wrong = complaint(instance, current, rule, true); !wrong.empty())
            return end(record, PlannerStatus::invalid, fmt::format("{} broke the solution: {}", who, wrong));
        if (current.pathLength() > before)
            return end(record, PlannerStatus::invalid,
                       who + " lengthened the solution from " + std::to_string(before) + " to " +
                           std::to_string(current.pathLength()) + " moves");
    }
    result.optimized = std::move(current);
}

void measureSolution(RunResult &result)
{
    RunRecord &record = result.record;
    const SolutionMetrics metrics = measure(*result.instance, result.solution, kCondenseUnder);
    record.pathLength = static_cast<std::int64_t>(metrics.pathLength);
    record.actions = static_cast<std::int64_t>(metrics.actions);
    record.makespan = static_cast<std::int64_t>(metrics.makespan);
    record.sumOfCosts = static_cast<std::int64_t>(metrics.sumOfCosts);
    record.completed = metrics.completed;
    record.solutionFingerprint = result.solution.fingerprint();
}

void measureOptimized(RunResult &result)
{
    RunRecord &record = result.record;
    const SolutionMetrics metrics = measure(*result.instance, result.optimized, kCondenseUnder);
    record.optimizedPathLength = static_cast<std::int64_t>(metrics.pathLength);
    record.optimizedActions = static_cast<std::int64_t>(metrics.actions);
    record.optimizedMakespan = static_cast<std::int64_t>(metrics.makespan);
    record.optimizedSumOfCosts = static_cast<std::int64_t>(metrics.sumOfCosts);
}

/// Why the planner may not be asked; empty where it may.
std::string reasonToReject(const Planner &planner, const Instance &instance, MotionRule allowed)
{
    const MotionRule needed = planner.specs().motion;
    if (needed > allowed) // each rule allows what the one before it allows
        return "its solutions need the motion rule '" + std::string(toString(needed)) +
               "', which is wider than '" + std::string(toString(allowed)) + "'";
    return planner.reasonToReject(instance).value_or("");
}

} // namespace

Solution improved(const Instance &instance, Solution solution, std::span<const NamedOptimizer> optimizers)
{
    for (const NamedOptimizer &step : optimizers)
        solution = step.optimizer->improve(instance, std::move(solution), TerminationCondition::never());
    return solution;
}

const char *toString(RunPhase phase)
{
    switch (phase)
    {
    case RunPhase::setup:
        return "setup()";
    case RunPhase::solve:
        return "solve()";
    case RunPhase::check:
        return "the check of its solution";
    case RunPhase::optimize:
        return "an optimizer";
    case RunPhase::measure:
        return "a metric";
    }
    return "";
}

PreparedInstance prepare(std::shared_ptr<const Instance> instance, double seconds,
                         const Supervision &supervision)
{
    assert(instance && !instance->defect());
    const auto within = [&](double part) { return TerminationCondition::after(part) || supervision.stop; };
    const Supervision bounding{within(seconds), supervision.listener};
    const TerminationCondition asking = within(seconds / 2);
    PreparedInstance prepared;
    prepared.fingerprint = instance->fingerprint();
    prepared.oneAtATime = solvability(*instance, MotionRule::pebble, asking);
    if (prepared.oneAtATime)
        prepared.withRotations = prepared.oneAtATime->solvable // rotations only add solutions
                                     ? Solvability()
                                     : solvability(*instance, MotionRule::rotation, asking);
    const Stopwatch watch;
    prepared.bounds = lowerBounds(*instance, bounding, kReasonableVisits);
    prepared.boundTime = watch.seconds();
    prepared.instance = std::move(instance);
    return prepared;
}

double preparationTime(double timeLimit)
{
    constexpr double kShare = 0.25;
    constexpr double kLeast = 0.2; // seconds
    return std::max(kLeast, kShare * timeLimit);
}

RunResult runPlanner(Planner &planner, const PreparedInstance &prepared,
                     std::span<const NamedOptimizer> optimizers, const RunSettings &settings,
                     const std::stop_token &stop)
{
    RunResult result;
    result.instance = prepared.instance;
    RunRecord &record = result.record;
    record.motion = toString(settings.motion);
    describeInstance(record, prepared, planner.specs().motion);

    const RunRecord before = record;
    for (std::int64_t i = 0; i < settings.warmUp && !stop.stop_requested(); ++i)
    {
        RunRecord unmeasured = before;
        Progress progress;
        const std::unique_ptr<Planner> warm = settings.again();
        warm->setInstance(prepared.instance);
        if (reasonToReject(*warm, *prepared.instance, settings.motion).empty())
            plan(*warm, settings, stop, unmeasured, progress);
    }

    const MemoryWatch memory(settings.ownProcess);
    guarded(record, "",
            [&]
            {
                planner.setInstance(prepared.instance);
                const std::string reason = reasonToReject(planner, *prepared.instance, settings.motion);
                if (!reason.empty())
                    end(record, PlannerStatus::unsupported, reason);
            });
    if (record.status == PlannerStatus::unknown)
        plan(planner, settings, stop, record, result.progress);
    memory.note(record, settings.limits.memory);
    collect(planner, settings, record);
    if (settings.timingRepeats > 1)
        repeat(settings, prepared, before, stop, planner.solution(), record);
    if (record.status == PlannerStatus::infeasible && record.solvable == "yes")
        end(record, PlannerStatus::invalid, "called a solvable instance infeasible: " + record.reason);
    if (!hasSolution(record))
        return result;

    if (settings.timingRepeats > 1) // whose last phase was another
        begin(RunPhase::check, settings, record);
    const MotionRule rule = planner.specs().motion;
    result.solution = planner.takeSolution();
    const bool mustComplete = record.solved();
    const std::string wrong = complaint(*result.instance, result.solution, rule, mustComplete);
    if (!wrong.empty())
        end(record, PlannerStatus::invalid, wrong);
    else if (record.solved() && !optimizers.empty())
    {
        begin(RunPhase::optimize, settings, record);
        optimize(result, rule, optimizers,
                 TerminationCondition::after(settings.limits.time) || TerminationCondition::when(stop) ||
                     settings.until);
    }
    if (!hasSolution(record))
    {
        result.solution.clear();
        return result;
    }
    measureSolution(result);
    if (record.solved() && !optimizers.empty())
        measureOptimized(result);
    return result;
}

} // namespace mrpp
