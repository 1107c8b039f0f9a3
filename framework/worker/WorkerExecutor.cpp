#include "framework/worker/WorkerExecutor.h"

#include "framework/run/RunIdentity.h"
#include "framework/run/RunNotes.h"
#include "framework/support/Config.h"
#include "framework/support/HarnessError.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fmt/core.h>

namespace mrpp
{

namespace
{

using Clock = WorkerProcess::Clock;

/// How long after its limit a phase may go on before the worker is killed; a planner that is merely a little
/// late has answered by then.
constexpr std::chrono::seconds kGrace{2};

constexpr std::chrono::milliseconds kLookAround{50};

/// A look-around that comes so late was held up by a pause of this process, and not by a busy machine.
constexpr std::chrono::seconds kPause{1};

/// How often the campaign tries again what others ended or spoiled.
constexpr int kMostTries = 10;

double seconds(Clock::duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

double secondsSince(Clock::time_point start)
{
    return seconds(Clock::now() - start);
}

/// How a worker ended.
std::string inWords(const WorkerProcess::End &end)
{
    return end.signal != 0 ? fmt::format("killed by signal {} ({})", end.signal, ::strsignal(end.signal))
                           : fmt::format("ended its process with exit code {}", end.exitCode);
}

/// The limits of time and memory are those of the plan's planners and optimizers, and of plugins' metrics.
bool hasLimits(RunPhase phase)
{
    return phase != RunPhase::check;
}

} // namespace

/// One run in one worker, as far as the worker told.
struct WorkerExecutor::Attempt
{
    enum class End
    {
        byItself, ///< or killed by others
        wallTime,
        cpuTime,
        memory,
    };

    /// Every look-around, and every message. What stands still uses up no limit: neither the worker, nor this
    /// process, which then cannot tell whether the worker did, too.
    void look(const WorkerProcess &worker)
    {
        const Clock::time_point now = Clock::now();
        const Clock::duration since = now - std::exchange(lastLook, now);
        const bool stopped = worker.isStopped();
        workerStopped |= stopped;
        if (since > kPause)
            longestGap = std::max(longestGap, since);
        if (deadline && (stopped || since > kPause))
            *deadline += since;
    }

    std::optional<PhaseNote> note; ///< nothing before the first phase
    Clock::time_point phaseStart;
    Clock::time_point lastLook = Clock::now();
    bool workerStopped = false;    ///< it was seen standing still
    Clock::duration longestGap{0}; ///< between two looks, where it was a pause
    std::optional<Clock::time_point> deadline;
    std::optional<double>
        cpuAtPhase;            ///< seconds, of the worker and all that it started; where they are needed
    double childrenMemory = 0; ///< MB, the most that was seen
    std::optional<RunResult> result;
    End end = End::byItself;
};

WorkerExecutor::WorkerExecutor(std::vector<std::string> command, const BenchmarkPlan &plan,
                               const Catalog &catalog, std::int64_t jobs, bool needInstances)
    : command_(std::move(command)), plan_(plan), needInstances_(needInstances),
      instances_(plan, catalog, jobs), cores_(shareCores(allowedCores(), static_cast<std::size_t>(jobs)))
{
    if (jobs == 1) // it may use all that there are
        cores_.clear();
}

std::unique_ptr<WorkerProcess> WorkerExecutor::takeWorker(const std::function<bool()> &stop)
{
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty())
        {
            auto worker = std::move(idle_.back());
            idle_.pop_back();
            return worker;
        }
    }
    for (;;)
    {
        auto worker = std::make_unique<WorkerProcess>(command_, takeCores());
        worker->send(toMessage(PlanSource{plan_.text, plan_.file, plan_.mapFolders,
                                          inputs_ ? inputs_->hashes() : InputWatch::Hashes()}));
        const auto answer = worker->receive(stop);
        if (stop() || (answer && answer->kind == MessageKind::ready))
            return worker;
        if (answer && answer->kind == MessageKind::error)
            throw InputError(toErrorText(*answer));
        if (end(*worker).signal != SIGKILL) // else somebody killed it, and the next may live
            throw FileError(fmt::format("{}: ended before its first run instead of serving as a worker: {}",
                                        command_.front(), worker->takeErrorOutput()));
    }
}

CoreSet WorkerExecutor::takeCores()
{
    const std::lock_guard lock(mutex_);
    if (cores_.empty())
        return {};
    CoreSet cores = std::move(cores_.back());
    cores_.pop_back();
    return cores;
}

WorkerProcess::End WorkerExecutor::end(WorkerProcess &worker)
{
    const WorkerProcess::End end = worker.end();
    const std::lock_guard lock(mutex_);
    if (!worker.cores().empty())
        cores_.push_back(worker.cores());
    return end;
}

void WorkerExecutor::giveBack(std::unique_ptr<WorkerProcess> worker, bool isSpoiled)
{
    if (isSpoiled)
    {
        (void)end(*worker);
        return;
    }
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(worker));
}

