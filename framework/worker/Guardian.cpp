#include "framework/worker/Guardian.h"

#include "framework/support/HarnessError.h"
#include "framework/system/ProcessTree.h"
#include "framework/system/TemporaryFolder.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp
{

namespace
{

/// Waits until the worker ended, or has to: whether it ended, and then how.
bool waitForEnd(pid_t worker, int socket, int signals, int &status)
{
    for (;;)
    {
        pid_t ended = 0;
        while ((ended = ::waitpid(-1, &status, WNOHANG)) > 0)
            if (ended == worker)
                return true;
        std::array<pollfd, 2> sources{{{socket, POLLRDHUP, 0}, {signals, POLLIN, 0}}};
        if (::poll(sources.data(), sources.size(), -1) < 0 && errno != EINTR)
            return false;
        signalfd_siginfo signal{};
        if (sources[0].revents != 0)
            return false;
        if (sources[1].revents != 0 && ::read(signals, &signal, sizeof signal) == sizeof signal &&
            signal.ssi_signo == SIGTERM)
            return false;
    }
}

/// Ends this process by that signal, without leaving a core file of its own.
[[noreturn]] void endBy(int signal)
{
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    ::signal(signal, SIG_DFL);
    sigset_t all;
    ::sigfillset(&all);
    ::sigprocmask(SIG_UNBLOCK, &all, nullptr);
    ::kill(::getpid(), signal);
    constexpr int kAsShellsSay = 128;
    ::_exit(kAsShellsSay + signal);
}

} // namespace

void becomeGuarded(int socket)
{
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    sigset_t awaited;
    sigset_t before;
    ::sigemptyset(&awaited);
    ::sigaddset(&awaited, SIGCHLD);
    ::sigaddset(&awaited, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &awaited, &before);
    const int signals = ::signalfd(-1, &awaited, SFD_CLOEXEC);
    const pid_t guardian = ::getpid();
    const pid_t worker = ::fork();
    if (worker < 0)
        throw HarnessError(std::string("no process can be started for a worker: ") + std::strerror(errno));
    if (worker == 0)
    {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::prctl(PR_SET_CHILD_SUBREAPER, 1); // what a planner leaves behind is ended after its run
        ::close(signals);
        ::sigprocmask(SIG_SETMASK, &before, nullptr);
        if (::getppid() != guardian)
            ::_exit(0);
        return;
    }
    int status = 0;
    const bool ended = waitForEnd(worker, socket, signals, status);
    endChildren();
    removeStaleTemporaryFolders(); // of the worker, which could not do it
    if (!ended)
        endBy(SIGKILL);
    if (WIFSIGNALED(status))
        endBy(WTERMSIG(status));
    ::_exit(WEXITSTATUS(status));
}

} // namespace mrpp
