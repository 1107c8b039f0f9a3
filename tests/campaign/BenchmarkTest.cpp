#include "framework/Benchmark.h"

#include "framework/store/Provenance.h"
#include "framework/store/ResultStore.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "tests/campaign/Fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace mrpp
{
namespace
{

using fixtures::rows;
using testing::ElementsAre;
using testing::HasSubstr;

class BenchmarkTest : public testing::Test
{
protected:
    [[nodiscard]] std::filesystem::path dir(const std::string &name = "campaign") const
    {
        return folder_.path() / name;
    }

    Benchmark::Summary run(const BenchmarkPlan &plan, Benchmark::Request request = {})
    {
        if (request.folder.empty())
            request.folder = dir();
        return Benchmark(plan, catalog_).benchmark(request, {});
    }

    /// Runs until `count` runs are finished, then stops; more may be finished by then.
    Benchmark::Summary runSome(const BenchmarkPlan &plan, std::size_t count)
    {
        std::stop_source stop;
        Benchmark::Request request;
        request.folder = dir();
        request.progress = [&](const RunRecord &, std::size_t done, std::size_t, double)
        {
            if (done >= count)
                stop.request_stop();
        };
        return Benchmark(plan, catalog_).benchmark(request, stop.get_token());
    }

    static BenchmarkPlan mixedPlan()
    {
        BenchmarkPlan plan = fixtures::plan({"walker", "liar", "half", "thrower", "quitter", "eater"}, 3);
        plan.optimizers = {{"trimmer", "trimmer", {}}};
        plan.planners.push_back({"walker", "stroller", {{"detours", "4"}}});
        return plan;
    }

    const Catalog catalog_ = fixtures::catalog();

private:
    fixtures::TemporaryFolder folder_;
};

TEST_F(BenchmarkTest, RunsEveryPlannerOnEveryInstance)
{
    const BenchmarkPlan plan = mixedPlan();
    const auto summary = run(plan);
    EXPECT_EQ(summary.planned, 63U);
    EXPECT_EQ(summary.kept, 0U);
    EXPECT_EQ(summary.finished, 63U);
    EXPECT_FALSE(summary.interrupted);
    using enum PlannerStatus;
    // half solves the case with one robot, but says `partial`
    EXPECT_EQ(summary.statuses,
              (std::map<PlannerStatus, std::size_t>{
                  {partial, 9}, {solved, 18}, {crash, 9}, {gave_up, 9}, {memory_limit, 9}, {invalid, 9}}));

    const ResultTable table = fixtures::table(plan, dir());
    ASSERT_EQ(table.records().size(), 63U);
    EXPECT_EQ(table.plannedRuns(), 63U);
    const RunRecord &stroller = table.records()[6];
    EXPECT_EQ(stroller.planner, "stroller");
    EXPECT_EQ(stroller.caseId, "lanes/lanes/robots=1/0");
    EXPECT_EQ(stroller.sweepVariable, "robots");
    EXPECT_EQ(stroller.sweepValue, 1);
    EXPECT_EQ(stroller.vertices, 24);
    EXPECT_EQ(stroller.pathLength, *stroller.pathLengthLowerBound + 8);
    EXPECT_EQ(stroller.optimizedPathLength, stroller.pathLengthLowerBound);
    EXPECT_EQ(stroller.attempt, 1);
    EXPECT_TRUE(stroller.memory.has_value());
}

TEST_F(BenchmarkTest, GivesEveryPlannerTheSameInstance)
{
    const BenchmarkPlan plan = mixedPlan();
    (void)run(plan);
    const ResultTable table = fixtures::table(plan, dir());
    std::map<std::string, std::set<std::string>> instances;
    for (const RunRecord &record : table.records())
    {
        instances[record.caseId].insert(record.instanceFingerprint);
        EXPECT_EQ(table.instance(record)->fingerprint(), record.instanceFingerprint);
    }
    EXPECT_EQ(instances.size(), 9U);
    for (const auto &[caseId, fingerprints] : instances)
        EXPECT_EQ(fingerprints.size(), 1U) << caseId;
}

TEST_F(BenchmarkTest, CallsItsEventsInOrderAndKeepsTheirColumns)
{
    std::vector<std::string> calls;
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points.resize(1);
    Benchmark benchmark(plan, catalog_);
    benchmark.setPreRunEvent(
        [&](Planner &planner, const RunSpec &spec)
        {
            calls.push_back("pre " + spec.caseId);
            planner.parameters().set("detours", "1");
        });
    benchmark.setPostRunEvent(
        [&](RunRecord &record, const Instance &instance, const Solution &solution)
        {
            calls.push_back("post " + std::string(toString(record.status)));
            record.extra["excess"] =
                static_cast<std::int64_t>(solution.pathLength()) - record.pathLengthLowerBound.value();
            record.extra["first start"] = static_cast<std::int64_t>(instance.starts[0]);
        });
    Benchmark::Request request;
    request.folder = dir();
    request.onFinished = [&](const RunSpec &spec, const RunResult &result)
    {
        calls.push_back("finished " + spec.caseId);
        EXPECT_EQ(result.record.extra.size(), 2U);
        EXPECT_EQ(result.instance->fingerprint(), result.record.instanceFingerprint);
        EXPECT_TRUE(ResultStore(dir(), ResultStore::Access::read).finishedKeys().empty());
    };
    request.progress = [&](const RunRecord &record, std::size_t done, std::size_t total, double left)
    {
        calls.push_back("progress " + std::to_string(done) + "/" + std::to_string(total));
        EXPECT_EQ(ResultStore(dir(), ResultStore::Access::read).finishedKeys(),
                  std::set<std::string>{record.runKey});
        EXPECT_EQ(left, 0);
    };
    (void)benchmark.benchmark(request, {});
    EXPECT_THAT(calls, ElementsAre("pre lanes/lanes/robots=1/0", "post solved",
                                   "finished lanes/lanes/robots=1/0", "progress 1/1"));
    const ResultTable table = fixtures::table(plan, dir());
    ASSERT_EQ(table.records().size(), 1U);
    EXPECT_EQ(numericValue(table.records()[0], "excess"), 2);
    EXPECT_TRUE(numericValue(table.records()[0], "first start").has_value());
}

TEST_F(BenchmarkTest, EndsWithWhatAnEventThrowsAndKeepsWhatWasFinished)
{
    int calls = 0;
    Benchmark benchmark(fixtures::plan({"walker"}, 2), catalog_);
    benchmark.setPostRunEvent(
        [&](RunRecord &, const Instance &, const Solution &)
        {
            if (++calls == 3)
                throw std::runtime_error("event failed");
        });
    EXPECT_THROW((void)benchmark.benchmark({.folder = dir()}, {}), std::runtime_error);
    EXPECT_EQ(ResultStore(dir(), ResultStore::Access::read).finishedKeys().size(), 2U);
}

TEST_F(BenchmarkTest, GoesOnWhereItStopped)
{
    BenchmarkPlan plan = mixedPlan();
    plan.planners[0].settings = {{"pause", "0.1"}}; // 9 of 63 runs
    (void)run(plan, {.folder = dir("whole")});

    const auto first = runSome(plan, 10);
    EXPECT_TRUE(first.interrupted);
    EXPECT_GE(first.finished, 10U);
    EXPECT_EQ(fixtures::table(plan, dir()).records().size(), first.finished);
    EXPECT_EQ(fixtures::table(plan, dir()).plannedRuns(), 63U);
    const auto second = runSome(plan, first.finished + 1);
    EXPECT_EQ(second.kept, first.finished);
    EXPECT_GE(second.finished, 1U);
    const auto last = run(plan);
    EXPECT_EQ(last.kept, second.kept + second.finished);
    EXPECT_EQ(last.finished, 63U - last.kept);
    EXPECT_FALSE(last.interrupted);
    EXPECT_EQ(last.statuses.at(PlannerStatus::solved), 18U); // those of before included
    EXPECT_EQ(run(plan).finished, 0U);

    EXPECT_EQ(rows(plan, dir()), rows(plan, dir("whole")));
}

TEST_F(BenchmarkTest, GivesTheSameResultsAndSolutionsWithTwoJobs)
{
    const BenchmarkPlan plan = mixedPlan();
    (void)run(plan, {.folder = dir("one"), .jobs = 1});
    (void)run(plan, {.folder = dir("two"), .jobs = 2});
    EXPECT_EQ(rows(plan, dir("one")), rows(plan, dir("two")));

    const ResultTable one = fixtures::table(plan, dir("one"));
    const ResultTable two = fixtures::table(plan, dir("two"));
    std::size_t solutions = 0;
    for (std::size_t i = 0; i < one.records().size(); ++i)
    {
        const auto solution = one.solution(one.records()[i]);
        EXPECT_EQ(solution, two.solution(two.records()[i]));
        solutions += solution ? 1 : 0;
        EXPECT_FALSE(two.records()[i].memory.has_value()); // two runs share the process
    }
    EXPECT_EQ(solutions, 27U);
}

TEST_F(BenchmarkTest, GivesTheSameResultsWhenThePlanIsWrittenInAnotherOrder)
{
    const BenchmarkPlan plan = mixedPlan();
    BenchmarkPlan reversed = plan;
    std::reverse(reversed.points.begin(), reversed.points.end());
    std::reverse(reversed.planners.begin(), reversed.planners.end());
    (void)run(plan, {.folder = dir("plan")});
    (void)run(reversed, {.folder = dir("reversed")});
    EXPECT_EQ(rows(plan, dir("plan")), rows(plan, dir("reversed")));
}

TEST_F(BenchmarkTest, RunsOnlyWhatChangedInAnEditedPlan)
{
    BenchmarkPlan plan = mixedPlan();
    (void)run(plan);
    plan.planners[0].name = "renamed";
    plan.planners[6].settings = {{"detours", "5"}};
    plan.planners.pop_back();
    plan.planners.push_back({"walker", "stroller", {{"detours", "5"}}});
    plan.points.erase(plan.points.begin());
    plan.repetitions = 4;
    const auto summary = run(plan);
    EXPECT_EQ(summary.planned, 56U);
    EXPECT_EQ(summary.kept, 2U * 3 * 6);
    EXPECT_EQ(summary.finished, 2U * 7 + 2 * 3);

    const ResultTable table = fixtures::table(plan, dir());
    EXPECT_EQ(table.records().size(), 56U); // the rest of the old plan is kept, but not shown
    EXPECT_EQ(table.records()[0].planner, "renamed");
    EXPECT_EQ(table.records()[0].caseId, "lanes/lanes/robots=2/0");
    EXPECT_EQ(ResultStore(dir(), ResultStore::Access::read).records().size(), 63U + 20U);
}

TEST_F(BenchmarkTest, SplitsIntoShardsOfWholeCases)
{
    const BenchmarkPlan plan = fixtures::plan({"walker", "liar"}, 20);
    std::vector<std::string> all;
    std::set<std::string> cases;
    for (std::int64_t shard = 1; shard <= 3; ++shard)
    {
        const auto folder = dir(std::to_string(shard));
        const auto summary = run(plan, {.folder = folder, .shard = shard, .shards = 3});
        EXPECT_GT(summary.planned, 0U);
        EXPECT_FALSE(summary.interrupted);
        const ResultTable table = fixtures::table(plan, folder);
        EXPECT_EQ(table.records().size(), summary.planned);
        std::set<std::string> own;
        for (const RunRecord &record : table.records())
        {
            own.insert(record.caseId);
            all.push_back(fixtures::timeless(record));
        }
        EXPECT_EQ(own.size() * 2, table.records().size());
        for (const std::string &id : own)
            EXPECT_TRUE(cases.insert(id).second) << id;
    }
    (void)run(plan);
    auto whole = rows(plan, dir());
    std::sort(all.begin(), all.end());
    std::sort(whole.begin(), whole.end());
    EXPECT_EQ(all, whole);
}

TEST_F(BenchmarkTest, InterleavesPlannersAndFinishesCaseByCase)
{
    std::vector<std::string> cases;
    std::set<std::string> firstPlanners;
    Benchmark::Request request;
    request.progress = [&](const RunRecord &record, std::size_t, std::size_t, double)
    {
        if (cases.empty() || cases.back() != record.caseId)
        {
            cases.push_back(record.caseId);
            firstPlanners.insert(record.planner);
        }
    };
    (void)run(fixtures::plan({"walker", "liar"}, 10), request);
    EXPECT_EQ(cases.size(), 30U);
    EXPECT_EQ(firstPlanners.size(), 2U);
    EXPECT_FALSE(std::is_sorted(cases.begin(), cases.end()));
}

TEST_F(BenchmarkTest, StopsARunningPlannerAndDoesNotKeepItsRun)
{
    BenchmarkPlan plan = fixtures::plan({"hanger"}, 1);
    plan.limits.time = 60;
    std::stop_source stop;
    Benchmark benchmark(plan, catalog_);
    benchmark.setPreRunEvent([&](Planner &, const RunSpec &) { stop.request_stop(); });
    const auto summary = benchmark.benchmark({.folder = dir(), .jobs = 2}, stop.get_token());
    EXPECT_TRUE(summary.interrupted);
    EXPECT_EQ(summary.finished, 0U);
    EXPECT_TRUE(ResultStore(dir(), ResultStore::Access::read).finishedKeys().empty());

    plan.planners = {{"walker", "walker", {}}};
    EXPECT_EQ(run(plan).finished, 3U);
}

TEST_F(BenchmarkTest, CountsTheAttemptsOfARunThatWasStopped)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points.resize(1);
    std::stop_source stop;
    Benchmark benchmark(plan, catalog_);
    benchmark.setPreRunEvent([&](Planner &, const RunSpec &) { stop.request_stop(); });
    EXPECT_TRUE(benchmark.benchmark({.folder = dir()}, stop.get_token()).interrupted);
    (void)run(plan);
    EXPECT_EQ(fixtures::table(plan, dir()).records().at(0).attempt, 2);
}

TEST_F(BenchmarkTest, WritesThePlanAndWhereTheResultsComeFrom)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.planners[0].settings = {{"pause", "0.3"}};
    const auto provenance = [this]
    {
        const auto file = dir() / "provenance.json";
        return Provenance::fromJson(readFile(file), file);
    };
    (void)runSome(plan, 1);
    EXPECT_EQ(readFile(dir() / "plan.yaml"), "campaign: test\n");
    const Provenance before = provenance();
    EXPECT_EQ(before.campaign, "test");
    EXPECT_EQ(before.seed, 2016);
    EXPECT_EQ(before.planFile, "test.yaml");
    EXPECT_EQ(before.planFolder, std::filesystem::current_path().string());
    EXPECT_EQ(before.started.size(), std::string("2026-01-02T03:04:05Z").size());
    EXPECT_EQ(before.finished, "");

    (void)run(plan);
    const Provenance after = provenance();
    EXPECT_EQ(after.started, before.started);
    EXPECT_GE(after.finished, after.started);
    (void)run(plan);
    EXPECT_EQ(provenance().toJson(), after.toJson());
}

