#include "framework/plan/BenchmarkPlan.h"
#include "framework/plan/Configuration.h"

#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "tests/campaign/Fixtures.h"

#include <gtest/gtest.h>

#include <set>

namespace mrpp
{
namespace
{

std::vector<std::string> keys(const BenchmarkPlan &plan)
{
    std::vector<std::string> list;
    for (const RunSpec &spec : expand(plan))
        list.push_back(spec.runKey);
    return list;
}

TEST(Expand, GoesByPointRepetitionPlanner)
{
    const auto specs = expand(fixtures::plan({"walker", "liar"}, 2));
    ASSERT_EQ(specs.size(), 12U);
    EXPECT_EQ(specs[0].caseId, "lanes/lanes/robots=1/0");
    EXPECT_EQ(specs[0].planner, 0U);
    EXPECT_EQ(specs[1].caseId, "lanes/lanes/robots=1/0");
    EXPECT_EQ(specs[1].planner, 1U);
    EXPECT_EQ(specs[2].caseId, "lanes/lanes/robots=1/1");
    EXPECT_EQ(specs[2].repetition, 1);
    EXPECT_EQ(specs[11].caseId, "lanes/lanes/robots=3/1");
    EXPECT_EQ(specs[11].point, 2U);
}

// A change of these numbers makes every kept result of every user worthless: it must be meant.
TEST(Expand, KeepsItsSeedsAndKeysFromVersionToVersion)
{
    const auto specs = expand(fixtures::plan({"walker"}, 2));
    EXPECT_EQ(specs[3].caseId, "lanes/lanes/robots=2/1");
    EXPECT_EQ(specs[3].graphSeed, 5761338400910109753U);
    EXPECT_EQ(specs[3].instanceSeed, 6122785070585858432U);
    EXPECT_EQ(specs[3].plannerSeed, 2211799296299884969U);
    EXPECT_EQ(specs[3].runKey, "6b951fdab034adf93c25bc42f9ae686c");
}

TEST(Expand, GivesEveryPlannerTheSameSeeds)
{
    const auto specs = expand(fixtures::plan({"walker", "liar"}, 1));
    EXPECT_EQ(specs[0].graphSeed, specs[1].graphSeed);
    EXPECT_EQ(specs[0].instanceSeed, specs[1].instanceSeed);
    EXPECT_EQ(specs[0].plannerSeed, specs[1].plannerSeed);
    EXPECT_NE(specs[0].runKey, specs[1].runKey);
}

TEST(Expand, GivesTheSameSeedsWhateverElseIsInThePlan)
{
    BenchmarkPlan small = fixtures::plan({"walker"}, 1);
    small.points = {fixtures::lanes(3)};
    const RunSpec alone = expand(small).front();
    const RunSpec amongOthers = expand(fixtures::plan({"liar", "walker"}, 4))[2 * 4 * 2 + 1];
    EXPECT_EQ(alone.caseId, amongOthers.caseId);
    EXPECT_EQ(alone.graphSeed, amongOthers.graphSeed);
    EXPECT_EQ(alone.instanceSeed, amongOthers.instanceSeed);
    EXPECT_EQ(alone.plannerSeed, amongOthers.plannerSeed);
    EXPECT_EQ(alone.runKey, amongOthers.runKey);
}

TEST(Expand, DrawsAllPointsOfASweepOverRobotsFromOneSequence)
{
    const auto specs = expand(fixtures::plan({"walker"}, 1));
    EXPECT_EQ(specs[0].graphSeed, specs[2].graphSeed);
    EXPECT_EQ(specs[0].instanceSeed, specs[2].instanceSeed);
    EXPECT_NE(specs[0].plannerSeed, specs[2].plannerSeed);
}

TEST(Expand, GivesEachRepetitionItsOwnSeeds)
{
    const auto specs = expand(fixtures::plan({"walker"}, 2));
    EXPECT_NE(specs[0].graphSeed, specs[1].graphSeed);
    EXPECT_NE(specs[0].instanceSeed, specs[1].instanceSeed);
    EXPECT_NE(specs[0].plannerSeed, specs[1].plannerSeed);
    EXPECT_NE(specs[0].graphSeed, specs[0].instanceSeed);
}

TEST(Expand, ChangesKeysWithEverythingAResultDependsOn)
{
    using Change = std::function<void(BenchmarkPlan &)>;
    const std::vector<Change> changes = {
        [](BenchmarkPlan &) {},
        [](BenchmarkPlan &plan) { plan.seed = 2; },
        [](BenchmarkPlan &plan) { plan.limits.time = 11; },
        [](BenchmarkPlan &plan) { plan.limits.memory = 11; },
        [](BenchmarkPlan &plan) { plan.motion = MotionRule::pebble; },
        [](BenchmarkPlan &plan) { plan.planners[0].kind = "liar"; },
        [](BenchmarkPlan &plan) {
            plan.planners[0].settings = {{"detours", "2"}};
        },
        [](BenchmarkPlan &plan) {
            plan.planners[0].settings = {{"detours", "3"}};
        },
        [](BenchmarkPlan &plan) {
            plan.planners[0].settings = {{"pause", "3"}};
        },
        [](BenchmarkPlan &plan) {
            plan.optimizers = {{"trimmer", "trimmer", {}}};
        },
        [](BenchmarkPlan &plan) {
            plan.optimizers = {{"trimmer", "t", {}}, {"breaker", "b", {}}};
        },
        [](BenchmarkPlan &plan) {
            plan.optimizers = {{"breaker", "b", {}}, {"trimmer", "t", {}}};
        },
        [](BenchmarkPlan &plan) { plan.points[0] = fixtures::lanes(2); },
        [](BenchmarkPlan &plan) { plan.points[0].model = "streets"; },
    };
    std::set<std::string> seen;
    for (const Change &change : changes)
    {
        BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
        plan.points.resize(1);
        change(plan);
        EXPECT_TRUE(seen.insert(keys(plan).front()).second) << "change " << seen.size();
    }
}

TEST(Expand, KeepsKeysWhereOnlyNamesOrTheWayOfRunningChange)
{
    const BenchmarkPlan plan = fixtures::plan({"walker"}, 2);
    BenchmarkPlan other = plan;
    other.campaign = "renamed";
    other.planners[0].name = "Walker of lanes";
    other.points[1].name = "roads";
    other.points[1].sweepVariable = "n";
    other.execution.jobs = 7;
    other.keep.solutions = true;
    other.reports = {"pdf"};
    other.text = "# comment";
    other.file = "elsewhere.yaml";
    EXPECT_EQ(keys(other), keys(plan));
}

TEST(Expand, DoesNotMindTheOrderAndSpellingOfSettings)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.planners[0].settings = {{"detours", "2"}, {"pause", "0.5"}};
    BenchmarkPlan other = plan;
    other.planners[0].settings = {{"pause", "0.50"}, {"detours", "2"}};
    const Catalog catalog = fixtures::catalog();
    resolve(plan, catalog);
    resolve(other, catalog);
    EXPECT_EQ(keys(other), keys(plan));
}

TEST(Expand, MeasuresTwiceWhatIsAskedTwice)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    const auto once = keys(plan);
    plan.planners.push_back({"walker", "again", {}});
    plan.points.push_back(fixtures::lanes(1));
    const auto specs = expand(plan);
    std::set<std::string> different;
    for (const RunSpec &spec : specs)
        different.insert(spec.runKey);
    EXPECT_EQ(different.size(), 8U);
    EXPECT_EQ(specs[0].runKey, once[0]); // the first keeps its key
    EXPECT_EQ(specs[0].plannerSeed, specs[1].plannerSeed);
    EXPECT_EQ(specs[6].caseId, "lanes/lanes/robots=1#2/0");
}

