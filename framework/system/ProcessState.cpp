#include "framework/system/ProcessState.h"

#include <cerrno>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

extern char **environ;

namespace mrpp
{

namespace
{

mode_t currentUmask()
{
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return mask;
}

int currentPriority()
{
    return ::getpriority(PRIO_PROCESS, 0);
}

bool isSame(const rlimit &a, const rlimit &b)
{
    return a.rlim_cur == b.rlim_cur && a.rlim_max == b.rlim_max;
}

bool isSame(const struct sigaction &a, const struct sigaction &b)
{
    return a.sa_handler == b.sa_handler && a.sa_flags == b.sa_flags;
}

} // namespace

ProcessState::Lasting ProcessState::lastingNow()
{
    Lasting now;
    struct stat status = {};
    for (std::size_t i = 0; i < now.open.size(); ++i)
        if (::fstat(static_cast<int>(i), &status) == 0)
            now.open[i] = {status.st_dev, status.st_ino};
    if (::stat("/", &status) == 0)
        now.root = {status.st_dev, status.st_ino};
    if (::stat("/proc/self/task", &status) == 0)
        now.threads = status.st_nlink; // a folder a thread
    now.firstFree = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
    if (now.firstFree >= 0)
        ::close(now.firstFree);
    ::getresuid(&now.user[0], &now.user[1], &now.user[2]);
    ::getresgid(&now.group[0], &now.group[1], &now.group[2]);
    now.noNewRights = ::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0);
    now.systemCalls = ::prctl(PR_GET_SECCOMP, 0, 0, 0, 0);
    return now;
}

ProcessState::ProcessState()
    : folder_(::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)), umask_(currentUmask()),
      locale_(std::setlocale(LC_ALL, nullptr)), priority_(currentPriority())
{
    for (std::size_t i = 0; i < limits_.size(); ++i)
        ::getrlimit(static_cast<__rlimit_resource>(i), &limits_[i]);
    for (int signal = 1; signal < kSignals; ++signal)
        ::sigaction(signal, nullptr, &actions_[static_cast<std::size_t>(signal)]);
    ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked_);
    for (char **variable = environ; variable != nullptr && *variable != nullptr; ++variable)
        environment_.emplace_back(*variable);
    ::sched_getaffinity(0, sizeof cores_, &cores_);
    std::fegetenv(&rounding_);
    lasting_ = lastingNow();
}

ProcessState::~ProcessState()
{
    ::close(folder_);
}

bool ProcessState::restore() const
{
    // The limits come first: the others may need descriptors.
    const bool limits = restoreLimits();
    ::umask(umask_);
    restoreSignals();
    restoreEnvironment();
    if (std::locale() != streams_)
        std::locale::global(streams_);
    if (locale_ != std::setlocale(LC_ALL, nullptr))
        std::setlocale(LC_ALL, locale_.c_str());
    std::set_new_handler(outOfMemory_);
    std::set_terminate(atTheEnd_);
    std::fesetenv(&rounding_);
    return restoreFolder() && limits && restoreScheduling() && lastingNow() == lasting_;
}

bool ProcessState::restoreFolder() const
{
    return ::fchdir(folder_) == 0;
}

bool ProcessState::restoreLimits() const
{
    bool restored = true;
    for (std::size_t i = 0; i < limits_.size(); ++i)
    {
        const auto resource = static_cast<__rlimit_resource>(i);
        rlimit now{};
        if (::getrlimit(resource, &now) == 0 && !isSame(now, limits_[i]))
            restored &= ::setrlimit(resource, &limits_[i]) == 0;
    }
    return restored;
}

void ProcessState::restoreSignals() const
{
    constexpr itimerval kNever{};
    for (const auto timer : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF})
        ::setitimer(timer, &kNever, nullptr);
    for (int signal = 1; signal < kSignals; ++signal)
    {
        const struct sigaction &before = actions_[static_cast<std::size_t>(signal)];
        struct sigaction now = {};
        if (::sigaction(signal, nullptr, &now) == 0 && !isSame(before, now))
            ::sigaction(signal, &before, nullptr);
    }
    ::pthread_sigmask(SIG_SETMASK, &blocked_, nullptr);
}

void ProcessState::restoreEnvironment() const
{
    std::size_t same = 0;
    while (environ != nullptr && environ[same] != nullptr && same < environment_.size() &&
           environment_[same] == environ[same])
        ++same;
    const bool ends = environ == nullptr || environ[same] == nullptr;
    if (ends && same == environment_.size())
        return;
    ::clearenv();
    for (const std::string &variable : environment_)
        if (const std::size_t sign = variable.find('='); sign != std::string::npos)
            ::setenv(variable.substr(0, sign).c_str(), variable.c_str() + sign + 1, 1);
}

bool ProcessState::restoreScheduling() const
{
    cpu_set_t cores{};
    ::sched_getaffinity(0, sizeof cores, &cores);
    if (CPU_EQUAL(&cores, &cores_) == 0 && ::sched_setaffinity(0, sizeof cores_, &cores_) != 0)
        return false;
    return currentPriority() == priority_ || ::setpriority(PRIO_PROCESS, 0, priority_) == 0;
}

} // namespace mrpp
