#include "reports/CampaignComparison.h"
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
    EXPECT_EQ(regressions, 2U); // on the grid, and on everything
    EXPECT_FALSE(compareCampaigns(slow, fast).hasRegression());
    EXPECT_THAT(comparisonCsv(worse), ::testing::HasSubstr("second,fg_vr/grid,time,30,30,0,1.3,1.3,1.3,"));
}

TEST(CompareCampaigns, ToleratesALittleTime)
{
    EXPECT_FALSE(compareCampaigns(campaign().run(outcome(1)), campaign().run(outcome(1.05))).hasRegression());
    EXPECT_TRUE(compareCampaigns(campaign().run(outcome(1)), campaign().run(outcome(1.05)), {0.02, 0.5})
                    .hasRegression());
}

TEST(CompareCampaigns, ForgivesFlappingTimeoutsAndNoOthers)
{
    const auto ending = [](double time)
    {
        return [time](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.time = time;
        };
    };
    const ResultTable timeouts = campaign().run(
        [](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            if (planner == 0)
                record.status = PlannerStatus::timeout;
        });
    const ResultTable nearly = campaign().run(ending(8));
    const CampaignComparison forgiven = compareCampaigns(nearly, timeouts);
    EXPECT_EQ(forgiven.flapping, 30U);
    EXPECT_TRUE(forgiven.changedEnds.empty());
    for (const ComparedMeasure &measure : forgiven.measures)
        EXPECT_TRUE(measure.column != "solved" || measure.verdict == ComparedMeasure::Verdict::same);
    const ResultTable quick = campaign().run(ending(1));
    const CampaignComparison real = compareCampaigns(quick, timeouts);
    EXPECT_EQ(real.flapping, 0U);
    EXPECT_EQ(real.changedEnds.size(), 30U);
    EXPECT_TRUE(real.hasRegression());
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
    EXPECT_TRUE(comparisonPdf(comparison, fakeProvenance(), fakeProvenance()).starts_with("%PDF-"));
    EXPECT_EQ(comparisonPdf(comparison, fakeProvenance(), fakeProvenance()),
              comparisonPdf(comparison, fakeProvenance(), fakeProvenance()));
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
