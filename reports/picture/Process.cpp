#include "reports/picture/Process.h"

#include "framework/system/Descriptor.h"
#include "framework/system/Spawn.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace mrpp
{

namespace
{

using Clock = std::chrono::steady_clock;

/// Starts the program with its output going into `output`; −1 where that fails.
pid_t spawn(const std::vector<std::string> &arguments, const std::filesystem::path &folder, int output)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);

    const pid_t child = spawnGroup(arguments, actions);
    posix_spawn_file_actions_destroy(&actions);
    return child;
}

/// Collects what comes out until the other end closes; false where the deadline came first. A look that comes
/// far too late was held up by a pause of this process (stopped, the machine asleep), which puts the deadline
/// off.
bool collect(int source, Clock::time_point &deadline, std::string &output)
{
    constexpr std::size_t kKept = std::size_t{64} << 10;
    constexpr int kLookAround = 100; // milliseconds
    constexpr std::chrono::seconds kPause{1};
    std::array<char, 4096> buffer{};
    for (Clock::time_point lastLook = Clock::now();;)
    {
        pollfd waited{source, POLLIN, 0};
        const bool any = ::poll(&waited, 1, kLookAround) > 0;
        const auto since = Clock::now() - std::exchange(lastLook, Clock::now());
        if (since > kPause)
            deadline += since;
        if (lastLook >= deadline + (any ? kPause : Clock::duration::zero())) // what waits is read first
            return false;
        if (!any)
            continue;
        const ssize_t size = ::read(source, buffer.data(), buffer.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size <= 0)
            return true;
        output.append(buffer.data(), std::min(static_cast<std::size_t>(size), kKept - output.size()));
    }
}

/// Waits until the child ends; false where the deadline came first.
bool waitFor(pid_t child, Clock::time_point deadline, int &status)
{
    for (;;)
    {
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child)
            return true;
        if ((ended < 0 && errno != EINTR) || Clock::now() >= deadline)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace

ProcessResult runProcess(const std::vector<std::string> &arguments, const std::filesystem::path &folder,
                         std::chrono::milliseconds limit)
{
    ProcessResult result;
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return result;
    Descriptor source(ends[0]);
    Descriptor sink(ends[1]);
    const pid_t child = spawn(arguments, folder, sink.number());
    sink.close();
    if (child < 0)
        return result;
    result.started = true;

    auto deadline = Clock::now() + limit;
    int status = 0;
    result.timedOut = !collect(source.number(), deadline, result.output) || !waitFor(child, deadline, status);
    if (result.timedOut)
    {
        ::kill(-child, SIGKILL);
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
            continue;
    }
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

} // namespace mrpp
