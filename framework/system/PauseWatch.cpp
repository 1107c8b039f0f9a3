#include "framework/system/PauseWatch.h"

#include <csignal>
#include <ctime>

namespace mrpp
{

namespace
{

sigset_t continuation()
{
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGCONT);
    return signals;
}

/// The monotonic clock stands while the machine sleeps; the other does not.
double sleptSoFar()
{
    std::timespec always{};
    std::timespec awake{};
    ::clock_gettime(CLOCK_MONOTONIC, &awake);
    ::clock_gettime(CLOCK_BOOTTIME, &always);
    return static_cast<double>(always.tv_sec - awake.tv_sec) +
           static_cast<double>(always.tv_nsec - awake.tv_nsec) * 1e-9;
}

} // namespace

PauseWatch::PauseWatch() : slept_(sleptSoFar())
{
    const sigset_t signals = continuation();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

std::uint64_t PauseWatch::count()
{
    constexpr std::timespec kNow{0, 0};
    constexpr double kShortestSleep = 0.05; // seconds; the two clocks are not read at one moment
    const sigset_t signals = continuation();
    const std::lock_guard lock(mutex_);
    while (::sigtimedwait(&signals, nullptr, &kNow) > 0)
        ++count_;
    if (const double slept = sleptSoFar(); slept > slept_ + kShortestSleep)
    {
        slept_ = slept;
        ++count_;
    }
    return count_;
}

} // namespace mrpp