TEST_F(BenchmarkTest, WritesNothingWhereTheInputIsBad)
{
    const auto expectRefused = [this](const BenchmarkPlan &plan, Benchmark::Request request = {})
    {
        request.folder = dir();
        EXPECT_THROW((void)run(plan, request), InputError);
        EXPECT_FALSE(std::filesystem::exists(dir()));
    };
    const fixtures::TemporaryFolder inputs;
    const auto file = inputs.path() / "input.txt";
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points.push_back(fixtures::lanes(1, file));
    expectRefused(plan); // missing
    writeFile(file, "bad input");
    expectRefused(plan);
    writeFile(file, "good input");
    plan.points.push_back(fixtures::lanes(4, file)); // 3 lanes
    expectRefused(plan);
    plan.points.pop_back();
    expectRefused(plan, {.jobs = 0});
    expectRefused(plan, {.shard = 4, .shards = 3});
    expectRefused(plan, {.shard = 0, .shards = 3});
    plan.planners[0].kind = "runner";
    expectRefused(plan);
    plan.planners[0] = {"walker", "walker", {{"speed", "9"}}};
    expectRefused(plan);
    plan.planners[0].settings.clear();
    plan.optimizers = {{"slimmer", "slimmer", {}}};
    expectRefused(plan);
    plan.optimizers.clear();
    EXPECT_EQ(run(plan).finished, 4U);
}

