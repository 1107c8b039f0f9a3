#pragma once
/// \file
/// Costs of two planners, or of one planner twice, on the same cases: who needs less, by how much, and
/// whether that may be chance.

#include "framework/statistics/Interval.h"
#include "framework/statistics/SignedRank.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

struct PairedComparison
{
    std::size_t pairs = 0;
    std::size_t firstLess = 0;
    std::size_t secondLess = 0;
    double medianRatio = 1;                ///< of first / second; 0/0 is 1, and what is over 0 infinite
    std::optional<Interval> ratioInterval; ///< 95 %, see medianInterval(); nothing of too few pairs
    SignedRankTest test; ///< of the ratios' logarithms, so that no large case outweighs all others

    enum class Direction
    {
        none,    ///< the ranks of both sides sum up to the same
        first,   ///< the first needs less
        second,  ///< the second needs less
        unclear, ///< the ranks say one thing, the median ratio or the number of cases won the other
    };
    /// Of the statistic that p is about.
    [[nodiscard]] Direction direction() const;

    /// 1 where the first needs less whenever they differ, −1 where the second does: the matched-pairs
    /// rank-biserial correlation, towards the first.
    [[nodiscard]] double rankBiserial() const;
};

/// \pre equal sizes, costs finite and not negative. O(n log n).
[[nodiscard]] PairedComparison comparePairs(std::span<const double> first, std::span<const double> second);

/// What signedRankTest() may be given for the logarithms of first / second: numbers of their signs, in the
/// order of their sizes, equal where the ratios (or one and the other's inverse) are. Ratios are compared
/// exactly, as products of whole numbers: 2/1 and 4/2 are a tie, which their logarithms' differences are not.
/// Costs count as multiples of 0.5·10⁻⁹, or of 0.5 where one is above 4·10⁹. \pre as comparePairs(). O(n log
/// n).
[[nodiscard]] std::vector<double> orderOfRatios(std::span<const double> first,
                                                std::span<const double> second);

} // namespace mrpp