void WorkerExecutor::enter(WorkerProcess &worker, Attempt &attempt, PhaseNote note)
{
    attempt.phaseStart = Clock::now();
    attempt.deadline.reset();
    if (hasLimits(note.phase))
        attempt.deadline =
            attempt.phaseStart + kGrace +
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(plan_.limits.time));
    if (plan_.limits.cpu || worker.group() != nullptr)
        attempt.cpuAtPhase = worker.cpuTime();
    if (note.phase == RunPhase::setup && worker.group() != nullptr)
        worker.group()->watchMemory();
    attempt.note = std::move(note);
}

bool WorkerExecutor::isBeyondLimits(WorkerProcess &worker, Attempt &attempt) const
{
    if (!attempt.note || !hasLimits(attempt.note->phase))
        return false;
    ControlGroup *group = worker.group();
    const bool groupLimits = group != nullptr && !group->memoryMeans().empty();
    if (groupLimits)
    {
        // Each process has its own limit, which makes allocations fail. The group's, for all together, lies a
        // little above; short runs end before they need it.
        constexpr double kKernelsShare = 1.02;
        constexpr double kKernelsMost = 16; // MB
        if (!group->limitMemory(plan_.limits.memory * kKernelsShare + kKernelsMost) ||
            group->ranOutOfMemory())
            attempt.end = Attempt::End::memory;
    }
    else if (const double memory = worker.childrenMemory(); memory > attempt.childrenMemory)
    {
        attempt.childrenMemory = memory;
    }
    const double grace = std::chrono::duration<double>(kGrace).count();
    if (attempt.end == Attempt::End::memory)
        return true;
    if (Clock::now() >= *attempt.deadline)
        attempt.end = Attempt::End::wallTime;
    else if (plan_.limits.cpu && worker.cpuTime() - *attempt.cpuAtPhase > *plan_.limits.cpu + grace)
        attempt.end = Attempt::End::cpuTime;
    else if (attempt.childrenMemory > plan_.limits.memory)
        attempt.end = Attempt::End::memory;
    return attempt.end != Attempt::End::byItself;
}

void WorkerExecutor::follow(WorkerProcess &worker, Attempt &attempt, const std::function<bool()> &stop)
{
    const auto isOver = [&]
    {
        if (stop())
            return true;
        if (Clock::now() < attempt.lastLook + kLookAround)
            return false;
        attempt.look(worker);
        return isBeyondLimits(worker, attempt);
    };
    while (auto message = worker.receive(isOver))
    {
        if (Clock::now() >= attempt.lastLook + kPause)
            attempt.look(worker);
        switch (message->kind)
        {
        case MessageKind::phase:
            if (auto note = toPhase(*message))
                enter(worker, attempt, std::move(*note));
            break;
        case MessageKind::finished:
            attempt.result = toResult(*message);
            return;
        case MessageKind::error:
            throw InputError(toErrorText(*message));
        default:
            return;
        }
    }
}

bool WorkerExecutor::wasPaused(const Attempt &attempt) const
{
    if (attempt.workerStopped || (attempt.result && attempt.result->paused))
        return true;
    if (!attempt.result)
        return attempt.longestGap.count() > 0;
    // The worker did not notice that all processes were frozen, but then it measured the time of the freeze.
    const RunRecord &record = attempt.result->record;
    const double once = record.setupTime.value_or(0) + record.time.value_or(0);
    const auto times = static_cast<double>(record.timed.value_or(1) + plan_.execution.warmUp);
    return attempt.longestGap.count() > 0 &&
           once * times + record.optimizationTime.value_or(0) >= seconds(attempt.longestGap);
}

void WorkerExecutor::describeConditions(RunRecord &record, const WorkerProcess &worker) const
{
    const ControlGroup *group = worker.group();
    const std::string cpu = group != nullptr ? group->cpuMeans() : "";
    const std::string memory = group != nullptr ? group->memoryMeans() : "";
    record.cores = toString(worker.cores());
    record.limitMeans = fmt::format("time kill, cpu {}, memory rlimit+{}", cpu.empty() ? "/proc" : cpu,
                                    memory.empty() ? "/proc" : memory);
}

void WorkerExecutor::countChildrensMemory(RunResult &result, const WorkerProcess &worker,
                                          const Attempt &attempt) const
{
    RunRecord &record = result.record;
    ControlGroup *group = worker.group();
    const bool killed = group != nullptr && group->ranOutOfMemory();
    if (result.startedProcesses && record.memory)
        record.memory = std::max({*record.memory, attempt.childrenMemory,
                                  group == nullptr ? 0.0 : group->memoryGrowth().value_or(0)});
    if (killed)
    {
        record.status = PlannerStatus::memory_limit;
        record.terminationReason = "memory";
        record.reason = "a process that it started was killed for memory";
    }
    if (group != nullptr)
        group->unlimitMemory();
}

