/// \file
/// Push and Swap and redundancy removal on grids. `BFS` is time ÷ one breadth-first search of the same graph,
/// which compares across machines; `ratio` is moves ÷ the sum of the shortest distances.

#include "algorithms/PushAndSwap.h"
#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/analysis/LowerBounds.h"
#include "tests/benchmarks/BfsUnit.h"
#include "tests/support/RandomCases.h"

#include <benchmark/benchmark.h>

namespace mrpp
{
namespace
{

/// Arguments: side of the grid, robots per 1000 vertices.
void pushAndSwap(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto graph = test::gridGraph(side, side);
    const std::size_t robots = side * side * static_cast<std::size_t>(state.range(1)) / 1000;
    const auto instance = std::make_shared<Instance>(randomInstance(graph, robots, 1));
    PushAndSwap planner;
    planner.setInstance(instance);
    planner.setup();
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
    {
        if (planner.solve({}) != PlannerStatus::solved)
            state.SkipWithError("not solved");
    }
    unit.report(state);
    state.counters["robots"] = static_cast<double>(robots);
    state.counters["ratio"] = static_cast<double>(planner.solution().pathLength()) /
                              static_cast<double>(lowerBounds(*instance)->pathLength);
}
BENCHMARK(pushAndSwap)
    ->Args({100, 10})
    ->Args({100, 100})
    ->Args({100, 500})
    ->Args({100, 900})
    ->Args({400, 1})
    ->Args({400, 10})
    ->Unit(benchmark::kMillisecond);

/// Argument: number of moves.
void redundancyRemoval(benchmark::State &state)
{
    const auto solved =
        test::randomWalks(test::gridGraph(300, 300), 45'000, static_cast<std::size_t>(state.range(0)), 1);
    for (auto _ : state)
    {
        state.PauseTiming();
        Solution copy = solved.solution;
        state.ResumeTiming();
        benchmark::DoNotOptimize(RedundancyRemoval().improve(solved.instance, std::move(copy), {}));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0)); // moves
}
BENCHMARK(redundancyRemoval)->Arg(100'000)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mrpp
