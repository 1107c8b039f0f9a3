/// \file
/// A store of many runs: what a campaign that goes on and a report ask of it. MRPP_RUNS says how many;
/// 100 000 by default, for which the limits (CPU seconds) are scaled.

#include "framework/Benchmark.h"
#include "framework/plan/Configuration.h"
#include "framework/run/RunIdentity.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultStore.h"
#include "framework/store/Sqlite.h"
#include "tests/campaign/Fixtures.h"
#include "tests/support/CpuClock.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlack = 20;
#else
constexpr double kSlack = 2; // a busy machine's caches
#endif

std::int64_t runs()
{
    constexpr std::int64_t kDefault = 100'000;
    const char *asked = std::getenv("MRPP_RUNS");
    return asked == nullptr ? kDefault : std::atoll(asked);
}

/// A run with about as much in its row as those of a planner that solves most instances.
RunRecord finished(const BenchmarkPlan &plan, const RunSpec &spec)
{
    RunRecord record;
    fillIdentity(record, plan, spec);
    for (auto *count : {&record.vertices, &record.edges, &record.robots, &record.free,
                        &record.pathLengthLowerBound, &record.makespanLowerBound, &record.timed})
        *count = spec.repetition % 89;
    for (auto *measured : {&record.occupancy, &record.completed, &record.time, &record.setupTime,
                           &record.memory, &record.cpuTime, &record.load})
        *measured = 0.001 * static_cast<double>(spec.repetition % 97);
    record.instanceFingerprint = spec.planKey;
    record.solvable = "yes";
    record.limitMeans = "time kill, cpu /proc, memory rlimit";
    record.status = spec.repetition % 10 == 0 ? PlannerStatus::timeout : PlannerStatus::solved;
    if (!record.solved())
        return record;
    for (auto *cost : {&record.pathLength, &record.actions, &record.makespan, &record.sumOfCosts,
                       &record.optimizedPathLength, &record.optimizedActions, &record.optimizedMakespan,
                       &record.optimizedSumOfCosts})
        *cost = spec.repetition % 31;
    record.optimizationTime = 0.5;
    record.solutionFingerprint = spec.runKey;
    return record;
}

void fill(const BenchmarkPlan &plan, const std::filesystem::path &folder)
{
    constexpr std::size_t kBatch = 5000;
    ResultStore store(folder, ResultStore::Access::write);
    store.describe(plan, Provenance::here());
    std::vector<FinishedRun> batch;
    const std::vector<RunSpec> specs = expand(plan);
    for (const RunSpec &spec : specs)
    {
        batch.emplace_back().record = finished(plan, spec);
        if (batch.size() == kBatch || &spec == &specs.back())
        {
            store.add(batch);
            batch.clear();
        }
    }
}

/// Of one step, which must not take longer than so many CPU seconds for a million runs.
template <class Step>
void expectWithin(const char *what, double most, Step &&step)
{
    const double start = test::cpuSeconds();
    step();
    const double spent = test::cpuSeconds() - start;
    std::printf("%s: %.2f s of CPU time\n", what, spent);
    EXPECT_LT(spent, kSlack * most * static_cast<double>(runs()) / 1e6) << what;
}

TEST(Scale, ResumesAndReportsFromManyRuns)
{
    BenchmarkPlan plan =
        fixtures::plan({"walker", "half", "quitter", "liar"}, std::max<std::int64_t>(1, runs() / 12));
    const Catalog catalog = fixtures::catalog();
    resolve(plan, catalog);
    const fixtures::TemporaryFolder folder;
    const double start = test::cpuSeconds();
    fill(plan, folder.path());
    std::printf("%lld runs: filled in %.1f s, %.0f MB\n", static_cast<long long>(runs()),
                test::cpuSeconds() - start,
                static_cast<double>(std::filesystem::file_size(folder.path() / "results.sqlite")) / 1e6);

    expectWithin("resume decides what is left", 5,
                 [&]
                 {
                     const auto summary = Benchmark(plan, catalog).benchmark({.folder = folder.path()}, {});
                     EXPECT_EQ(summary.finished, 0U);
                     EXPECT_EQ(summary.kept, summary.planned);
                 });
    expectWithin("a report's table", 5,
                 [&]
                 {
                     const ResultStore store(folder.path(), ResultStore::Access::read);
                     const ResultTable table(plan, store.records(), {});
                     EXPECT_EQ(table.records().size(), table.plannedRuns());
                 });
    expectWithin("what an explorer asks", 5,
                 [&]
                 {
                     sqlite::Connection database(folder.path() / "results.sqlite",
                                                 sqlite::Connection::Mode::read);
                     sqlite::Statement best(database, "SELECT * FROM bestPlannerConfigsPerExperiment");
                     int rows = 0;
                     while (best.step())
                         ++rows;
                     EXPECT_EQ(rows, 12);
                 });
}

} // namespace
} // namespace mrpp
