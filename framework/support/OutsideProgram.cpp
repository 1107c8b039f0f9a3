#include "framework/support/OutsideProgram.h"

#include "framework/support/Descriptor.h"
#include "framework/support/Spawn.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

using Clock = std::chrono::steady_clock;

/// While it lives, what this process starts has no limit of data memory, which counts the stacks of threads
/// whole, used or not: outside programs are measured by what they use.
class UnlimitedData
{
public:
    UnlimitedData()
    {
        ::getrlimit(RLIMIT_DATA, &before_);
        const rlimit wide{before_.rlim_max, before_.rlim_max};
        ::setrlimit(RLIMIT_DATA, &wide);
    }
    ~UnlimitedData() { ::setrlimit(RLIMIT_DATA, &before_); }
    UnlimitedData(const UnlimitedData &) = delete;
    UnlimitedData &operator=(const UnlimitedData &) = delete;

private:
    rlimit before_{};
};

pid_t start(const ProgramRequest &request)
{
    const UnlimitedData unlimited;
    constexpr mode_t kOwn = 0600;
    const char *output = request.output.empty() ? "/dev/null" : request.output.c_str();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output, O_WRONLY | O_CREAT | O_TRUNC, kOwn);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    if (!request.folder.empty())
        posix_spawn_file_actions_addchdir_np(&actions, request.folder.c_str());
    const pid_t child = spawnGroup(request.words, actions);
    const int error = errno; // of spawnGroup
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return child;
}

/// Waits a moment, or until the process ends. \param handle of the process, −1 where the system has none
void waitAMoment(int handle)
{
    constexpr int kMoment = 5; // milliseconds
    pollfd process{handle, POLLIN, 0};
    ::poll(&process, 1, handle < 0 ? 1 : kMoment);
}

bool isTooLarge(const ProgramRequest &request)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(request.watched, error);
    return !error && size > request.mostBytes;
}

} // namespace

ProgramEnd runProgram(const ProgramRequest &request)
{
    ProgramEnd end;
    const pid_t child = start(request);
    if (child < 0)
    {
        end.failure = std::strerror(errno);
        return end;
    }
    const Descriptor handle(static_cast<int>(::syscall(SYS_pidfd_open, child, 0)));
    const auto never = Clock::time_point::max();
    auto deadline = never;
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0)
    {
        if (deadline == never && request.stop && request.stop())
            deadline = Clock::now() + request.grace;
        end.stopped = Clock::now() >= deadline;
        end.tooMuch = !request.watched.empty() && isTooLarge(request);
        if (end.stopped || end.tooMuch)
        {
            ::kill(-child, SIGKILL);
            while (::waitpid(child, &status, 0) < 0 && errno == EINTR)
                continue;
            break;
        }
        waitAMoment(handle.number());
    }
    ::kill(-child, SIGKILL);
    end.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return end;
}

} // namespace mrpp
