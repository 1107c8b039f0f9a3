#pragma once
/// \file
/// Curves and scores in which failures stay visible: they lengthen no median, but they lower every curve
/// here.

#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

/// A corner of a curve that rises by steps and is right-continuous.
struct StepPoint
{
    double x = 0;
    double y = 0;
    friend bool operator==(const StepPoint &, const StepPoint &) = default;
};

/// Penalized average runtime: the mean where every run without a time counts `factor` times the limit (PAR-2,
/// PAR-10). Nothing without runs. O(n).
[[nodiscard]] std::optional<double> penalizedAverage(std::span<const std::optional<double>> times,
                                                     double limit, double factor);

/// Share of `runs` whose value is at most x, a corner at each distinct value; it ends at values.size() /
/// runs. O(n log n). \pre runs ≥ values.size()
[[nodiscard]] std::vector<StepPoint> ecdf(std::vector<double> values, std::size_t runs);

/// Cactus plot: y is the time within which each of the x easiest runs was solved, x = 1, 2, …. O(n log n).
[[nodiscard]] std::vector<StepPoint> cactus(std::vector<double> times);

/// Costs that differ by no more than this share of the less, or by no more than that amount, count as equal.
struct Alike
{
    double share = 0;
    double amount = 0;

    [[nodiscard]] bool operator()(double less, double more) const
    {
        return more <= less * (1 + share) || more - less <= amount;
    }
};

/// Times: a tenth of them, or 0.1 ms, is what a machine's mood makes (docs/measurement.md).
inline constexpr Alike kAlikeTimes = {0.1, 1e-4};

/// Performance profiles: for each planner the share of the cases on which it needs at most x times what the
/// best planner of that case needs. E. Dolan and J. Moré, "Benchmarking optimization software with
/// performance profiles", Mathematical Programming 91(2), 2002. Every profile begins at x = 1; cases that
/// nobody solved count below, so none reaches 1 then. A best cost of 0 is matched by 0 alone. \param costs a
/// row a case, a column a planner; nothing where it failed. \param alike what counts as much as the best
/// cost: none unless said. O(cases · planners · log cases). \pre rows of equal size, costs ≥ 0
[[nodiscard]] std::vector<std::vector<StepPoint>>
performanceProfiles(const std::vector<std::vector<std::optional<double>>> &costs, const Alike &alike = {});

} // namespace mrpp
