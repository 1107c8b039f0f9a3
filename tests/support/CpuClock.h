#pragma once
/// \file
/// Processor time of this process, for tests with a time limit: other work on the machine does not count, nor
/// does it that the machine is slower than the one on which the limits were set.

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <utility>
#include <vector>

namespace mrpp::test
{

/// Seconds of processor time so far, as this machine counts them.
inline double ownCpuSeconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How many times as long this machine takes as those on which the limits of tests were set, by a walk
/// through 4 MB in random order; 1 … 4, so that it excuses no defect.
inline double slowness()
{
    constexpr std::uint32_t kCells = 1U << 20U;
    constexpr double kUsual = 0.08; // seconds
    std::vector<std::uint32_t> next(kCells);
    for (std::uint32_t i = 0; i < kCells; ++i)
        next[i] = i;
    std::uint64_t state = 1;
    const double begin = ownCpuSeconds();
    for (std::uint32_t i = kCells; i-- > 1;) // one cycle through all (S. Sattolo, 1986)
    {
        state = state * 6364136223846793005U + 1442695040888963407U;
        std::swap(next[i], next[(state >> 33U) % i]);
    }
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < kCells; ++i)
        at = next[at];
    const double taken = at == 0 ? ownCpuSeconds() - begin : kUsual;
    return std::clamp(taken / kUsual, 1.0, 4.0);
}

/// Seconds of processor time so far, of a usual machine.
inline double cpuSeconds()
{
    static const double times = slowness();
    return ownCpuSeconds() / times;
}

} // namespace mrpp::test
