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
};

/// With fewer pairs that differ, no outcome is rarer than one in twenty.
inline constexpr std::size_t kLeastForSignedRank = 6;

/// Tests whether the differences first − second are symmetric around 0. Up to 50 pairs p is exact given the
/// ranks, which ties share (R's wilcox.test where there are none, wilcox.exact of exactRankTests where there
/// are); beyond, normal with corrections for ties and continuity, as wilcox.test. F. Wilcoxon, "Individual
/// comparisons by ranking methods", Biometrics Bulletin 1(6), 1945. \pre equal sizes. O(n log n), exact
/// O(n³).
[[nodiscard]] SignedRankTest signedRankTest(std::span<const double> first, std::span<const double> second);

/// Adjusted p-values for testing several hypotheses at once, in the order given: S. Holm, "A simple
/// sequentially rejective multiple test procedure", Scandinavian Journal of Statistics 6(2), 1979. O(n log
/// n).
[[nodiscard]] std::vector<double> holmAdjusted(std::span<const double> p);

/// A₁₂ = P(X > Y) + ½ P(X = Y), the chance that a value of `first` exceeds one of `second`: A. Vargha and H.
/// Delaney, "A critique and improvement of the CL common language effect size statistics", JEBS 25(2), 2000.
/// ½ where one is empty. O((n + m) log(n + m)).
[[nodiscard]] double effectSizeA12(std::span<const double> first, std::span<const double> second);

/// Ranks 1 … n, equal values sharing the mean of theirs. O(n log n).
[[nodiscard]] std::vector<double> ranks(std::span<const double> values);

} // namespace mrpp
