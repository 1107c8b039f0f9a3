/// Condensing, checking and bounding solutions on a grid of 57 600 vertices.

#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Condense.h"
#include "framework/evaluation/Metrics.h"
#include "framework/evaluation/Validator.h"
#include "tests/benchmarks/BfsUnit.h"
#include "tests/support/RandomCases.h"

#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

namespace mrpp::test
{
namespace
{

constexpr std::size_t kSide = 240;

std::shared_ptr<const Graph> map()
{
    return gridGraph(kSide, kSide);
}

std::vector<Vertex> randomVertices(std::size_t count, Seed seed)
{
    std::vector<Vertex> vertices(kSide * kSide);
    std::iota(vertices.begin(), vertices.end(), Vertex{0});
    Random(seed).shuffleFront(std::span(vertices), count);
    vertices.resize(count);
    return vertices;
}

/// Robots go one after another and step aside into whatever is empty: 1000 robots, `moves` moves.
SolvedCase walk(std::size_t moves)
{
    constexpr std::size_t kRobots = 1000;
    SolvedCase test{{map(), randomVertices(kRobots, 1), {}}, {}};
    std::vector<char> taken(kSide * kSide, 0);
    for (const Vertex v : test.instance.starts)
        taken[v] = 1;
    test.instance.goals = test.instance.starts;
    Random random(2);
    test.solution.reserve(moves);
    constexpr std::size_t kBout = 200; // moves of one robot before it is another's turn
    while (test.solution.pathLength() < moves)
    {
        const auto robot = static_cast<Robot>(random.below(kRobots));
        Vertex &at = test.instance.goals[robot];
        for (std::size_t i = 0; i < kBout && test.solution.pathLength() < moves; ++i)
        {
            const auto around = test.instance.graph->neighbors(at);
            const Vertex next = around[random.below(around.size())];
            if (taken[next] != 0)
                continue;
            test.solution.append({robot, at, next});
            taken[at] = 0;
            taken[next] = 1;
            at = next;
        }
    }
    return test;
}

void perMove(benchmark::State &state, const SolvedCase &test)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(test.solution.pathLength()));
}

void condensing(benchmark::State &state, MotionRule rule)
{
    const SolvedCase test = walk(static_cast<std::size_t>(state.range(0)));
    const BfsUnit unit(*test.instance.graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(condense(test.instance, test.solution, rule));
    unit.report(state);
    perMove(state, test);
}
BENCHMARK_CAPTURE(condensing, pebble, MotionRule::pebble)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(condensing, parallel, MotionRule::parallel)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(condensing, following, MotionRule::following)
    ->RangeMultiplier(10)
    ->Range(10'000, 10'000'000)
    ->Unit(benchmark::kMillisecond);

void measuring(benchmark::State &state)
{
    const SolvedCase test = walk(static_cast<std::size_t>(state.range(0)));
    const BfsUnit unit(*test.instance.graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(measure(test.instance, test.solution, MotionRule::following));
    unit.report(state);
    perMove(state, test);
}
BENCHMARK(measuring)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void validatingASolution(benchmark::State &state)
{
    const SolvedCase test = walk(static_cast<std::size_t>(state.range(0)));
    const BfsUnit unit(*test.instance.graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(validate(test.instance, test.solution, MotionRule::pebble));
    unit.report(state);
    perMove(state, test);
}
BENCHMARK(validatingASolution)->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond);

void validatingASchedule(benchmark::State &state)
{
    const SolvedCase test = walk(static_cast<std::size_t>(state.range(0)));
    const Schedule schedule = condense(test.instance, test.solution, MotionRule::following);
    const BfsUnit unit(*test.instance.graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(validate(test.instance, schedule, MotionRule::following));
    unit.report(state);
    perMove(state, test);
}
BENCHMARK(validatingASchedule)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void bounding(benchmark::State &state)
{
    const auto robots = static_cast<std::size_t>(state.range(0));
    const Instance instance{map(), randomVertices(robots, 1), randomVertices(robots, 2)};
    const BfsUnit unit(*instance.graph);
    for (auto _ : state)
        benchmark::DoNotOptimize(lowerBounds(instance));
    unit.report(state);
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(bounding)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mrpp::test
