#pragma once
/// \file
/// Results summed up: the answers of one planner at one sweep point, with medians and quartiles.
///
/// Every planner's median at a place is over the same instances, so that medians may be compared: those that
/// all planners there have finished and that have a solution under the rule of one of them. A planner that
/// has none for an instance stands above all costs there. So no planner looks better by solving the easy
/// instances alone, its median exists while it solves more than half, and it is never below the median of a
/// lower bound.

#include "framework/run/RunRecord.h"
#include "framework/statistics/Quantiles.h"
#include "reports/Answer.h"

#include <compare>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

/// Runs at one place are summed up together: those of one problem, at one sweep point.
struct RunPlace
{
    std::string model;
    std::string problem;
    std::string sweepVariable; ///< empty where nothing is swept
    std::optional<double> sweepValue;

    friend auto operator<=>(const RunPlace &, const RunPlace &) = default; // NOLINT(modernize-use-nullptr)
};

/// All runs of one planner at one place.
struct RunGroup : RunPlace
{
    std::string planner;
    std::string rule;                    ///< the motion rule of the planner's solutions
    std::vector<const RunRecord *> runs; ///< in the records' order, never empty

    std::vector<Answer> answers;  ///< one an instance: runs on copies of it are one answer
    std::vector<char> isCompared; ///< of each answer: whether its instance is among those that costs are over

    [[nodiscard]] std::size_t solved() const { return count(Outcome::solved); }
    [[nodiscard]] std::size_t count(Outcome outcome) const;
    [[nodiscard]] std::size_t count(PlannerStatus status) const;
    /// Instances that have a solution under the planner's motion rule, as far as anybody knows, and to which
    /// it applies.
    [[nodiscard]] std::size_t counted() const;
    /// solved / counted, 0 … 1; nothing where none counts.
    [[nodiscard]] std::optional<double> successRate() const;

    /// Of a numeric column over the compared instances; of a cost nothing unless more than half of them are
    /// solved, and q3 is infinite where a quarter is not.
    [[nodiscard]] std::optional<Quartiles> cost(std::string_view column) const;
    /// Of cost / bound, instance by instance, where the bound is positive.
    [[nodiscard]] std::optional<Quartiles> ratio(std::string_view cost, std::string_view bound) const;
    /// The column's values on the compared instances; a cost without an answer is infinite. Where a column is
    /// no cost (isCost()), and where a solved instance has no value, that instance is left out.
    [[nodiscard]] std::vector<double> costs(std::string_view column) const;

    /// Penalized average time (PAR) over the instances that count: one that failed counts `factor` times the
    /// limit. Seconds; nothing where none counts.
    [[nodiscard]] std::optional<double> penalizedTime(double limit, double factor) const;
};

/// Groups in the order in which their first runs stand. The records must outlive the groups.
[[nodiscard]] std::vector<RunGroup> groupRuns(std::span<const RunRecord> records);

/// The same by other places; runs without one are left out.
[[nodiscard]] std::vector<RunGroup>
groupRuns(std::span<const RunRecord> records,
          const std::function<std::optional<RunPlace>(const RunRecord &)> &placeOf);

/// Whether a column is something that a planner spends, so that no answer is worse than any: a metric that is
/// better when it is lower, and no lower bound.
[[nodiscard]] bool isCost(std::string_view column);

/// One problem, or one sweep over its points.
struct ProblemSummary
{
    std::string model;
    std::string problem;
    std::string sweepVariable;    ///< empty where nothing is swept
    std::vector<RunGroup> groups; ///< by sweep point, then planner

    [[nodiscard]] bool swept() const { return !sweepVariable.empty(); }
};

/// The groups of each problem, sweep points ascending.
[[nodiscard]] std::vector<ProblemSummary> summarizeProblems(std::span<const RunRecord> records);

/// A column as an axis or a heading names it: "Path length (moves)"; the column's own name where it is no
/// metric.
[[nodiscard]] std::string metricTitle(std::string_view column);

/// A planner beside the rule that its solutions need: "push_and_spin (rotation)". Planners under different
/// rules are not to be compared without a word.
[[nodiscard]] std::string withRule(std::string_view planner, std::string_view rule);

} // namespace mrpp
