#include "framework/statistics/Proportion.h"
#include "reports/summary/CampaignComparison.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

FakeCampaign campaign()
{
    FakeCampaign made("versions", 10);
    made.planner("first").planner("second").sweep("fg_vr", "grid", "robots", {1, 2, 3},
                                                  [](double) { return gridInstance(4, 1); });
    made.plan().limits.time = 10;
    return made;
}

/// Costs that vary a little with every run, the time of the second planner times `factor`.
FakeCampaign::Outcome outcome(double factor)
{
    return [factor](RunRecord &record, std::size_t planner)
    {
        solveSmoothly(record, planner);
        record.time =
            0.01 * (1 + 0.01 * static_cast<double>(record.repetition)) * (planner == 1 ? factor : 1);
    };
}

TEST(CompareCampaigns, FindsNothingBetweenEquals)
{
    const ResultTable results = campaign().run(outcome(1));
    const CampaignComparison comparison = compareCampaigns(results, results);
    EXPECT_EQ(comparison.pairs, 60U);
    EXPECT_FALSE(comparison.hasRegression());
    for (const ComparedMeasure &measure : comparison.measures)
        EXPECT_EQ(measure.verdict, ComparedMeasure::Verdict::same);
}

TEST(CompareCampaigns, FindsWhatBecameSlowerAndWhatBecameFaster)
{
    const ResultTable fast = campaign().run(outcome(1));
    const ResultTable slow = campaign().run(outcome(1.3));
    const CampaignComparison worse = compareCampaigns(fast, slow);
    EXPECT_TRUE(worse.hasRegression());
    std::size_t regressions = 0;
    for (const ComparedMeasure &measure : worse.measures)
        if (measure.verdict == ComparedMeasure::Verdict::worse)
        {
            ++regressions;
            EXPECT_EQ(measure.planner, "second");
            EXPECT_EQ(measure.column, "time");
            EXPECT_NEAR(measure.costs.medianRatio, 1.3, 1e-9);
        }
    EXPECT_EQ(regressions, 1U); // on the grid: on everything it would be the same test
    EXPECT_FALSE(compareCampaigns(slow, fast).hasRegression());
    EXPECT_THAT(comparisonCsv(worse),
                ::testing::HasSubstr("second,pebble,fg_vr/grid,time,30,30,0,1.3,1.3,1.3,-1,"));
}

TEST(CompareCampaigns, ToleratesALittleTime)
{
    EXPECT_FALSE(compareCampaigns(campaign().run(outcome(1)), campaign().run(outcome(1.05))).hasRegression());
    EXPECT_TRUE(compareCampaigns(campaign().run(outcome(1)), campaign().run(outcome(1.05)), {0.02, 0.5})
                    .hasRegression());
}

/// The first planner times out where `fails` says.
FakeCampaign::Outcome failing(double time, const std::function<bool(const RunRecord &)> &fails)
{
    return [=](RunRecord &record, std::size_t planner)
    {
        solveSmoothly(record, planner);
        record.time = time;
        if (planner == 0 && fails(record))
            record.status = PlannerStatus::timeout;
    };
}
const auto kNever = [](const RunRecord &) { return false; };
const auto kAlways = [](const RunRecord &) { return true; };

const ComparedMeasure *measureOf(const CampaignComparison &comparison, const std::string &column)
{
    for (const ComparedMeasure &measure : comparison.measures)
        if (measure.planner == "first" && measure.column == column)
            return &measure;
    return nullptr;
}

TEST(CompareCampaigns, TestsFlipsNearTheLimitLikeAllOthers)
{
    // Each solved run took 8 of 10 seconds: now all time out. Chance does not flip thirty coins one way.
    const CampaignComparison lost =
        compareCampaigns(campaign().run(failing(8, kNever)), campaign().run(failing(8, kAlways)));
    EXPECT_EQ(lost.flapping, 30U);
    EXPECT_EQ(lost.changedEnds.size(), 30U);
    EXPECT_TRUE(lost.hasRegression());
    EXPECT_EQ(measureOf(lost, ComparedMeasure::kAnswered)->onlyFirst, 30U);
    EXPECT_EQ(measureOf(lost, ComparedMeasure::kAnsweredClearly), nullptr); // nothing is left to test
    // As many one way as the other are chance.
    const auto odd = [](const RunRecord &run) { return run.repetition % 2 == 1; };
    const auto even = [](const RunRecord &run) { return run.repetition % 2 == 0; };
    const CampaignComparison both =
        compareCampaigns(campaign().run(failing(8, odd)), campaign().run(failing(8, even)));
    EXPECT_EQ(both.flapping, 30U);
    EXPECT_FALSE(both.hasRegression());
}

