#pragma once
/// \file
/// Costs of two planners, or of one planner twice, on the same cases: who needs less, by how much, and
/// whether that may be chance.

#include "framework/support/Interval.h"
#include "framework/support/SignedRank.h"

#include <cstddef>
#include <optional>
#include <span>

namespace mrpp
{

struct PairedComparison
{
    std::size_t pairs = 0;
    std::size_t firstLess = 0;
    std::size_t secondLess = 0;
    double medianRatio = 1;                ///< of first / second over the pairs where both are positive
    std::optional<Interval> ratioInterval; ///< 95 % BCa bootstrap; nothing of too few pairs
    SignedRankTest test; ///< of the costs' logarithms, so that no large case outweighs all others
    double a12 = 0.5;    ///< chance that a cost of the first exceeds one of the second
};

/// \pre equal sizes, no negative costs. A cost of 0 counts as the least positive one halved. O(n log n + 2000
/// n).
[[nodiscard]] PairedComparison comparePairs(std::span<const double> first, std::span<const double> second);

} // namespace mrpp
