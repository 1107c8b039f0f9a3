#pragma once
/// \file
/// Results summed up: the runs of one planner at one sweep point, with medians and quartiles.
///
/// Costs are summed up over the solved runs only, so every number carries the count that it stands for: a
/// planner that solves the easy half alone would otherwise look better than one that solves everything.

#include "framework/campaign/RunRecord.h"
#include "framework/support/Quantiles.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

/// All repetitions of one planner on one problem (at one sweep point).
struct RunGroup
{
    std::string model;
    std::string problem;
    std::string sweepVariable; ///< empty where nothing is swept
    std::optional<double> sweepValue;
    std::string planner;
    std::vector<const RunRecord *> runs; ///< in the records' order, never empty

    [[nodiscard]] std::size_t solved() const;
    [[nodiscard]] std::size_t count(PlannerStatus status) const;
    /// Runs whose instance has a solution under the planner's motion rule, as far as anybody knows.
    [[nodiscard]] std::size_t solvable() const;
    /// solved / runs, 0 … 1.
    [[nodiscard]] double successRate() const;
    /// Of a numeric column over the solved runs that have it; nothing where none has.
    [[nodiscard]] std::optional<Quartiles> overSolved(std::string_view column) const;
    /// Of cost / bound over the solved runs that have both and whose bound is positive.
    [[nodiscard]] std::optional<Quartiles> ratio(std::string_view cost, std::string_view bound) const;
    /// Penalized average time (PAR): every run that failed counts `factor` times the limit. Seconds.
    [[nodiscard]] double penalizedTime(double limit, double factor) const;
};

/// Groups in the order in which their first runs stand. The records must outlive the groups.
[[nodiscard]] std::vector<RunGroup> groupRuns(std::span<const RunRecord> records);

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

} // namespace mrpp
