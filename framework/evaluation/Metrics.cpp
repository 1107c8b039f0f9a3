#include "framework/evaluation/Metrics.h"

#include "framework/evaluation/Condense.h"

#include <algorithm>
#include <vector>

namespace mrpp
{

namespace
{

using enum Metric::Better;

constexpr Metric kMetrics[] = {
    {"time", "Time", "s", lower, "Wall time of the planner's solve() alone."},
    {"setup_time", "Set-up time", "s", lower, "Wall time of the planner's preprocessing for the instance."},
    {"optimization_time", "Optimization time", "s", lower, "Wall time of all optimizers together."},
    {"memory", "Memory", "MB", lower, "Largest resident memory of the run (1 MB is 10^6 bytes)."},
    {"path_length", "Path length", "moves", lower,
     "Number of moves; one move takes one robot along one edge."},
    {"actions", "Actions", "actions", lower, "Number of moves, a rotation counting one."},
    {"makespan", "Makespan", "steps", lower,
     "Number of steps after condensing: moves that can happen at once do."},
    {"optimized_path_length", "Path length, optimized", "moves", lower,
     "Number of moves after the optimizers."},
    {"optimized_actions", "Actions, optimized", "actions", lower,
     "Number of moves after the optimizers, a rotation counting one."},
    {"optimized_makespan", "Makespan, optimized", "steps", lower,
     "Number of steps after the optimizers and condensing."},
    {"sum_of_costs", "Sum of costs", "steps", lower,
     "Sum over robots of the step after which the robot stays at its goal."},
    {"optimized_sum_of_costs", "Sum of costs, optimized", "steps", lower,
     "Sum of costs after the optimizers."},
    {"path_length_lower_bound", "Path length, lower bound", "moves", lower,
     "Sum over robots of the distance from start to goal; no solution has fewer moves."},
    {"makespan_lower_bound", "Makespan, lower bound", "steps", lower,
     "Largest distance from a robot's start to its goal; no solution has fewer steps."},
    {"completed", "Robots at their goals", "share", higher,
     "Share of the robots that end at their goals, 0 to 1."},
    {"cpu_time", "Processor time", "s", lower,
     "Processor time of solve() and of what it started, all cores together."},
    {"sum_of_costs_lower_bound", "Sum of costs, lower bound", "steps", lower,
     "Sum over robots of the distance from start to goal; no solution has a smaller sum of costs."},
    {"bound_time", "Time for bounds", "s", lower,
     "Wall time in which the instance's lower bounds were found."},
};

} // namespace

std::span<const Metric> metrics()
{
    return kMetrics;
}

const Metric *findMetric(std::string_view name)
{
    const auto *const found = std::find_if(std::begin(kMetrics), std::end(kMetrics),
                                           [name](const Metric &metric) { return metric.name == name; });
    return found == std::end(kMetrics) ? nullptr : found;
}

SolutionMetrics measure(const Instance &instance, const Solution &solution, MotionRule rule)
{
    SolutionMetrics result;
    result.pathLength = solution.pathLength();
    result.actions = solution.actionCount();

    const std::vector<std::uint32_t> steps = moveSteps(instance, solution, rule);
    const std::span<const Move> moves = solution.moves();
    std::vector<std::uint32_t> cost(instance.robotCount(), 0); // the step after the robot's last move
    std::vector<Vertex> position = instance.starts;
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
        cost[moves[i].robot] = steps[i] + 1;
        position[moves[i].robot] = moves[i].to;
    }
    if (!cost.empty())
        result.makespan = *std::max_element(cost.begin(), cost.end());

    std::size_t atGoal = 0;
    for (Robot robot = 0; robot < instance.robotCount(); ++robot)
    {
        const bool arrived = position[robot] == instance.goals[robot];
        atGoal += arrived ? 1 : 0;
        result.sumOfCosts += arrived ? cost[robot] : result.makespan;
    }
    result.completed = instance.robotCount() == 0
                           ? 1
                           : static_cast<double>(atGoal) / static_cast<double>(instance.robotCount());
    return result;
}

} // namespace mrpp
