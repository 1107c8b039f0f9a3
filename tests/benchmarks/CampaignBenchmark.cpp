/// What the engine itself costs: campaigns of planners that do next to nothing, in two workers, each run on
/// the disk before it counts.

#include "framework/Benchmark.h"
#include "framework/worker/WorkerExecutor.h"
#include "tests/campaign/Fixtures.h"
#include "tests/campaign/Hostile.h"

#include <benchmark/benchmark.h>

namespace mrpp
{
namespace
{

void campaignOfTrivialRuns(benchmark::State &state)
{
    const BenchmarkPlan plan = fixtures::namedPlan("trivial");
    std::size_t runs = 0;
    for (auto _ : state)
    {
        const fixtures::TemporaryFolder folder;
        runs += Benchmark(plan, fixtures::hostileCatalog())
                    .benchmark({.folder = folder.path(),
                                .jobs = 2,
                                .worker = {MRPP_CAMPAIGN_VICTIM, "worker", folder.path().string()}},
                               {})
                    .finished;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(runs));
}
BENCHMARK(campaignOfTrivialRuns)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// A run of `pause` milliseconds; the counter is what the engine adds to it.
void oneRunInAWorker(benchmark::State &state)
{
    BenchmarkPlan plan = fixtures::namedPlan("pausing");
    WorkerExecutor executor({MRPP_CAMPAIGN_VICTIM, "worker", "benchmark"}, plan, fixtures::hostileCatalog(),
                            1, false);
    const std::vector<RunSpec> specs = expand(plan);
    const RunSpec &spec = specs.front();
    (void)executor.execute(spec, {}); // starts the worker
    double solving = 0;
    double all = 0;
    for (auto _ : state)
    {
        const auto start = std::chrono::steady_clock::now();
        solving += executor.execute(spec, {}).record.time.value();
        all += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    state.counters["added_ms"] =
        benchmark::Counter((all - solving) * 1e3 / static_cast<double>(state.iterations()));
    state.counters["added_percent"] = benchmark::Counter((all - solving) / solving * 100);
}
BENCHMARK(oneRunInAWorker)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

} // namespace
} // namespace mrpp
