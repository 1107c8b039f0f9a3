#pragma once
/// \file
/// How soon a planner notices that it has to stop.

#include "tests/support/CpuClock.h"

#include <algorithm>

namespace mrpp::test
{

/// How long a planner may work without looking, in seconds; sanitizers and builds without optimization are
/// slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
inline constexpr double kPromptly = 1.0;
#else
inline constexpr double kPromptly = 0.05;
#endif

/// How long a planner works between two looks at its termination condition, in processor time, so that other
/// work on the machine does not count.
class PollWatch
{
public:
    explicit PollWatch(double limit) : start_(test::cpuSeconds()), last_(start_), limit_(limit) {}

    bool poll()
    {
        const double now = test::cpuSeconds();
        longest_ = std::max(longest_, now - last_);
        last_ = now;
        return now - start_ >= limit_;
    }

    [[nodiscard]] double longest() const { return longest_; }

private:
    double start_;
    double last_;
    double limit_; ///< processor seconds
    double longest_ = 0;
};

} // namespace mrpp::test