RunResult WorkerExecutor::describeEnd(const RunSpec &spec, Attempt &attempt, const WorkerProcess::End &end,
                                      const std::optional<double> &cpuTime) const
{
    RunResult result;
    RunRecord &record = result.record;
    std::string where;
    if (attempt.note) // else the campaign was stopped before
    {
        where = std::string("in ") + toString(attempt.note->phase);
        record = std::move(attempt.note->record);
    }
    if (attempt.note && attempt.note->phase == RunPhase::solve)
    {
        record.time = secondsSince(attempt.phaseStart);
        record.cpuTime = cpuTime;
    }
    switch (attempt.end)
    {
    case Attempt::End::wallTime:
        record.status = PlannerStatus::timeout;
        record.terminationReason = "walltime";
        record.reason = fmt::format("did not stop {}: killed {} s after its limit of {} s", where,
                                    kGrace.count(), formatNumber(plan_.limits.time));
        break;
    case Attempt::End::cpuTime:
        record.status = PlannerStatus::timeout;
        record.terminationReason = "cputime";
        record.reason = fmt::format("did not stop {}: killed {} s of CPU time after its limit of {} s", where,
                                    kGrace.count(), formatNumber(*plan_.limits.cpu));
        break;
    case Attempt::End::memory:
        record.status = PlannerStatus::memory_limit;
        record.terminationReason = "memory";
        record.reason = fmt::format("killed {}: it and what it started took more than {} MB", where,
                                    formatNumber(plan_.limits.memory));
        break;
    case Attempt::End::byItself:
        record.status = PlannerStatus::crash;
        record.terminationReason = end.signal == SIGKILL ? "killed" : "";
        record.reason = inWords(end) + " " + where;
        break;
    }
    fillIdentity(record, plan_, spec);
    return result;
}

/// A worker ended by itself that had not begun to plan: no planner of this run did that.
void WorkerExecutor::refuseToBlame(const RunSpec &spec, const WorkerProcess::End &end, int tries) const
{
    if (tries > kMostTries)
        throw HarnessError(fmt::format(
            "the instance {} cannot be made: {} workers that tried ended {}; nothing was recorded for it",
            spec.caseId, tries, inWords(end)));
}

RunResult WorkerExecutor::execute(const RunSpec &spec, const std::stop_token &stop)
{
    constexpr int kMostKills = 2; // by others, in the middle of this run
    const auto stopped = [&stop] { return stop.stop_requested(); };
    RunResult result;
    bool addedMetrics = true;
    std::string note;
    for (int kills = 0, tries = 0;;)
    {
        std::unique_ptr<WorkerProcess> worker = takeWorker(stopped);
        Attempt attempt;
        worker->send(toMessage(spec, addedMetrics));
        follow(*worker, attempt, stopped);
        std::string errorOutput;
        if (attempt.result)
        {
            result = std::move(*attempt.result);
            fillIdentity(result.record, plan_, spec);
            countChildrensMemory(result, *worker, attempt);
            describeConditions(result.record, *worker);
            errorOutput = worker->takeErrorOutput();
            result.paused = wasPaused(attempt);
            giveBack(std::move(worker), result.lastOfWorker);
        }
        else
        {
            if (worker->group() != nullptr && worker->group()->ranOutOfMemory())
                attempt.end = Attempt::End::memory;
            const auto cpuTime =
                attempt.cpuAtPhase ? std::optional(worker->cpuTime() - *attempt.cpuAtPhase) : std::nullopt;
            RunRecord conditions;
            describeConditions(conditions, *worker);
            const WorkerProcess::End how = end(*worker);
            if (!attempt.note && !stopped())
            {
                refuseToBlame(spec, how, ++tries);
                continue;
            }
            const bool killedByOthers = how.signal == SIGKILL && attempt.end == Attempt::End::byItself;
            if (killedByOthers && !stopped() && ++kills <= kMostKills)
                continue;
            if (addedMetrics && attempt.note && attempt.note->phase == RunPhase::measure && !stopped())
            {
                note =
                    "no added metrics: one of them " + (attempt.end == Attempt::End::byItself
                                                            ? inWords(how)
                                                            : std::string("needed too much time or memory"));
                addedMetrics = false;
                continue;
            }
            errorOutput = worker->takeErrorOutput();
            const bool paused = wasPaused(attempt);
            result = describeEnd(spec, attempt, how, cpuTime);
            result.paused = paused;
            result.record.cores = conditions.cores;
            result.record.limitMeans = conditions.limitMeans;
        }
        if (!errorOutput.empty())
            result.record.extra.try_emplace("error_output",
                                            std::move(errorOutput)); // unless a planner has its own
        break;
    }
    if (!note.empty())
        addNote(result.record, note);
    if (needInstances_ && result.record.vertices)
        result.instance = instances_.instance(spec)->instance;
    return result;
}

} // namespace mrpp
