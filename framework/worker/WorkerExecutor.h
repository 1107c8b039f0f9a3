#pragma once
/// \file
/// Carries runs out in worker processes, one for each thread that asks at the same time, each kept for many
/// runs and replaced when it dies. A planner that crashes, hangs, eats memory or exits costs its own run
/// only.

#include "framework/run/InProcessExecutor.h"
#include "framework/worker/WorkerProcess.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace mrpp
{

class WorkerExecutor final : public Executor
{
public:
    /// \param command starts a worker (serveRuns()); \param plan must come from its own text and file, and
    /// outlive the executor, as must \param catalog
    /// \param needInstances whether the results have their instance
    WorkerExecutor(std::vector<std::string> command, const BenchmarkPlan &plan, const Catalog &catalog,
                   std::int64_t jobs, bool needInstances);

    /// What the input files have to hold whenever they are read; without it nothing is checked.
    void setInputs(std::shared_ptr<InputWatch> inputs)
    {
        inputs_ = inputs;
        instances_.setInputs(std::move(inputs));
    }

    /// A worker that dies is a `crash` whose reason says how it died and in which phase (HarnessError where
    /// no planner had begun, again and again); one that has to be killed two seconds after a limit (of wall
    /// or CPU time) a `timeout`, one that outgrows the memory limit together with what it started a
    /// `memory_limit`; the record says by which means the limits are kept. A worker that somebody else kills
    /// (SIGKILL) is replaced and the run begun again, twice at most. One that stands still uses up no limit,
    /// and its result says that it was `paused`. What a planner wrote to its standard error, the last 2 KiB,
    /// is in the record's column `error_output`. Throws InputError as the worker does.
    [[nodiscard]] RunResult execute(const RunSpec &spec, const std::stop_token &stop) override;

private:
    struct Attempt;

    [[nodiscard]] std::unique_ptr<WorkerProcess> takeWorker(const std::function<bool()> &stop);
    void giveBack(std::unique_ptr<WorkerProcess> worker, bool isSpoiled);
    [[nodiscard]] CoreSet takeCores();
    WorkerProcess::End end(WorkerProcess &worker);
    void follow(WorkerProcess &worker, Attempt &attempt, const std::function<bool()> &stop);
    void enter(WorkerProcess &worker, Attempt &attempt, PhaseNote note);
    bool isBeyondLimits(WorkerProcess &worker, Attempt &attempt) const;
    [[nodiscard]] bool wasPaused(const Attempt &attempt) const;
    void refuseToBlame(const RunSpec &spec, const WorkerProcess::End &end, int tries) const;
    RunResult describeEnd(const RunSpec &spec, Attempt &attempt, const WorkerProcess::End &end,
                          const std::optional<double> &cpuTime) const;
    void describeConditions(RunRecord &record, const WorkerProcess &worker) const;
    void countChildrensMemory(RunResult &result, const WorkerProcess &worker, const Attempt &attempt) const;

    std::vector<std::string> command_;
    const BenchmarkPlan &plan_;
    bool needInstances_;
    std::shared_ptr<InputWatch> inputs_; ///< or null
    InProcessExecutor instances_;        ///< makes them on this side too, where they are needed
    std::mutex mutex_;                   ///< guards what follows
    std::vector<std::unique_ptr<WorkerProcess>> idle_;
    std::vector<CoreSet> cores_; ///< of workers that are still to be started
};

} // namespace mrpp
