#pragma once
/// \file
/// Shares of successes: their intervals, and whether two of them differ on the same cases.

#include "framework/statistics/Interval.h"

#include <cstddef>

namespace mrpp
{

/// Wilson's score interval of a success rate: E. B. Wilson, "Probable inference, the law of succession, and
/// statistical inference", JASA 22, 1927; method 3 of R. Newcombe, Statistics in Medicine 17, 1998. [0, 1]
/// without trials.
[[nodiscard]] Interval wilsonInterval(std::size_t successes, std::size_t trials, double confidence = 0.95);

/// Two-sided p of the sign test: the probability that a fair coin splits as unevenly as `wins` and `losses`
/// or more so; of discordant pairs this is McNemar's exact test. 1 without any.
[[nodiscard]] double signTest(std::size_t wins, std::size_t losses);

/// With fewer pairs that differ, not even all of them on one side are rarer than one in twenty: such a test
/// can find nothing, and counts for no correction of others (R. Tarone, "A modified Bonferroni method for
/// discrete data", Biometrics 46, 1990).
inline constexpr std::size_t kLeastForSignTest = 6;

} // namespace mrpp