TEST(CompareCampaigns, HidesNoLossBehindFlapping)
{
    // Six lost at once, far from the limit, and as many flips each way near it.
    const auto now = [](RunRecord &record, std::size_t planner)
    {
        solveSmoothly(record, planner);
        const bool isClear = record.sweepValue == 1;
        record.time = isClear ? 0.1 : 8;
        if (planner == 0 && (isClear ? record.repetition < 6 : record.repetition % 2 == 0))
            record.status = PlannerStatus::timeout;
    };
    const auto before = [](RunRecord &record, std::size_t planner)
    {
        solveSmoothly(record, planner);
        const bool isClear = record.sweepValue == 1;
        record.time = isClear ? 0.1 : 8;
        if (planner == 0 && !isClear && record.repetition % 2 == 1)
            record.status = PlannerStatus::timeout;
    };
    const CampaignComparison comparison = compareCampaigns(campaign().run(before), campaign().run(now));
    EXPECT_EQ(comparison.flapping, 20U);
    EXPECT_NEAR(signTest(6, 0), 0.03125, 1e-12);
    ASSERT_NE(measureOf(comparison, ComparedMeasure::kAnsweredClearly), nullptr);
    EXPECT_EQ(measureOf(comparison, ComparedMeasure::kAnsweredClearly)->onlyFirst, 6U);
    EXPECT_EQ(measureOf(comparison, ComparedMeasure::kAnswered)->onlyFirst, 16U);
}

TEST(CompareCampaigns, OneLimitDoesNotExcuseTheOther)
{
    // Solved within 40 ms of 60 s, timed out after 3 ms: that is near no limit.
    FakeCampaign long60 = campaign();
    long60.plan().limits.time = 60;
    FakeCampaign short3 = campaign();
    short3.plan().limits.time = 0.003;
    const CampaignComparison comparison =
        compareCampaigns(long60.run(failing(0.04, kNever)), short3.run(failing(0.003, kAlways)));
    EXPECT_EQ(comparison.flapping, 0U);
    EXPECT_TRUE(comparison.hasRegression());
}

TEST(CompareCampaigns, CountsATestOnce)
{
    const CampaignComparison comparison =
        compareCampaigns(campaign().run(failing(1, kNever)), campaign().run(failing(1, kAlways)));
    // One test of 30 lost instances; everything else is equal, or has no pairs.
    std::size_t tests = 0;
    for (const ComparedMeasure &measure : comparison.measures)
    {
        EXPECT_EQ(measure.problem, "fg_vr/grid");
        tests += measure.p ? 1 : 0;
    }
    EXPECT_EQ(tests, 1U);
    EXPECT_NEAR(*measureOf(comparison, ComparedMeasure::kAnswered)->p, signTest(30, 0), 1e-18);
}

TEST(CompareCampaigns, TestsAllProblemsTogetherWhereSeveralDiffer)
{
    FakeCampaign two = campaign();
    two.sweep("fg_vr", "tree", "robots", {1}, [](double) { return treeInstance(); });
    const auto bothLose = [](const RunRecord &run) { return run.repetition < 3; };
    const CampaignComparison comparison =
        compareCampaigns(two.run(failing(1, kNever)), two.run(failing(1, bothLose)));
    const ComparedMeasure *all = measureOf(comparison, ComparedMeasure::kAnswered);
    EXPECT_EQ(all->problem, "");
    EXPECT_EQ(all->onlyFirst, 12U);
    EXPECT_EQ(all->verdict, ComparedMeasure::Verdict::worse);
    EXPECT_EQ(measureOf(comparison, "time")->problem, "fg_vr/grid"); // equal everywhere: no test of all
}

