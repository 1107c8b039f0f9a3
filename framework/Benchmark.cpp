#include "framework/Benchmark.h"

#include "framework/plan/PointError.h"
#include "framework/plan/Shards.h"
#include "framework/run/InProcessExecutor.h"
#include "framework/run/InputWatch.h"
#include "framework/run/ReadableRecord.h"
#include "framework/run/RunQueue.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultStore.h"
#include "framework/store/ResultWriter.h"
#include "framework/support/HarnessError.h"
#include "framework/support/Random.h"
#include "framework/system/Cores.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "framework/worker/WorkerExecutor.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>

namespace mrpp
{

namespace
{

std::string utcNow()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

void checkRequest(const Benchmark::Request &request, std::int64_t jobs)
{
    constexpr std::int64_t kMostJobs = 1024;
    if (jobs < 1 || jobs > kMostJobs)
        throw InputError("jobs = " + std::to_string(jobs) + ", but must lie in 1 … " +
                         std::to_string(kMostJobs));
    if (request.shards < 1 || request.shard < 1 || request.shard > request.shards)
        throw InputError("shard " + std::to_string(request.shard) + "/" + std::to_string(request.shards) +
                         ": a shard i/n needs 1 ≤ i ≤ n");
}

void checkInstance(const Problem &problem, const std::shared_ptr<const Graph> &graph, Seed seed)
{
    try
    {
        (void)makeInstance(problem, graph, seed);
    }
    catch (const DoesNotFit &)
    {
        // What chance does not give is recorded in its runs. check() has refused files that do not fit.
    }
}

/// Everything that can be wrong with the plan's input, found before the first run.
void checkInputs(const BenchmarkPlan &plan, const std::vector<RunSpec> &runs)
{
    for (const Configured &planner : plan.planners)
        if (planner.command)
            checkExecutable(*planner.command);
    std::set<std::size_t> checked;
    std::string lastKey;
    std::shared_ptr<const Graph> graph; // of the last point: points of a sweep over robots share it
    for (const RunSpec &run : runs)
    {
        if (!checked.insert(run.point).second)
            continue;
        const ProblemPoint &point = plan.points[run.point];
        try
        {
            point.problem->check();
            std::string key = graphKey(plan, run);
            if (key != lastKey)
                graph = point.problem->makeGraph(run.graphSeed);
            lastKey = std::move(key);
            checkInstance(*point.problem, graph, run.instanceSeed);
        }
        catch (const InputError &error)
        {
            throw PointError(error, plan, run.point);
        }
    }
}

/// The campaign's provenance; start and end are those of the file, if it has begun before.
Provenance provenanceOf(const BenchmarkPlan &plan, const std::filesystem::path &file)
{
    Provenance provenance = Provenance::here();
    provenance.campaign = plan.campaign;
    provenance.planFile = plan.file.filename().string();
    provenance.planFolder = std::filesystem::absolute(plan.file).parent_path().string();
    for (const std::filesystem::path &maps : plan.mapFolders)
        provenance.mapFolders.push_back(std::filesystem::absolute(maps).lexically_normal().string());
    provenance.planFingerprint = Fingerprint().add(plan.text).hex();
    provenance.seed = static_cast<std::int64_t>(plan.seed);
    provenance.started = utcNow();
    if (std::filesystem::exists(file))
    {
        const Provenance before = Provenance::fromJson(readFile(file), file);
        provenance.started = before.started;
        provenance.finished = before.finished;
    }
    return provenance;
}

/// The threads of one campaign: they take runs off one queue, and give their results to one writer.
class Crew
{
public:
    Crew(RunQueue &queue, ResultStore &store, const Benchmark::Request &request,
         const Benchmark::PostRunEvent &postRun, std::mutex &events, Benchmark::Summary &summary)
        : queue_(queue), store_(store), request_(request), postRun_(postRun), events_(events),
          summary_(summary),
          writer_(
              store, [this](const RunRecord &record) { count(record); }, [this] { stop_.request_stop(); })
    {}

    /// Works until nothing is left, `stop` is triggered, or something throws, which is thrown again here when
    /// all that was finished is kept.
    void work(Executor &executor, std::int64_t jobs, const std::stop_token &stop)
    {
        const std::stop_callback passOn(stop, [this] { stop_.request_stop(); });
        {
            std::vector<std::jthread> threads;
            for (std::int64_t i = 0; i < jobs; ++i)
                threads.emplace_back([this, &executor, i]
                                     { workAlone(executor, static_cast<std::size_t>(i)); });
        }
        writer_.finish();
        if (error_)
            std::rethrow_exception(error_);
    }

private:
    void workAlone(Executor &executor, std::size_t taker)
    {
        try
        {
            while (!stop_.stop_requested())
            {
                const RunSpec *run = queue_.take(taker);
                if (run == nullptr)
                    return;
                const std::int64_t attempt = store_.begin(run->runKey);
                const std::optional<double> load = machineLoad();
                RunResult result = executeUndisturbed(executor, *run);
                if (stop_.stop_requested())
                    return; // perhaps cut short
                result.record.attempt = attempt;
                result.record.load = load;
                finish(*run, std::move(result));
            }
        }
        catch (...)
        {
            const std::lock_guard lock(mutex_);
            if (!error_)
                error_ = std::current_exception();
            stop_.request_stop();
        }
    }

