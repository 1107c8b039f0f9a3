#pragma once
/// \file
/// What is measured about a run, and what each measure is called in every file and figure.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Solution.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace mrpp
{

/// One column of results, for `mrppsim list metrics`, tables and axes.
struct Metric
{
    enum class Better
    {
        lower,
        higher,
    };
    std::string_view name;  ///< column name: "path_length"
    std::string_view title; ///< for headings and axes: "Path length"
    std::string_view unit;  ///< "moves", "steps", "s", "MB", ""
    Better better = Better::lower;
    std::string_view description; ///< one sentence
};

/// All metrics, in the order of the columns.
[[nodiscard]] std::span<const Metric> metrics();

/// The metric of that name, or null.
[[nodiscard]] const Metric *findMetric(std::string_view name);

/// The measures of one solution. See the docs page "Metrics".
struct SolutionMetrics
{
    std::uint64_t pathLength = 0; ///< moves
    std::uint64_t actions = 0;    ///< moves, a rotation counting one
    std::uint64_t makespan = 0;   ///< steps of the condensed solution
    /// Sum over robots of the step after which it stays at its goal (0 where it never moves); a robot that
    /// does not end there counts the whole makespan.
    std::uint64_t sumOfCosts = 0;
    double completed = 0; ///< share of robots that end at their goals, 0 … 1 (1 without robots)
};

/// Condenses the solution under `rule` and measures it. O(robots + vertices + moves).
/// \pre every move of the solution is legal
[[nodiscard]] SolutionMetrics measure(const Instance &instance, const Solution &solution, MotionRule rule);

} // namespace mrpp
