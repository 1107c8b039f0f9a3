#include "framework/system/OutsideProgram.h"

#include "framework/system/Descriptor.h"
#include "framework/system/Spawn.h"
#include "framework/system/TailPipe.h"

#include <array>
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

pid_t start(const ProgramRequest &request, const TailPipe &output, const TailPipe &errors)
{
    const UnlimitedData unlimited;
    constexpr mode_t kOwn = 0600;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (request.output.empty())
        posix_spawn_file_actions_adddup2(&actions, output.writeEnd(), STDOUT_FILENO);
    else
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, request.output.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, kOwn);
    posix_spawn_file_actions_adddup2(&actions, errors.writeEnd(), STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    if (!request.folder.empty())
        posix_spawn_file_actions_addchdir_np(&actions, request.folder.c_str());
    const pid_t child = spawnGroup(request.words, actions);
    const int error = errno; // of spawnGroup
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return child;
}

/// Waits a moment, or until the process ends or writes. \param handle of the process, −1 where the system has
/// none
void waitAMoment(int handle, TailPipe &output, TailPipe &errors)
{
    constexpr int kMoment = 5; // milliseconds
    std::array<pollfd, 3> sources{
        {{handle, POLLIN, 0}, {output.readEnd(), POLLIN, 0}, {errors.readEnd(), POLLIN, 0}}};
    ::poll(sources.data(), sources.size(), handle < 0 ? 1 : kMoment);
    output.read();
    errors.read();
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
    TailPipe output;
    TailPipe errors(STDERR_FILENO);
    const pid_t child = start(request, output, errors);
    if (child < 0)
    {
        end.failure = std::strerror(errno);
        return end;
    }
    output.closeWriteEnd();
    errors.closeWriteEnd();
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
        waitAMoment(handle.number(), output, errors);
    }
    ::kill(-child, SIGKILL);
    output.read();
    errors.read();
    end.outputTail = output.take();
    end.errorTail = errors.take();
    end.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return end;
}

} // namespace mrpp
