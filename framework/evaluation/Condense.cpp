#include "framework/evaluation/Condense.h"

#include <algorithm>

namespace mrpp
{

namespace
{
std::vector<std::uint32_t> actionNumbers(const Solution &solution)
{
    std::vector<std::uint32_t> steps;
    steps.reserve(solution.pathLength());
    std::uint32_t number = 0;
    solution.forEachAction([&](std::span<const Move> action)
                           { steps.insert(steps.end(), action.size(), number++); });
    return steps;
}
} // namespace

std::vector<std::uint32_t> moveSteps(const Instance &instance, const Solution &solution, MotionRule rule)
{
    if (rule == MotionRule::pebble)
        return actionNumbers(solution);

    const std::uint32_t delay = rule == MotionRule::parallel ? 1 : 0; // between leaving and entering a vertex
    std::vector<std::uint32_t> ready(instance.robotCount(), 0);       // the first step the robot can move in
    std::vector<std::uint32_t> open(instance.graph->vertexCount(),
                                    0); // the first step to enter the vertex in
    std::vector<std::uint32_t> steps;
    steps.reserve(solution.pathLength());
    solution.forEachAction(
        [&](std::span<const Move> action)
        {
            // A vertex of a rotation is open before the robot on it is ready: it had to be entered.
            std::uint32_t step = 0;
            for (const Move &move : action)
                step = std::max({step, ready[move.robot], open[move.to]});
            for (const Move &move : action)
            {
                ready[move.robot] = step + 1;
                open[move.from] = step + delay;
                steps.push_back(step);
            }
        });
    return steps;
}

Schedule condense(const Instance &instance, const Solution &solution, MotionRule rule)
{
    const std::vector<std::uint32_t> steps = moveSteps(instance, solution, rule);
    const std::span<const Move> moves = solution.moves();
    const std::size_t makespan =
        steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end()) + std::size_t{1};

    // Counting sort by step: `ends` first holds where a step begins and, once its moves are placed, its end.
    std::vector<std::size_t> ends(makespan, 0);
    for (const std::uint32_t step : steps)
        ++ends[step];
    std::size_t begin = 0;
    for (std::size_t &end : ends)
        begin += std::exchange(end, begin);
    std::vector<Move> sorted(moves.size());
    for (std::size_t i = 0; i < moves.size(); ++i)
        sorted[ends[steps[i]]++] = moves[i];

    begin = 0;
    for (const std::size_t end : ends)
    {
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
                  sorted.begin() + static_cast<std::ptrdiff_t>(end),
                  [](const Move &x, const Move &y) { return x.robot < y.robot; });
        begin = end;
    }
    return Schedule(std::move(sorted), std::move(ends));
}

} // namespace mrpp
