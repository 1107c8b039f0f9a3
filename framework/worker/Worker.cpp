#include "framework/worker/Worker.h"

#include "framework/run/InProcessExecutor.h"
#include "framework/support/Error.h"
#include "framework/system/Memory.h"
#include "framework/system/ProcessState.h"
#include "framework/system/ProcessTree.h"
#include "framework/worker/Guardian.h"

#include <sys/resource.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false; // sanitizers map far more than they use
#else
constexpr bool kLimitsMemory = true;
#endif

/// How much more data memory the process may have; every allocation beyond fails.
void limitGrowth(double megabytes)
{
    rlimit limit{};
    if (!kLimitsMemory || ::getrlimit(RLIMIT_DATA, &limit) != 0)
        return;
    const double most = static_cast<double>(dataMemory()) + megabytes * 1e6;
    const bool unlimited = most >= static_cast<double>(limit.rlim_max); // RLIM_INFINITY is the largest number
    limit.rlim_cur = unlimited ? limit.rlim_max : static_cast<rlim_t>(most);
    ::setrlimit(RLIMIT_DATA, &limit);
}

void unlimitGrowth()
{
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0)
        return;
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_DATA, &limit);
}

/// Of the processes that this one waited for: CPU seconds, and page faults, of which every process has some.
struct ChildrenUsage
{
    double cpuTime = 0;
    long faults = 0;

    static ChildrenUsage now()
    {
        rusage usage{};
        ::getrusage(RUSAGE_CHILDREN, &usage);
        const auto seconds = [](const timeval &time)
        { return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6; };
        return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_minflt + usage.ru_majflt};
    }
};

std::optional<Message> receive(MessageBuffer &buffer)
{
    for (;;)
    {
        if (auto message = buffer.next())
            return message;
        if (!buffer.readFrom(kWorkerSocket))
            return std::nullopt;
    }
}

/// Runs after runs, until the campaign is done or a planner has spoiled the process.
void serve(const BenchmarkPlan &plan, const InputWatch::Hashes &inputs, const Catalog &catalog,
           MessageBuffer &buffer)
{
    const pid_t self = ::getpid();
    const auto onlyOnce = [self]
    {
        if (::getpid() != self)
            ::_exit(0); // a process that the planner forked came back from solve()
    };
    InProcessExecutor executor(plan, catalog, 1);
    if (!inputs.empty()) // a replay takes files as they are
        executor.setInputs(std::make_shared<InputWatch>(inputs));
    executor.setPhaseEvent(
        [&](RunPhase phase, const RunRecord &record)
        {
            onlyOnce();
            if (phase == RunPhase::check)
                unlimitGrowth();
            send(kWorkerSocket, toMessage(PhaseNote{phase, record}));
            if (phase == RunPhase::setup)
                limitGrowth(plan.limits.memory);
        });
    const ProcessState asItWas;
    while (const auto message = receive(buffer))
    {
        const auto spec = toSpec(*message);
        if (!spec || spec->point >= plan.points.size() || spec->planner >= plan.planners.size())
            throw InputError("the plan has changed while its campaign runs");
        executor.setAddsMetrics(wantsAddedMetrics(*message));
        const ChildrenUsage before = ChildrenUsage::now();
        RunResult result = executor.execute(*spec, {});
        onlyOnce();
        unlimitGrowth();
        const ChildrenUsage waited = ChildrenUsage::now();
        endChildren();
        const ChildrenUsage ended = ChildrenUsage::now();
        result.startedProcesses = ended.faults > before.faults;
        if (result.record.cpuTime)
            *result.record.cpuTime += ended.cpuTime - waited.cpuTime;
        result.lastOfWorker = !asItWas.restore();
        if (!send(kWorkerSocket, toMessage(result)) || result.lastOfWorker)
            return;
    }
}

} // namespace

int serveRuns(const Catalog &catalog, const std::function<BenchmarkPlan(const PlanSource &)> &readPlan)
{
    MessageBuffer buffer;
    const auto first = receive(buffer);
    const auto source = first ? toPlan(*first) : std::nullopt;
    if (!source)
        return 3;
    try
    {
        becomeGuarded(kWorkerSocket);
        const BenchmarkPlan plan = readPlan(*source);
        if (send(kWorkerSocket, {MessageKind::ready, {}}))
            serve(plan, source->inputs, catalog, buffer);
        return 0;
    }
    catch (const std::exception &error) // what a planner throws is caught where it runs
    {
        send(kWorkerSocket, errorMessage(error.what()));
        return 2;
    }
}

} // namespace mrpp
