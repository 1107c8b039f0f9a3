#pragma once
/// \file
/// Processor time of this process, for tests with a time limit: other work on the machine does not count.

#include <ctime>

namespace mrpp::test
{

/// Seconds of processor time so far.
inline double cpuSeconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace mrpp::test
