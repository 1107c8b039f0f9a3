#include "framework/system/CpuTime.h"

#include <atomic>
#include <ctime>
#include <memory>
#include <sys/resource.h>

namespace mrpp
{

double processCpuTime()
{
    std::timespec own{};
    rusage children{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    ::getrusage(RUSAGE_CHILDREN, &children);
    const auto micros = children.ru_utime.tv_usec + children.ru_stime.tv_usec;
    return static_cast<double>(own.tv_sec + children.ru_utime.tv_sec + children.ru_stime.tv_sec) +
           static_cast<double>(own.tv_nsec) * 1e-9 + static_cast<double>(micros) * 1e-6;
}

TerminationCondition CpuWatch::limit(double seconds) const
{
    using Clock = TerminationCondition::Clock;
    struct State
    {
        std::atomic<Clock::rep> next = 0; ///< when the CPU clock is read again
        std::atomic<bool> reached = false;
    };
    const auto state = std::make_shared<State>();
    return TerminationCondition::when(
        [state, end = start_ + seconds]
        {
            constexpr Clock::duration kInterval = std::chrono::milliseconds(1);
            const Clock::rep now = Clock::now().time_since_epoch().count();
            if (state->reached || now < state->next)
                return state->reached.load();
            state->next = now + kInterval.count();
            state->reached = processCpuTime() >= end;
            return state->reached.load();
        });
}

} // namespace mrpp
