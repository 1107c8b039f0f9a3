#pragma once
/// \file
/// Carries runs out in worker processes, one for each thread that asks at the same time, each kept for many
/// runs and replaced when it dies. A planner that crashes, hangs, eats memory or exits costs its own run
/// only.

#include "framework/campaign/InProcessExecutor.h"
#include "framework/campaign/WorkerProcess.h"

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

    /// A worker that dies is a `crash` whose reason says how it died and in which phase; one that has to be
    /// killed two seconds after a limit (of wall or
    /// CPU time) a `timeout`, one that outgrows the memory limit together with what it started a
    /// `memory_limit`; the record says by which means the limits are kept. A worker that somebody else kills
    /// (SIGKILL) is replaced and the run begun again, twice at most. What a planner wrote to its standard
    /// error, the last 2 KiB, is in the record's column `error_output`. Throws InputError as the worker does.
    [[nodiscard]] RunResult execute(const RunSpec &spec, const std::stop_token &stop) override;

private:
    struct Attempt;

    [[nodiscard]] std::unique_ptr<WorkerProcess> takeWorker(const std::function<bool()> &stop);
    [[nodiscard]] CoreSet takeCores();
    WorkerProcess::End end(WorkerProcess &worker);
    void follow(WorkerProcess &worker, Attempt &attempt, const std::function<bool()> &stop);
    void enter(WorkerProcess &worker, Attempt &attempt, PhaseNote note);
    bool isBeyondLimits(WorkerProcess &worker, Attempt &attempt) const;
    RunResult describeEnd(const RunSpec &spec, Attempt &attempt, const WorkerProcess::End &end,
                          const std::optional<double> &cpuTime) const;
    void describeConditions(RunRecord &record, const WorkerProcess &worker) const;
    void countChildrensMemory(RunResult &result, const WorkerProcess &worker, const Attempt &attempt) const;

    std::vector<std::string> command_;
    const BenchmarkPlan &plan_;
    bool needInstances_;
    InProcessExecutor instances_; ///< makes them on this side too, where they are needed
    std::mutex mutex_;            ///< guards what follows
    std::vector<std::unique_ptr<WorkerProcess>> idle_;
    std::vector<CoreSet> cores_; ///< of workers that are still to be started
};

} // namespace mrpp
