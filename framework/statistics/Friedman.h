#pragma once
/// \file
/// Several planners on many problems: do their ranks differ, and by how much must they to matter?
///
/// J. Demšar, "Statistical comparisons of classifiers over multiple data sets", JMLR 7, 2006.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct FriedmanTest
{
    std::size_t problems = 0;
    std::vector<double> meanRanks; ///< one a planner, 1 the best
    double chiSquared = 0;         ///< corrected for ties, as R's friedman.test
    double f = 0;            ///< R. Iman and J. Davenport's statistic, less conservative; ∞ where all agree
    std::optional<double> p; ///< of f; nothing where there are too few problems or planners
    double chiSquaredP = 1;  ///< of chiSquared
    double criticalDifference = 0; ///< of two mean ranks, Nemenyi, at level 0.05
    std::string refusal;           ///< why there is no p
};

inline constexpr std::size_t kLeastForFriedman = 10; ///< problems; below, its distributions are far off

/// \param costs a row a problem, a column a planner; smaller is better, equal costs share ranks. Two planners
/// are refused: signedRankTest() is theirs. \pre rows of equal size. O(problems · planners · log planners).
[[nodiscard]] FriedmanTest friedmanTest(const std::vector<std::vector<double>> &costs);

/// What the critical difference is measured in: the quantile of the studentized range of k values with
/// infinitely many degrees of freedom, over √2 (2.343 for k = 3 and level 0.05). \pre 2 ≤ k, 0 < level < 1
[[nodiscard]] double nemenyiQuantile(std::size_t k, double level = 0.05);

/// Groups of neighbours whose mean ranks all lie within the critical difference, each as large as can be;
/// pairs of first and last position in the order of ascending mean rank. Groups of one are left out.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>>
indistinguishable(std::vector<double> meanRanks, double criticalDifference);

} // namespace mrpp
