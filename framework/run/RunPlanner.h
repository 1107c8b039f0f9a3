#pragma once
/// \file
/// One planner on one given instance: timed, checked, measured. What a campaign does for each of its runs and
/// `mrppsim solve` does once.
///
/// \code
/// planner.setSeed(7);
/// const RunResult result = runPlanner(planner, prepare(instance), optimizers, {.limits = {.time = 10}},
/// stop); \endcode

#include "framework/Optimizer.h"
#include "framework/Planner.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/analysis/Solvability.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/Executor.h"
#include "framework/system/Supervision.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace mrpp
{

/// An instance, and what is known of it before anyone plans.
struct PreparedInstance
{
    std::shared_ptr<const Instance> instance;
    std::optional<LowerBounds> bounds; ///< nothing where some goal cannot be reached
    double boundTime = 0;              ///< seconds that they took
    std::string fingerprint;
    std::optional<Solvability> oneAtATime;    ///< what the oracle says without rotations, if it had time
    std::optional<Solvability> withRotations; ///< and with them

    [[nodiscard]] const std::optional<Solvability> &solvability(MotionRule rule) const
    {
        return rule == MotionRule::rotation ? withRotations : oneAtATime;
    }
};

/// Asks the oracle, for at most half of these seconds, and looks for lower bounds until they are over. What
/// that comes to depends on the machine's speed where the instance is large; no run's time is spent.
/// \pre instance->defect() is empty
[[nodiscard]] PreparedInstance prepare(std::shared_ptr<const Instance> instance,
                                       double seconds = std::numeric_limits<double>::infinity(),
                                       const Supervision &supervision = {});

/// How long an instance may be prepared for runs of that time limit: a quarter of it, but long enough for
/// small instances.
[[nodiscard]] double preparationTime(double timeLimit);

struct NamedOptimizer
{
    std::string name; ///< for the reason of a run that it spoils
    std::unique_ptr<const Optimizer> optimizer;
};

/// The optimizers one after another, unchecked and without a limit of time.
[[nodiscard]] Solution improved(const Instance &instance, Solution solution,
                                std::span<const NamedOptimizer> optimizers);

/// The parts of a run, in their order; those after solve are left out where there is no solution. The plan's
/// limits hold in all but `check`.
enum class RunPhase : std::uint8_t
{
    setup,
    solve,
    check,    ///< take the answer over and measure
    optimize, ///< each optimizer, and the check of what it gives
    measure,  ///< by metrics that were added; by the executor, not by runPlanner()
};

/// As in "killed in solve()".
[[nodiscard]] const char *toString(RunPhase phase);

struct RunSettings
{
    Limits limits = {};
    TerminationCondition until = {};          ///< ends planner and optimizers whatever the limits
    MotionRule motion = MotionRule::rotation; ///< a planner of a wider rule is `unsupported`

    /// False where other runs share the process: memory and CPU time would be theirs too, and stay empty; the
    /// CPU limit does not hold.
    bool ownProcess = true;

    /// How often solve() is timed, and how often it runs before that. The repeats of a run begin with new
    /// objects of `again`, which must be set where there are any.
    std::int64_t timingRepeats = 1;
    std::int64_t warmUp = 0;
    std::function<std::unique_ptr<Planner>()> again = {};

    /// An answer that comes later than this after the time limit is a `timeout`.
    double grace = 1; ///< seconds

    /// Told when a phase begins, with what is known of the run by then.
    std::function<void(RunPhase, const RunRecord &)> onPhase = {};
};

/// Runs the planner as its parameters and seed are, and reports whatever it does:
///  * `unsupported` where it rejects the instance or needs a wider motion rule than the settings allow;
///  * `timeout` where its setup() takes longer than the time limit: solve() is not called then;
///  * `crash` where it throws, `memory_limit` where that is std::bad_alloc, or where the process grew by more
///    than the limit (if measured); a HarnessError is thrown on;
///  * `invalid` where its solution breaks its own motion rule or misses a goal, or an optimizer's does so or
///    is longer than before; the reason says which move, and which optimizer;
///    it is also `invalid` to call an instance infeasible that the oracle knows to be solvable under that
///    rule;
///  * else what it says itself.
///
/// What ends with an answer (solved, partial, infeasible, gave up) is timed as often as the settings say;
/// `time` is the median, and the answers must not differ, which the record tells (`repeatable`). Memory is
/// that of the first.
///
/// Time is that of solve() alone (without LateAnswer::collect(), which no limit concerns), memory how far the
/// process grows during setup() and solve(). Lengths are there for `solved` and `partial` only; the makespan
/// is that of the solution condensed under `following`. Without a solution `completed` counts the robots that
/// are at their goals from the start. The record does not say which run it is: the caller fills that in.
[[nodiscard]] RunResult runPlanner(Planner &planner, const PreparedInstance &prepared,
                                   std::span<const NamedOptimizer> optimizers, const RunSettings &settings,
                                   const std::stop_token &stop);

} // namespace mrpp
