#pragma once
/// \file
/// What a campaign shows about its planners, as tests and as plain sentences that name their numbers.

#include "framework/statistics/PairedComparison.h"
#include "reports/summary/CaseTable.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// Times that differ by less are no finding, however surely they do.
inline constexpr double kLeastTimeRatio = 1.1;

/// Two planners compared by one measure on the instances that both solved; the ranks of the test are in
/// favour of the first.
struct CostFinding
{
    std::string first; ///< planners' names
    std::string second;
    std::string firstRule; ///< motion rules of their solutions
    std::string secondRule;
    std::string column;
    PairedComparison comparison;
    std::size_t pointsLess = 0; ///< sweep points (or problems) where the first's median is smaller
    std::size_t points = 0;     ///< where both solved an instance
    std::optional<double> p;    ///< Holm's correction over all cost tests; nothing where the test refused

    [[nodiscard]] bool isSignificant() const { return p && *p < 0.05; }
    /// Whether ranks, median ratio and the number of instances won agree on who needs less.
    [[nodiscard]] bool isClear() const;
    /// A time whose median ratio is less than kLeastTimeRatio.
    [[nodiscard]] bool isSmall() const;
    /// "A needs fewer moves than B on 18 of 20 points, median ratio 0.71, 95 % CI 0.66–0.77 (…)."; where it
    /// is not clear, that they differ and what the numbers say. \pre isSignificant()
    [[nodiscard]] std::string sentence() const;
};

/// Two planners compared by what they answered; the first answered no fewer.
struct SuccessFinding
{
    enum class Kind
    {
        solved, ///< instances that have a solution under both motion rules and to which both apply
        proved, ///< those that have none under both and to which both apply: who proved it
    };
    Kind kind = Kind::solved;
    std::string first;
    std::string second;
    std::string firstRule;
    std::string secondRule;
    std::size_t cases = 0;
    std::size_t firstAnswered = 0;
    std::size_t secondAnswered = 0;
    std::size_t onlyFirst = 0;
    std::size_t onlySecond = 0;
    std::optional<double> p; ///< McNemar's exact test, Holm's correction over all success tests
    std::string refusal;     ///< why there is no p

    [[nodiscard]] bool isSignificant() const { return p && *p < 0.05; }
    [[nodiscard]] std::string sentence() const;
};

struct Findings
{
    std::vector<SuccessFinding> success; ///< by kind, then pair
    std::vector<CostFinding> costs;      ///< by measure (path length, makespan, time), then pair
    std::string caveat;                  ///< where planners obey different motion rules, which; else empty

    /// One sentence for each difference that is significant, then in one sentence a measure those that are
    /// not, and those that were not tested with the reason.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// All pairs of planners. O(pairs · cases · log cases).
[[nodiscard]] Findings findingsOf(const CaseTable &cases);

/// "p < 0.001" or "p = 0.012".
[[nodiscard]] std::string pText(double p);

/// A ratio with as many digits as it takes to tell it from 0 and from 1: "0.71", "0.0042", "1.0003", "1",
/// "∞".
[[nodiscard]] std::string ratioText(double ratio);

} // namespace mrpp