TEST(Expand, MakesCaseIdsThatAreSafeFileNames)
{
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points[0].name = "../grid 8×8/`touch x`";
    plan.points[0].sweepValue = 0.98;
    plan.points[1].name = "";
    plan.points[1].sweepVariable = "";
    plan.points[2].name = std::string(300, 'x');
    const auto specs = expand(plan);
    EXPECT_EQ(specs[0].caseId, "lanes/_.._grid_8_8__touch_x_/robots=0.98/0");
    EXPECT_EQ(specs[1].caseId, "lanes/_/0");
    EXPECT_EQ(specs[2].caseId, "lanes/" + std::string(100, 'x') + "/robots=3/0");
}

TEST(Expand, ReadsInputFilesForTheKeys)
{
    const fixtures::TemporaryFolder folder;
    const auto file = folder.path() / "input.txt";
    writeFile(file, "one");
    BenchmarkPlan plan = fixtures::plan({"walker"}, 1);
    plan.points = {fixtures::lanes(1, file)};
    const auto before = expand(plan);
    writeFile(file, "two");
    const auto after = expand(plan);
    EXPECT_NE(before[0].runKey, after[0].runKey);
    EXPECT_EQ(before[0].instanceSeed, after[0].instanceSeed);

    std::filesystem::remove(file);
    EXPECT_THROW((void)expand(plan), InputError);
    const auto blind = expand(plan, MissingInput::tolerate);
    ASSERT_EQ(blind.size(), 1U);
    EXPECT_EQ(blind[0].runKey, "");
    EXPECT_EQ(blind[0].instanceSeed, before[0].instanceSeed);
}

} // namespace
} // namespace mrpp
