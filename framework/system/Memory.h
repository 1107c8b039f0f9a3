#pragma once
/// \file
/// How much memory this process uses, from /proc. (`getrusage`'s maximum inherits the parent's size.)

#include <cstdint>

namespace mrpp
{

/// Forgets the peak so far, so that peakMemory() tells the peak from now on. False where the system does not
/// allow it; then peakMemory() is that of the whole process.
bool resetPeakMemory();

/// The largest resident size since resetPeakMemory(), in MB (10^6 bytes); 0 where it is unknown.
[[nodiscard]] double peakMemory();

/// Gives memory that was freed, but kept for later, back to the system.
void releaseFreeMemory();

/// Bytes of private writable memory (heap, stacks), which RLIMIT_DATA limits; 0 where it is unknown.
[[nodiscard]] std::uint64_t dataMemory();

} // namespace mrpp
