#pragma once
/// \file
/// Runs a plan: every planner on every instance, each answer checked and kept.
///
/// \code
/// Benchmark benchmark(plan, catalog);
/// benchmark.setPostRunEvent([](RunRecord &record, const Instance &, const Solution &solution)
///                           { record.extra["turns"] = countTurns(solution); });
/// const Benchmark::Summary summary = benchmark.benchmark({.folder = "results/mine"}, stopToken);
/// \endcode

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/Executor.h"
#include "framework/run/RunRecord.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace mrpp
{

class Benchmark
{
public:
    struct Request
    {
        std::filesystem::path folder = {};     ///< the campaign's folder; made where missing
        std::optional<std::int64_t> jobs = {}; ///< overrides the plan's
        std::int64_t shard = 1;                ///< 1 … shards: run the shard-th part only
        std::int64_t shards = 1;
        /// Starts a worker process for this very plan: a program and its arguments that call serveRuns()
        /// (mrpp "framework/worker/Worker.h"). Where it is empty, or a pre-run event is set, runs happen in
        /// this process.
        std::vector<std::string> worker = {};
        /// Told when every input was read and is right; nothing is written before.
        std::function<void()> onChecked = {};
        /// Told after every finished run, one call at a time.
        std::function<void(const RunRecord &record, std::size_t done, std::size_t total, double secondsLeft)>
            progress = {};
        /// Given every finished run before it is kept, one call at a time: whoever knows file formats writes
        /// what the plan asks to keep beside the results (BenchmarkPlan::keep).
        std::function<void(const RunSpec &spec, const RunResult &result)> onFinished = {};
    };

    struct Summary
    {
        std::size_t planned = 0;       ///< runs of the plan (of this shard)
        std::size_t kept = 0;          ///< finished before
        std::size_t finished = 0;      ///< finished now
        std::size_t underLoad = 0;     ///< of those finished now, with a load above the number of cores
        std::size_t notRepeatable = 0; ///< of those finished now, with another answer when solved again
        std::map<PlannerStatus, std::size_t> statuses; ///< of all finished runs
        bool interrupted = false;
        std::vector<std::string> notes; ///< what the folder's file system lacks, in sentences
    };

    /// Called in the order: pre-run event, setup, solve, checks, metrics, post-run event, store. One event at
    /// a time, whatever the number of jobs. The pre-run event may change the planner's parameters; what it
    /// does is not part of the run's key.
    using PreRunEvent = std::function<void(Planner &, const RunSpec &)>;
    using PostRunEvent = std::function<void(RunRecord &, const Instance &, const Solution &)>;

    Benchmark(BenchmarkPlan plan, const Catalog &catalog);

    void setPreRunEvent(PreRunEvent event) { preRun_ = std::move(event); }
    void setPostRunEvent(PostRunEvent event) { postRun_ = std::move(event); }

    [[nodiscard]] const BenchmarkPlan &plan() const { return plan_; }

    /// Checks every input file and makes the first instance of every point, then runs what the folder does
    /// not hold yet, planners interleaved. Finished runs go to the disk while others run, and count as
    /// finished (progress, summary) when they are there. A stop request ends the current runs without keeping
    /// them. The results do not depend on the number of jobs, on interruptions or on what the folder holds
    /// from an older version of the plan (times and memory aside); runs that are no longer in the plan stay
    /// in the store. Throws InputError before anything is written, and FileError where the folder cannot be
    /// used (or another process is running a campaign in it), and HarnessError where a run's surroundings
    /// failed or an input file changed meanwhile: that run stays open. A run whose processes stood still for
    /// a while (stopped and continued, the machine asleep) is begun again. What an event throws ends the
    /// campaign and is thrown again here.
    Summary benchmark(const Request &request, const std::stop_token &stop);

private:
    BenchmarkPlan plan_;
    const Catalog &catalog_;
    PreRunEvent preRun_;
    PostRunEvent postRun_;
};

} // namespace mrpp