TEST_F(BenchmarkTest, RecordsPointsThatDoNotFitAGraphDrawnByChance)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points.push_back(fixtures::lanes(4)); // 3 lanes
    const auto summary = run(plan);
    EXPECT_EQ(summary.finished, 4U);
    EXPECT_EQ(summary.statuses.at(PlannerStatus::unsupported), 1U);
    const ResultStore store(dir(), ResultStore::Access::read);
    const auto records = store.records();
    const auto none = std::find_if(records.begin(), records.end(),
                                   [](const RunRecord &r) { return r.status == PlannerStatus::unsupported; });
    ASSERT_NE(none, records.end());
    EXPECT_EQ(none->reason, "there is no such instance: 4 robots do not fit 3 lanes");
    EXPECT_EQ(none->time, std::nullopt);
    EXPECT_EQ(none->caseId.substr(0, 5), "lanes");
}

TEST_F(BenchmarkTest, RefusesAFolderInWhichAnotherCampaignRuns)
{
    const ResultStore other(dir(), ResultStore::Access::write);
    try
    {
        (void)run(fixtures::plan({"walker"}, 1));
        FAIL() << "two writers";
    }
    catch (const FileError &error)
    {
        EXPECT_THAT(error.what(), HasSubstr("is running a campaign in this folder"));
    }
    EXPECT_FALSE(std::filesystem::exists(dir() / "plan.yaml"));
}

TEST_F(BenchmarkTest, RunsAgainWhatDependsOnAChangedFile)
{
    const fixtures::TemporaryFolder inputs;
    const auto file = inputs.path() / "input.txt";
    writeFile(file, "one");
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points = {fixtures::lanes(1), fixtures::lanes(1, file)};
    EXPECT_EQ(run(plan).finished, 2U);
    writeFile(file, "two");
    const auto summary = run(plan);
    EXPECT_EQ(summary.kept, 1U);
    EXPECT_EQ(summary.finished, 1U);
}

TEST_F(BenchmarkTest, CanStillBeReportedWhenItsInputFilesAreGone)
{
    const fixtures::TemporaryFolder inputs;
    const auto file = inputs.path() / "input.txt";
    writeFile(file, "one");
    BenchmarkPlan plan = fixtures::plan({"walker", "liar"}, 2);
    plan.points = {fixtures::lanes(1, file), fixtures::lanes(2)};
    (void)run(plan);
    const auto before = rows(plan, dir());
    std::filesystem::remove(file);
    EXPECT_EQ(rows(plan, dir()), before);
    EXPECT_EQ(before.size(), 8U);
}

} // namespace
} // namespace mrpp
