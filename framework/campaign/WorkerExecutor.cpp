#include "framework/campaign/WorkerExecutor.h"

#include "framework/support/Config.h"
#include "framework/support/Error.h"

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
    std::optional<PhaseNote> note; ///< nothing before the first phase
    Clock::time_point phaseStart;
    std::optional<Clock::time_point> deadline;
    std::optional<RunResult> result;
    bool tooLate = false; ///< the deadline came first
};

WorkerExecutor::WorkerExecutor(std::vector<std::string> command, const BenchmarkPlan &plan,
                               const Catalog &catalog, std::int64_t jobs, bool needInstances)
    : command_(std::move(command)), plan_(plan), needInstances_(needInstances),
      instances_(plan, catalog, jobs)
{}

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
        auto worker = std::make_unique<WorkerProcess>(command_);
        worker->send(toMessage(PlanSource{plan_.text, plan_.file, plan_.mapFolders}));
        const auto answer = worker->receive(std::nullopt, stop);
        if (stop() || (answer && answer->kind == MessageKind::ready))
            return worker;
        if (answer && answer->kind == MessageKind::error)
            throw InputError(toErrorText(*answer));
        if (worker->end().signal != SIGKILL) // else somebody killed it, and the next may live
            throw FileError(fmt::format("{}: ended before its first run instead of serving as a worker: {}",
                                        command_.front(), worker->takeErrorOutput()));
    }
}

void WorkerExecutor::follow(WorkerProcess &worker, Attempt &attempt, const std::function<bool()> &stop)
{
    while (auto message = worker.receive(attempt.deadline, stop))
    {
        switch (message->kind)
        {
        case MessageKind::phase:
            attempt.note = toPhase(*message);
            attempt.phaseStart = Clock::now();
            attempt.deadline.reset();
            if (attempt.note && attempt.note->phase != RunPhase::check)
                attempt.deadline = attempt.phaseStart + kGrace +
                                   std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(plan_.limits.time));
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
    attempt.tooLate = attempt.deadline && Clock::now() >= *attempt.deadline;
}

RunResult WorkerExecutor::describeEnd(const RunSpec &spec, Attempt &attempt,
                                      const WorkerProcess::End &end) const
{
    RunResult result;
    RunRecord &record = result.record;
    const std::string where = attempt.note ? std::string("in ") + toString(attempt.note->phase)
                                           : std::string("before its planner began");
    if (attempt.note)
        record = std::move(attempt.note->record);
    if (attempt.note && attempt.note->phase == RunPhase::solve)
        record.time = secondsSince(attempt.phaseStart);
    if (attempt.tooLate)
    {
        record.status = PlannerStatus::timeout;
        record.reason = fmt::format("did not stop {}: killed {} s after its limit of {} s", where,
                                    kGrace.count(), formatNumber(plan_.limits.time));
    }
    else
    {
        record.status = PlannerStatus::crash;
        record.reason =
            end.signal != 0
                ? fmt::format("killed by signal {} ({}) {}", end.signal, ::strsignal(end.signal), where)
                : fmt::format("ended its process with exit code {} {}", end.exitCode, where);
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
            errorOutput = worker->takeErrorOutput();
            const std::lock_guard lock(mutex_);
            idle_.push_back(std::move(worker));
        }
        else
        {
            const WorkerProcess::End end = worker->end();
            const bool killedByOthers = end.signal == SIGKILL && !attempt.tooLate;
            if (killedByOthers && !stopped() && (!attempt.note || ++kills <= kMostKills))
                continue;
            errorOutput = worker->takeErrorOutput();
            result = describeEnd(spec, attempt, end);
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
