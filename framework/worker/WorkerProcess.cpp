#include "framework/worker/WorkerProcess.h"

#include "framework/support/Error.h"
#include "framework/system/ProcessTree.h"
#include "framework/system/Spawn.h"
#include "framework/worker/Worker.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace mrpp
{

namespace
{

constexpr std::size_t kKeptErrorOutput = 2048;

pid_t spawn(const std::vector<std::string> &command, int socket, int errors)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, socket, kWorkerSocket);

    const pid_t child = spawnGroup(command, actions);
    const int error = errno; // of spawnGroup
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return child;
}

} // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string> &command, const CoreSet &cores)
{
    std::array<int, 2> sockets{};
    std::array<int, 2> pipe{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) == 0)
    {
        socket_ = Descriptor(sockets[0]);
        const Descriptor workerSocket(sockets[1]);
        if (::pipe2(pipe.data(), O_CLOEXEC) == 0)
        {
            errors_ = Descriptor(pipe[0]);
            const Descriptor workerErrors(pipe[1]);
            ::fcntl(errors_.number(), F_SETFL, O_NONBLOCK);
            pid_ = spawn(command, workerSocket.number(), workerErrors.number());
        }
    }
    if (pid_ < 0)
        throw FileError(command.front() + ": cannot be started as a worker: " + std::strerror(errno));
    // It waits for the plan before it starts others: all of them inherit both.
    if (!cores.empty() && confine(pid_, cores))
        cores_ = cores;
    group_ = ControlGroup::make();
    if (group_ && !group_->add(pid_))
        group_.reset();
}

WorkerProcess::~WorkerProcess()
{
    if (pid_ > 0)
        (void)end();
}

std::optional<Message> WorkerProcess::receive(const std::function<bool()> &isOver)
{
    constexpr int kLookAround = 50; // milliseconds
    for (;;)
    {
        if (auto message = buffer_.next())
            return message;
        std::array<pollfd, 2> sources{{{socket_.number(), POLLIN, 0}, {errors_.number(), POLLIN, 0}}};
        const bool any = ::poll(sources.data(), sources.size(), kLookAround) > 0;
        if (any && sources[1].revents != 0)
            readErrorOutput();
        if (any && sources[0].revents != 0)
        {
            if (!buffer_.readFrom(socket_.number()))
                return std::nullopt;
        }
        else if (isOver())
        {
            return std::nullopt;
        }
    }
}

pid_t WorkerProcess::worker() const
{
    if (worker_ < 0)
        if (const std::vector<pid_t> children = childrenOf(pid_); !children.empty())
            worker_ = children.front();
    return worker_;
}

bool WorkerProcess::isStopped() const
{
    return mrpp::isStopped(worker());
}

WorkerProcess::End WorkerProcess::end()
{
    constexpr int kPatience = 5000; // milliseconds, for its guardian to end what the planner started
    pollfd socket{socket_.number(), POLLRDHUP, 0};
    const bool isGone = ::poll(&socket, 1, 0) > 0 && (socket.revents & (POLLRDHUP | POLLHUP)) != 0;
    if (!isGone)
        ::kill(pid_, SIGTERM);
    ::kill(-pid_, SIGCONT); // who is stopped would not hear it
    int status = 0;
    pid_t ended = 0;
    for (int i = 0; i < kPatience && (ended = ::waitpid(pid_, &status, WNOHANG)) == 0; ++i)
        ::poll(nullptr, 0, 1);
    ::kill(-pid_, SIGKILL);
    while (ended <= 0 && (ended = ::waitpid(pid_, &status, 0)) < 0 && errno == EINTR)
        continue;
    pid_ = -1;
    group_.reset();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

double WorkerProcess::cpuTime() const
{
    const auto counted = group_ ? group_->cpuTime() : std::nullopt;
    return counted ? *counted : treeCpuTime(pid_);
}

double WorkerProcess::childrenMemory() const
{
    double sum = 0;
    for (const pid_t process : descendantsOf(worker()))
        sum += ownMemory(process);
    return sum;
}

std::string WorkerProcess::takeErrorOutput()
{
    readErrorOutput();
    return std::exchange(errorOutput_, {});
}

void WorkerProcess::readErrorOutput()
{
    constexpr int kPiecesAtOnce = 64; // who writes without end must not hold up the campaign
    std::array<char, 65536> piece{};
    for (int i = 0; i < kPiecesAtOnce; ++i)
    {
        const ssize_t count = ::read(errors_.number(), piece.data(), piece.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count == 0)
            errors_.close(); // poll() leaves out a descriptor of −1
        if (count <= 0)
            return;
        errorOutput_.append(piece.data(), static_cast<std::size_t>(count));
        if (errorOutput_.size() > kKeptErrorOutput)
            errorOutput_.erase(0, errorOutput_.size() - kKeptErrorOutput);
    }
}

} // namespace mrpp
