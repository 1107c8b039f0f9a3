#include "framework/campaign/Worker.h"

#include "framework/campaign/InProcessExecutor.h"
#include "framework/support/Error.h"
#include "framework/support/Memory.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
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

/// Kills this process and everything in its group as soon as the campaign's end of the socket is closed.
void dieWithCampaign()
{
    std::thread(
        []
        {
            pollfd campaign{kWorkerSocket, POLLRDHUP, 0};
            while (::poll(&campaign, 1, -1) < 0 && errno == EINTR)
                continue;
            ::kill(0, SIGKILL);
        })
        .detach();
}

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

/// The processes whose parent is this one.
std::vector<pid_t> children()
{
    std::vector<pid_t> found;
    std::error_code error;
    for (const auto &thread : std::filesystem::directory_iterator("/proc/self/task", error))
    {
        std::ifstream list(thread.path() / "children");
        for (pid_t child = 0; list >> child;)
            found.push_back(child);
    }
    return found;
}

/// Kills what a planner left running, and what that left running: orphans become children of this process.
void endChildren()
{
    constexpr int kPatience = 200; // rounds of a few milliseconds
    for (int round = 0; round < kPatience; ++round)
    {
        pid_t ended = 0;
        do
            ended = ::waitpid(-1, nullptr, WNOHANG);
        while (ended > 0);
        if (ended < 0)
            return; // nobody is left
        for (const pid_t child : children())
            ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + round / 10));
    }
}

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

/// Runs after runs, until the campaign is done.
void serve(const BenchmarkPlan &plan, const Catalog &catalog, MessageBuffer &buffer)
{
    const pid_t self = ::getpid();
    const auto onlyOnce = [self]
    {
        if (::getpid() != self)
            ::_exit(0); // a process that the planner forked came back from solve()
    };
    InProcessExecutor executor(plan, catalog, 1);
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
    while (const auto message = receive(buffer))
    {
        const auto spec = toSpec(*message);
        if (!spec || spec->point >= plan.points.size() || spec->planner >= plan.planners.size())
            throw InputError("the plan has changed while its campaign runs");
        const RunResult result = executor.execute(*spec, {});
        onlyOnce();
        unlimitGrowth();
        endChildren();
        if (!send(kWorkerSocket, toMessage(result)))
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
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    dieWithCampaign();
    try
    {
        const BenchmarkPlan plan = readPlan(*source);
        if (send(kWorkerSocket, {MessageKind::ready, {}}))
            serve(plan, catalog, buffer);
        return 0;
    }
    catch (const InputError &error)
    {
        send(kWorkerSocket, errorMessage(error.what()));
        return 2;
    }
}

} // namespace mrpp