    /// What was measured while a process stood still is measured again.
    RunResult executeUndisturbed(Executor &executor, const RunSpec &run)
    {
        constexpr int kMostPauses = 20;
        for (int pauses = 0; pauses < kMostPauses; ++pauses)
        {
            RunResult result = executor.execute(run, stop_.get_token());
            if (!result.paused || stop_.stop_requested())
                return result;
        }
        throw HarnessError("the processes of run " + run.runKey + " were stopped and continued in each of " +
                           std::to_string(kMostPauses) +
                           " goes; times that are measured so are worth nothing. Once that is over, the same "
                           "command goes on");
    }

    void finish(const RunSpec &run, RunResult result)
    {
        makeReadable(result.record);
        {
            const std::lock_guard lock(events_);
            if (postRun_ && result.instance)
                postRun_(result.record, *result.instance, result.solution);
            if (request_.onFinished)
                request_.onFinished(run, result);
        }
        writer_.put({std::move(result.record), std::move(result.solution), std::move(result.progress)});
    }

    /// The run is on the disk.
    void count(const RunRecord &record)
    {
        ++summary_.finished;
        ++summary_.statuses[record.status];
        constexpr double kOwnShare = 0.5; // the campaign's own process works a little too
        if (record.load && *record.load > machineCores() + kOwnShare)
            ++summary_.underLoad;
        if (record.repeatable.starts_with("no"))
            ++summary_.notRepeatable;
        if (!request_.progress)
            return;
        const std::lock_guard lock(events_);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        const auto left = static_cast<double>(queue_.size() - summary_.finished);
        request_.progress(record, summary_.kept + summary_.finished, summary_.planned,
                          spent.count() / static_cast<double>(summary_.finished) * left);
    }

    RunQueue &queue_;
    ResultStore &store_;
    const Benchmark::Request &request_;
    const Benchmark::PostRunEvent &postRun_;
    std::mutex &events_; // one event at a time
    Benchmark::Summary &summary_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::stop_source stop_;

    std::mutex mutex_; // guards what follows
    std::exception_ptr error_;
    ResultWriter writer_; // last: its thread uses the others
};

} // namespace

Benchmark::Benchmark(BenchmarkPlan plan, const Catalog &catalog) : plan_(std::move(plan)), catalog_(catalog)
{
    resolve(plan_, catalog_);
}

Benchmark::Summary Benchmark::benchmark(const Request &request, const std::stop_token &stop)
{
    const std::int64_t jobs = request.jobs.value_or(plan_.execution.jobs);
    checkRequest(request, jobs);
    removeStaleTemporaryFolders();
    // Noted before the keys are made: what changes in between is noticed at the first use.
    const auto inputs = std::make_shared<InputWatch>(inputFilesOf(plan_));
    std::vector<RunSpec> runs = expand(plan_);
    if (request.shards > 1)
        std::erase_if(runs, [&](const RunSpec &run)
                      { return shardOf(plan_, run, request.shards) != request.shard; });
    checkInputs(plan_, runs);
    if (request.onChecked)
        request.onChecked();

    ResultStore store(request.folder, ResultStore::Access::write);
    Summary summary;
    summary.planned = runs.size();
    summary.notes = store.notes();
    const auto isFinished = [&summary, finished = store.finishedRuns()](const RunSpec &run)
    {
        const auto status = finished.find(run.runKey);
        if (status != nullptr)
            ++summary.statuses[*status];
        return status != nullptr;
    };
    runs.erase(std::remove_if(runs.begin(), runs.end(), isFinished), runs.end());
    summary.kept = summary.planned - runs.size();

    const std::filesystem::path provenanceFile = request.folder / "provenance.json";
    Provenance provenance = provenanceOf(plan_, provenanceFile);
    const bool anythingLeft = !runs.empty();
    if (anythingLeft)
        provenance.finished.clear();
    writeFile(request.folder / "plan.yaml", plan_.text);
    writeFile(provenanceFile, provenance.toJson());
    store.describe(plan_, provenance);

    std::mutex events;
    InProcessExecutor::PreRunEvent preRun;
    if (preRun_)
        preRun = [&](Planner &planner, const RunSpec &spec)
        {
            const std::lock_guard lock(events);
            preRun_(planner, spec);
        };
    std::unique_ptr<Executor> executor;
    if (request.worker.empty() || preRun_)
    {
        auto here = std::make_unique<InProcessExecutor>(plan_, catalog_, jobs, preRun);
        here->setInputs(inputs);
        executor = std::move(here);
    }
    else
    {
        auto workers = std::make_unique<WorkerExecutor>(request.worker, plan_, catalog_, jobs,
                                                        plan_.keep.instances || postRun_ != nullptr);
        workers->setInputs(inputs);
        executor = std::move(workers);
    }
    RunQueue queue(std::move(runs), plan_.seed, static_cast<std::size_t>(jobs));
    Crew(queue, store, request, postRun_, events, summary).work(*executor, jobs, stop);
    executor.reset();
    removeStaleTemporaryFolders(); // of workers that were killed together with their guardians

    summary.interrupted = summary.kept + summary.finished < summary.planned;
    if (!summary.interrupted && anythingLeft)
    {
        provenance.finished = utcNow();
        writeFile(provenanceFile, provenance.toJson());
    }
    return summary;
}

} // namespace mrpp
