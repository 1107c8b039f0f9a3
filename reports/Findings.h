#pragma once
/// \file
/// What a campaign shows about its planners, as tests and as plain sentences that name their numbers.

#include "framework/support/PairedComparison.h"
#include "reports/CaseTable.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// Two planners compared by one measure on the cases that both solved; the first needs less by the median
/// ratio.
struct CostFinding
{
    std::string first;
    std::string second;
    std::string column;
    PairedComparison comparison;
    std::size_t pointsLess = 0; ///< sweep points (or problems) where the first's median is smaller
    std::size_t points = 0;     ///< where both solved a case
    std::optional<double> p;    ///< Holm's correction over all cost tests; nothing where the test refused

    [[nodiscard]] bool isSignificant() const { return p && *p < 0.05; }
    /// "A needs fewer moves than B on 18 of 20 points, median ratio 0.71, 95 % CI 0.66–0.77 (…)."
    [[nodiscard]] std::string sentence() const;
};

/// Two planners compared by what they solved on the cases that both have finished; the first solved no fewer.
struct SuccessFinding
{
    std::string first;
    std::string second;
    std::size_t cases = 0;
    std::size_t firstSolved = 0;
    std::size_t secondSolved = 0;
    std::size_t onlyFirst = 0;
    std::size_t onlySecond = 0;
    double p = 1; ///< McNemar's exact test, Holm's correction over all success tests

    [[nodiscard]] bool isSignificant() const { return p < 0.05; }
    [[nodiscard]] std::string sentence() const;
};

struct Findings
{
    std::vector<SuccessFinding> success;
    std::vector<CostFinding> costs; ///< by measure (path length, makespan, time), then pair

    /// One sentence for each difference that is significant, then in one sentence a measure those that are
    /// not, and those that were not tested with the reason.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// All pairs of planners. O(pairs · cases · resamples).
[[nodiscard]] Findings findingsOf(const CaseTable &cases);

/// "p < 0.001" or "p = 0.012".
[[nodiscard]] std::string pText(double p);

} // namespace mrpp
