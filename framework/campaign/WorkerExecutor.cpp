#include "framework/campaign/WorkerExecutor.h"

#include "framework/support/Config.h"
#include "framework/support/Error.h"

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

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
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

    std::optional<PhaseNote> note; ///< nothing before the first phase
    Clock::time_point phaseStart;
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
        worker->send(toMessage(PlanSource{plan_.text, plan_.file, plan_.mapFolders}));
        const auto answer = worker->receive(std::nullopt, stop);
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

void WorkerExecutor::enter(WorkerProcess &worker, Attempt &attempt, PhaseNote note)
{
    attempt.phaseStart = Clock::now();
    attempt.deadline.reset();
    if (note.phase != RunPhase::check)
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
    if (!attempt.note || attempt.note->phase == RunPhase::check)
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
    constexpr std::chrono::milliseconds kLookAround{50};
    Clock::time_point nextLook = Clock::now() + kLookAround;
    const auto isOver = [&]
    {
        if (Clock::now() >= nextLook)
        {
            nextLook = Clock::now() + kLookAround;
            return stop() || isBeyondLimits(worker, attempt);
        }
        return stop();
    };
    while (auto message = worker.receive(attempt.deadline, isOver))
    {
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
    if (attempt.end == Attempt::End::byItself && attempt.deadline && Clock::now() >= *attempt.deadline)
        attempt.end = Attempt::End::wallTime;
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
    const std::string where = attempt.note ? std::string("in ") + toString(attempt.note->phase)
                                           : std::string("before its planner began");
    if (attempt.note)
        record = std::move(attempt.note->record);
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
        record.terminationReason = end.signal == SIGKILL ? "killed" : attempt.note ? "" : "failed";
        record.reason =
            end.signal != 0
                ? fmt::format("killed by signal {} ({}) {}", end.signal, ::strsignal(end.signal), where)
                : fmt::format("ended its process with exit code {} {}", end.exitCode, where);
        break;
    }
    fillIdentity(record, plan_, spec);
    return result;
}

RunResult WorkerExecutor::execute(const RunSpec &spec, const std::stop_token &stop)
{
    constexpr int kMostKills = 2; // by others, in the middle of this run
    const auto stopped = [&stop] { return stop.stop_requested(); };
    RunResult result;
    for (int kills = 0;;)
    {
        std::unique_ptr<WorkerProcess> worker = takeWorker(stopped);
        Attempt attempt;
        worker->send(toMessage(spec));
        follow(*worker, attempt, stopped);
        std::string errorOutput;
        if (attempt.result)
        {
            result = std::move(*attempt.result);
            fillIdentity(result.record, plan_, spec);
            countChildrensMemory(result, *worker, attempt);
            describeConditions(result.record, *worker);
            errorOutput = worker->takeErrorOutput();
            const std::lock_guard lock(mutex_);
            idle_.push_back(std::move(worker));
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
            const bool killedByOthers = how.signal == SIGKILL && attempt.end == Attempt::End::byItself;
            if (killedByOthers && !stopped() && (!attempt.note || ++kills <= kMostKills))
                continue;
            errorOutput = worker->takeErrorOutput();
            result = describeEnd(spec, attempt, how, cpuTime);
            result.record.cores = conditions.cores;
            result.record.limitMeans = conditions.limitMeans;
        }
        if (!errorOutput.empty())
            result.record.extra["error_output"] = std::move(errorOutput);
        break;
    }
    if (needInstances_ && result.record.vertices)
        result.instance = instances_.instance(spec)->instance;
    return result;
}

} // namespace mrpp
