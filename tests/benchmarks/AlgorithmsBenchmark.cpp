/// \file
/// Push and Swap, Push and Rotate, Push and Spin, the solvability oracle and redundancy removal on grids,
/// BIBOX and BIBOX-theta on BIBOX's generator's graphs. `BFS` is time ÷ one breadth-first search of the same
/// graph, which compares across machines; `ratio` is moves ÷ the sum of the shortest distances.

#include "algorithms/Bibox.h"
#include "algorithms/BiboxTheta.h"
#include "algorithms/Mapp.h"
#include "algorithms/PushAndRotate.h"
#include "algorithms/PushAndSpin.h"
#include "algorithms/PushAndSwap.h"
#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/analysis/EarDecomposition.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/analysis/Solvability.h"
#include "framework/evaluation/Metrics.h"
#include "problems/generators/Biconnected.h"
#include "tests/benchmarks/BfsUnit.h"
#include "tests/support/RandomCases.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace mrpp
{
namespace
{

/// Arguments: side of the grid, robots per 1000 vertices.
template <class Solver>
void planning(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto graph = test::gridGraph(side, side);
    const std::size_t robots = side * side * static_cast<std::size_t>(state.range(1)) / 1000;
    const auto instance = std::make_shared<Instance>(randomInstance(graph, robots, 1));
    Solver planner;
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
    state.counters["moves"] = static_cast<double>(planner.solution().pathLength());
    constexpr std::size_t kManySearches = 20'000; // for the bound
    if (robots <= kManySearches && side < 512)
        state.counters["ratio"] = static_cast<double>(planner.solution().pathLength()) /
                                  static_cast<double>(lowerBounds(*instance)->pathLength);
}
BENCHMARK_TEMPLATE(planning, PushAndSwap)
    ->Args({100, 10})
    ->Args({100, 100})
    ->Args({100, 500})
    ->Args({100, 900})
    ->Args({400, 1})
    ->Args({400, 10})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(planning, PushAndRotate)
    ->Args({10, 980})
    ->Args({100, 10})
    ->Args({100, 500})
    ->Args({100, 900})
    ->Args({400, 10})
    ->ArgsProduct({{32, 64, 128, 256, 512}, {20, 200}})
    ->Args({1024, 20})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(planning, PushAndSpin)
    ->Args({10, 980})
    ->Args({100, 500})
    ->Args({100, 900})
    ->ArgsProduct({{32, 64, 128, 256, 512}, {20, 200}})
    ->Args({1024, 20})
    ->Unit(benchmark::kMillisecond);

/// The oracle. Arguments: side of the grid, robots per 1000 vertices.
void oracle(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto graph = test::gridGraph(side, side);
    const Instance instance =
        randomInstance(graph, side * side * static_cast<std::size_t>(state.range(1)) / 1000, 1);
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(solvability(instance, MotionRule::pebble).solvable);
    unit.report(state);
}
BENCHMARK(oracle)->ArgsProduct({{100, 300, 1000}, {20, 900}})->Unit(benchmark::kMillisecond);

/// A thousand restarts on a small full grid, on one thread. Argument: the grid's side.
void restarting(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    PushAndRotate planner;
    planner.parameters().set("restarts", "1000");
    planner.parameters().set("threads", "1");
    planner.setInstance(
        std::make_shared<Instance>(randomInstance(test::gridGraph(side, side), side * side - 2, 1)));
    planner.setup();
    for (auto _ : state)
    {
        if (planner.solve({}) != PlannerStatus::solved)
            state.SkipWithError("not solved");
    }
    state.counters["moves"] = static_cast<double>(planner.solution().pathLength());
}
BENCHMARK(restarting)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

/// Arguments: side of the grid, robots per 1000 vertices. `home` is the share of robots at their goals.
void mappOnGrid(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto graph = test::gridGraph(side, side);
    const std::size_t robots = side * side * static_cast<std::size_t>(state.range(1)) / 1000;
    const auto instance = std::make_shared<Instance>(randomInstance(graph, robots, 1));
    Mapp planner;
    planner.setInstance(instance);
    planner.setup();
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(planner.solve({}));
    unit.report(state);
    const SolutionMetrics metrics = measure(*instance, planner.solution(), MotionRule::following);
    state.counters["robots"] = static_cast<double>(robots);
    state.counters["home"] = metrics.completed;
    state.counters["ratio"] =
        static_cast<double>(metrics.pathLength) / static_cast<double>(lowerBounds(*instance)->pathLength);
}
BENCHMARK(mappOnGrid)
    ->Args({100, 10})
    ->Args({100, 100})
    ->Args({400, 1})
    ->Args({400, 10})
    ->Unit(benchmark::kMillisecond);

std::shared_ptr<const Graph> biconnectedGraph(std::int64_t size)
{
    Biconnected generator;
    for (const char *name : {"initial_cycle", "handles", "max_handle_length"})
        generator.parameters().set(name, std::to_string(size));
    return generator.makeGraph(1);
}

/// Arguments: first cycle, handles and longest handle of the graph; free vertices per 1000, at least two.
void bibox(benchmark::State &state)
{
    const auto graph = biconnectedGraph(state.range(0));
    const std::size_t free = graph->vertexCount() * static_cast<std::size_t>(state.range(1)) / 1000;
    const std::size_t robots = graph->vertexCount() - std::max<std::size_t>(2, free);
    Bibox planner;
    planner.setInstance(std::make_shared<Instance>(randomInstance(graph, robots, 1)));
    planner.setup();
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
    {
        if (planner.solve({}) != PlannerStatus::solved)
            state.SkipWithError("not solved");
    }
    unit.report(state);
    state.counters["robots"] = static_cast<double>(robots);
    state.counters["moves"] = static_cast<double>(planner.solution().pathLength());
}
BENCHMARK(bibox)
    ->Args({10, 0})
    ->Args({20, 0})
    ->Args({50, 0})
    ->Args({20, 100})
    ->Args({20, 500})
    ->Args({100, 20})
    ->Unit(benchmark::kMillisecond);

/// One free vertex. Argument: first cycle, handles and longest handle of the graph.
void biboxTheta(benchmark::State &state)
{
    const auto graph = biconnectedGraph(state.range(0));
    BiboxTheta planner;
    planner.setInstance(std::make_shared<Instance>(randomInstance(graph, graph->vertexCount() - 1, 1)));
    planner.setup();
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
    {
        if (planner.solve({}) != PlannerStatus::solved)
            state.SkipWithError("not solved");
    }
    unit.report(state);
    state.counters["robots"] = static_cast<double>(graph->vertexCount() - 1);
    state.counters["moves"] = static_cast<double>(planner.solution().pathLength());
}
BENCHMARK(biboxTheta)->Arg(5)->Arg(10)->Arg(20)->Arg(50)->Unit(benchmark::kMillisecond);

/// Argument: side of the grid.
void earDecomposition(benchmark::State &state)
{
    const auto side = static_cast<std::size_t>(state.range(0));
    const auto graph = test::gridGraph(side, side);
    const test::BfsUnit unit(*graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(EarDecomposition(*graph, shortCycle(*graph)).handleCount());
    unit.report(state);
}
BENCHMARK(earDecomposition)->Arg(100)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);

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