TEST(CompareCampaigns, CountsCopiesOnce)
{
    const auto copies = [](double factor)
    {
        return [factor](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.instanceFingerprint = "one";
            record.pathLength = static_cast<std::int64_t>(10 * factor);
            record.time = factor * (1 + 0.01 * static_cast<double>(record.repetition));
        };
    };
    const CampaignComparison comparison =
        compareCampaigns(campaign().run(copies(1)), campaign().run(copies(2)));
    EXPECT_EQ(comparison.pairs, 60U);
    EXPECT_EQ(comparison.instances, 2U); // of each planner one
    EXPECT_FALSE(comparison.hasRegression());
    for (const ComparedMeasure &measure : comparison.measures)
        EXPECT_FALSE(measure.p);
}

TEST(CompareCampaigns, CallsNothingBetterThatTheRanksCallWorse)
{
    const auto cost = [](bool isNow)
    {
        return [isNow](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.pathLength = !isNow                                                 ? 100
                                : record.repetition % 10 < 6 && record.sweepValue != 3 ? 99
                                                                                       : 300;
            record.makespan = 1;
            record.time = 1;
        };
    };
    // 12 of 30 a little shorter, 18 much longer; then 18 and 12.
    const auto mostly = [](RunRecord &record, std::size_t planner)
    {
        solveSmoothly(record, planner);
        record.pathLength = record.repetition < 6 ? 99 : 300;
        record.makespan = 1;
        record.time = 1;
    };
    const CampaignComparison worse =
        compareCampaigns(campaign().run(cost(false)), campaign().run(cost(true)));
    EXPECT_EQ(measureOf(worse, "path_length")->verdict, ComparedMeasure::Verdict::worse);
    const CampaignComparison unclear = compareCampaigns(campaign().run(cost(false)), campaign().run(mostly));
    EXPECT_LT(measureOf(unclear, "path_length")->costs.medianRatio, 1);
    EXPECT_NE(measureOf(unclear, "path_length")->verdict, ComparedMeasure::Verdict::better);
}

TEST(CompareCampaigns, AProofThatIsLostIsALoss)
{
    const auto proving = [](bool proves)
    {
        return [proves](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.solvable = "no";
            record.status = proves ? PlannerStatus::infeasible : PlannerStatus::gave_up;
        };
    };
    EXPECT_TRUE(
        compareCampaigns(campaign().run(proving(true)), campaign().run(proving(false))).hasRegression());
    EXPECT_FALSE(
        compareCampaigns(campaign().run(proving(false)), campaign().run(proving(true))).hasRegression());
}

TEST(CompareCampaigns, ANewDefectIsARegressionHoweverRare)
{
    const ResultTable before = campaign().run(outcome(1));
    const ResultTable now = campaign().run(
        [](RunRecord &record, std::size_t planner)
        {
            outcome(1)(record, planner);
            if (planner == 0 && record.sweepValue == 2 && record.repetition == 3)
                record.status = PlannerStatus::invalid;
        });
    const CampaignComparison comparison = compareCampaigns(before, now);
    ASSERT_EQ(comparison.newlyInvalid.size(), 1U);
    EXPECT_TRUE(comparison.hasRegression());
    EXPECT_TRUE(
        comparisonPdf(comparison, {"time limit: 60 before, 3 now"}, fakeProvenance(), fakeProvenance())
            .starts_with("%PDF-"));
    EXPECT_EQ(
        comparisonPdf(comparison, {"time limit: 60 before, 3 now"}, fakeProvenance(), fakeProvenance()),
        comparisonPdf(comparison, {"time limit: 60 before, 3 now"}, fakeProvenance(), fakeProvenance()));
}

TEST(CompareCampaigns, LeavesOtherInstancesOut)
{
    const auto marked = [](const char *mark)
    {
        return [mark](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.instanceFingerprint = record.repetition == 0 ? mark : "same";
        };
    };
    const CampaignComparison comparison =
        compareCampaigns(campaign().run(marked("a")), campaign().run(marked("b")));
    EXPECT_EQ(comparison.otherInstances, 6U);
    EXPECT_EQ(comparison.pairs, 54U);
}

} // namespace
} // namespace mrpp
