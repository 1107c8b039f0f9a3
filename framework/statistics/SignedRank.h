#pragma once
/// \file
/// Two planners on the same cases: does one need less, and how often?

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mrpp
{

/// Wilcoxon's signed-rank test of paired samples.
struct SignedRankTest
{
    std::size_t pairs = 0;   ///< whose values differ; only these are ranked
    std::size_t ties = 0;    ///< pairs of equal values, left out as Wilcoxon did
    double statistic = 0;    ///< V, the sum of the ranks of positive differences
    bool exact = false;      ///< p from the permutation distribution, else from the normal approximation
    std::optional<double> p; ///< two-sided; nothing where there are too few pairs
    std::string refusal;     ///< why there is no p

    /// The matched-pairs rank-biserial correlation, −1 … 1: the share of the rank sum that positive
    /// differences have minus that of the negative ones (D. Kerby, "The simple difference formula",
    /// Comprehensive Psychology 3, 2014; effectsize::rank_biserial(paired = TRUE) of R, which leaves ties
    /// out, too). Its sign is the direction of which p speaks. 0 where nothing differs.
    [[nodiscard]] double rankBiserial() const;
};

/// With fewer pairs that differ, no outcome is rarer than one in twenty.
inline constexpr std::size_t kLeastForSignedRank = 6;

/// Tests whether the differences are symmetric around 0. Only their signs and the order of their sizes
/// matter; sizes are ties where they are equal, so that what should be a tie has to be equal exactly (see
/// comparePairs()). Up to 50 pairs that differ p is exact given the ranks, which ties share (R's wilcox.test
/// where there are none, wilcox.exact of exactRankTests where there are; the zero_method "wilcox" of
/// scipy.stats.wilcoxon); beyond, normal with corrections for ties and continuity, as wilcox.test. F.
/// Wilcoxon, "Individual comparisons by ranking methods", Biometrics Bulletin 1(6), 1945. O(n log n), exact
/// O(n³).
[[nodiscard]] SignedRankTest signedRankTest(std::span<const double> differences);

/// Adjusted p-values for testing several hypotheses at once, in the order given: S. Holm, "A simple
/// sequentially rejective multiple test procedure", Scandinavian Journal of Statistics 6(2), 1979. O(n log
/// n).
[[nodiscard]] std::vector<double> holmAdjusted(std::span<const double> p);

/// Ranks 1 … n, equal values sharing the mean of theirs. O(n log n).
[[nodiscard]] std::vector<double> ranks(std::span<const double> values);

} // namespace mrpp
