#pragma once
/// \file
/// CPU seconds that this process used, and a watch that says when they are too many.

#include "framework/support/TerminationCondition.h"

namespace mrpp
{

/// Of this process's threads and of the processes that it started and waited for, since it began.
[[nodiscard]] double processCpuTime();

/// Measures from its construction on.
class CpuWatch
{
public:
    CpuWatch() : start_(processCpuTime()) {}

    [[nodiscard]] double seconds() const { return processCpuTime() - start_; }

    /// Stops `seconds` of CPU time after the watch began. Reading that clock takes a system call: it is read
    /// once a millisecond of wall time, whoever asks how often.
    [[nodiscard]] TerminationCondition limit(double seconds) const;

private:
    double start_;
};

} // namespace mrpp
