#include "framework/plan/RunKey.h"

#include "framework/Benchmark.h"
#include "framework/plan/Configuration.h"
#include "framework/store/ResultStore.h"
#include "framework/store/WhyRun.h"
#include "framework/system/File.h"
#include "tests/campaign/Fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mrpp
{
namespace
{

using testing::Each;
using testing::HasSubstr;

/// The walker as a later version of the program has it.
class LaterWalker final : public Planner
{
public:
    LaterWalker(std::int64_t detours, int version)
        : Planner({.citation = "", .completeFor = "", .version = version}), detours_(detours)
    {
        declareParam("detours", detours_, "0:100", "");
        declareParam("pause", pause_, "0:100", "");
    }
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::gave_up; }

private:
    std::int64_t detours_;
    double pause_ = 0;
};

Catalog laterCatalog(std::int64_t detours, int version)
{
    Catalog catalog;
    catalog.planners.add("walker", "",
                         [=]() -> std::unique_ptr<Planner>
                         { return std::make_unique<LaterWalker>(detours, version); });
    return catalog;
}

RunSpec firstRun(BenchmarkPlan plan, const Catalog &catalog)
{
    resolve(plan, catalog);
    return expand(plan).front();
}

TEST(RunKey, ChangesWithADefaultAndWithAVersion)
{
    const BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    const RunSpec now = firstRun(plan, laterCatalog(0, 1));
    const RunSpec otherDefault = firstRun(plan, laterCatalog(2, 1));
    const RunSpec otherVersion = firstRun(plan, laterCatalog(0, 2));
    EXPECT_EQ((std::set{now.runKey, otherDefault.runKey, otherVersion.runKey}).size(), 3U);
    EXPECT_EQ((std::set{now.planKey, otherDefault.planKey, otherVersion.planKey}).size(), 1U);
}

TEST(RunKey, DoesNotChangeWhereADefaultIsWrittenOut)
{
    const BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    BenchmarkPlan explicitly = plan;
    explicitly.planners[0].settings = {{"pause", "0.0"}, {"detours", "0"}};
    const Catalog catalog = laterCatalog(0, 1);
    EXPECT_EQ(firstRun(plan, catalog).runKey, firstRun(explicitly, catalog).runKey);
    EXPECT_NE(firstRun(plan, catalog).planKey, firstRun(explicitly, catalog).planKey);
}

TEST(RunKey, ChangesWithEachLimitAndWithTimingRepeats)
{
    const BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    std::vector<BenchmarkPlan> others(5, plan);
    others[0].limits.time = 11;
    others[1].limits.memory = 11;
    others[2].limits.cpu = 11;
    others[3].execution.timingRepeats = 3;
    others[4].motion = MotionRule::pebble;
    std::set<std::string> keys = {expand(plan).front().runKey};
    for (const BenchmarkPlan &other : others)
        keys.insert(expand(other).front().runKey);
    EXPECT_EQ(keys.size(), 6U);
    BenchmarkPlan same = plan;
    same.execution.jobs = 7;
    same.execution.isolation = "none";
    same.keep.instances = true;
    same.campaign = "renamed";
    EXPECT_EQ(expand(same).front().runKey, expand(plan).front().runKey);
}

TEST(RunKey, SaysWhatDiffersInWords)
{
    const KeyParts before = {{"time limit", "60"}, {"input files", "aa"}, {"parameter old", "1"}};
    const KeyParts now = {{"time limit", "30"}, {"input files", "bb"}, {"parameter new", "2"}};
    EXPECT_EQ(differences(before, now), "time limit was '60', is '30'; input files changed; parameter new is "
                                        "new: 2; parameter old is gone: '1'");
    EXPECT_EQ(differences(now, now), "");
    EXPECT_EQ(keyParts(toText(now)), now);
}

class WhyRunTest : public testing::Test
{
protected:
    void run(const BenchmarkPlan &plan) { (void)Benchmark(plan, catalog_).benchmark({.folder = dir()}, {}); }

    [[nodiscard]] std::vector<std::string> reasons(BenchmarkPlan plan, const Catalog &catalog) const
    {
        resolve(plan, catalog);
        const ResultStore store(dir(), ResultStore::Access::read);
        std::vector<std::string> texts;
        for (const MissingRun &run : missingRuns(plan, &store))
            texts.push_back(run.why);
        return texts;
    }
    [[nodiscard]] std::vector<std::string> reasons(const BenchmarkPlan &plan) const
    {
        return reasons(plan, catalog_);
    }
    [[nodiscard]] const std::filesystem::path &dir() const { return folder_.path(); }

    const Catalog catalog_ = fixtures::catalog();

private:
    fixtures::TemporaryFolder folder_;
};

TEST_F(WhyRunTest, NamesThePartThatChanged)
{
    BenchmarkPlan plan = fixtures::plan({"walker", "half"}, 2);
    const auto file = dir() / "input.txt";
    writeFile(file, "one");
    plan.points.push_back(fixtures::lanes(1, file));
    run(plan);
    EXPECT_TRUE(reasons(plan).empty());

    BenchmarkPlan edited = plan;
    edited.limits.time = 5;
    EXPECT_EQ(reasons(edited).size(), 16U);
    EXPECT_THAT(reasons(edited), Each("changed: time limit was '10', is '5'"));

    edited = plan;
    edited.planners[0].settings = {{"detours", "3"}};
    EXPECT_EQ(reasons(edited).size(), 8U);
    EXPECT_THAT(reasons(edited), Each("changed: parameter detours was '0', is '3'"));

    edited = plan;
    edited.optimizers = {{"trimmer", "trimmer", {}}};
    EXPECT_THAT(reasons(edited), Each("changed: optimizers was '', is 'trimmer (version)=1'"));

    edited = plan;
    edited.seed = 7;
    EXPECT_THAT(reasons(edited), Each("changed: campaign's seed was '2016', is '7'"));

    edited = plan;
    edited.repetitions = 3;
    EXPECT_EQ(reasons(edited).size(), 8U);
    EXPECT_THAT(reasons(edited), Each("new: no run of this planner on this case is in the folder"));

    writeFile(file, "two");
    EXPECT_EQ(reasons(plan).size(), 4U);
    EXPECT_THAT(reasons(plan), Each("changed: input files changed"));
}

TEST_F(WhyRunTest, NamesWhatTheProgramChanged)
{
    const BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    run(plan);
    EXPECT_THAT(reasons(plan, laterCatalog(2, 1)), Each("changed: parameter detours was '0', is '2'"));
    EXPECT_THAT(reasons(plan, laterCatalog(0, 2)), Each("changed: algorithm version was '1', is '2'"));
    // What the older program found can still be shown.
    BenchmarkPlan later = plan;
    resolve(later, laterCatalog(2, 2));
    EXPECT_EQ(fixtures::table(later, dir()).records().size(), 3U);
}

TEST_F(WhyRunTest, AnOldAnswerMayStandForTwoQuestions)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    run(plan);
    plan.planners.push_back({"walker", "still", {{"detours", "0"}}});
    resolve(plan, laterCatalog(2, 1));
    const ResultTable table = fixtures::table(plan, dir());
    ASSERT_EQ(table.records().size(), 6U);
    for (std::size_t i = 0; i < 6; i += 2)
    {
        EXPECT_EQ(table.records()[i].planner, "walker");
        EXPECT_EQ(table.records()[i + 1].planner, "still");
        EXPECT_EQ(table.records()[i].runKey, table.records()[i + 1].runKey);
    }
}

TEST_F(WhyRunTest, CountsWhatWasBegunAndNeverFinished)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points.resize(1);
    resolve(plan, catalog_);
    {
        ResultStore store(dir(), ResultStore::Access::write);
        (void)store.begin(expand(plan).front().runKey);
        EXPECT_THAT(reasons(plan).front(), HasSubstr("; begun once before, never finished"));
        (void)store.begin(expand(plan).front().runKey);
    }
    EXPECT_EQ(reasons(plan), std::vector<std::string>{"new: no run of this planner on this case is in the "
                                                      "folder; begun 2 times before, never finished"});
    EXPECT_EQ(missingRuns(plan, nullptr).front().why, "new: the folder holds no campaign yet");
}

} // namespace
} // namespace mrpp
