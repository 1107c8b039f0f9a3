#include "reports/summary/CaseTable.h"
#include "tests/reports/Campaigns.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

/// Four planners on 20 instances: the last solves the first `weak` of them, the third the last 12.
ResultTable uneven(std::int64_t weak)
{
    FakeCampaign campaign("uneven", 20);
    campaign.planners(4).problem("m", "p", treeInstance());
    return campaign.run(
        [weak](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            if ((planner == 3 && record.repetition >= weak) || (planner == 2 && record.repetition < 8))
                record.status = PlannerStatus::timeout;
        });
}

TEST(CaseTable, CopiesOfAnInstanceAreOneCase)
{
    FakeCampaign campaign("copies", 6);
    campaign.planners(2).problem("m", "p", treeInstance()).problem("m", "q", treeInstance());
    const ResultTable results = campaign.run(
        [](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.time = static_cast<double>(record.repetition + 1);
            record.instanceFingerprint = record.problem == "p" ? "tree" : std::to_string(record.repetition);
        });
    const CaseTable table = caseTable(results);
    ASSERT_EQ(table.cases.size(), 7U);
    EXPECT_EQ(table.cases[0].answers[1].runs(), 6U);
    EXPECT_EQ(table.cases[0].answers[1].cost("time"), 3.5);
    EXPECT_EQ(table.byPoint().size(), 2U);
}

TEST(CaseTable, PointsWithTheSameInstancesAreOne)
{
    FakeCampaign campaign("rounded", 3);
    campaign.planners(1).sweep("m", "p", "occupancy", {0.5, 0.51, 0.9},
                               [](double) { return treeInstance(); });
    const ResultTable results = campaign.run(
        [](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.instanceFingerprint =
                (*record.sweepValue < 0.6 ? "half" : "full") + std::to_string(record.repetition);
        });
    const CaseTable table = caseTable(results);
    EXPECT_EQ(table.cases.size(), 6U);
    EXPECT_EQ(table.byPoint().size(), 2U);
}

TEST(CommonCases, AWeakPlannerDoesNotEmptyThem)
{
    const ResultTable results = uneven(1);
    const CaseTable table = caseTable(results);
    const CommonCases common = commonCases(table, "path_length");
    EXPECT_EQ(common.planners, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(common.leftOut, (std::vector<std::size_t>{3}));
    EXPECT_EQ(common.cases.size(), 12U);
}

TEST(CommonCases, WhoSharesTooFewIsLeftOut)
{
    // The last planner solved 12 of 20, but only four of those that the third did.
    const ResultTable results = uneven(12);
    const CaseTable table = caseTable(results);
    const CommonCases common = commonCases(table, "path_length");
    EXPECT_EQ(common.planners, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(common.cases.size(), 12U);
}

TEST(CommonCases, FewerThanEightAreNone)
{
    FakeCampaign campaign("few", 7);
    campaign.planners(2).problem("m", "p", treeInstance());
    const ResultTable results = campaign.run(solveSmoothly);
    const CaseTable table = caseTable(results);
    EXPECT_TRUE(commonCases(table, "path_length").planners.empty());
    EXPECT_TRUE(commonCases(table, "path_length").cases.empty());
    EXPECT_EQ(commonCases(table, "path_length").leftOut.size(), 2U);
}

TEST(CommonCases, OfOnePlannerAreAllItsOwn)
{
    FakeCampaign campaign("alone", 3);
    campaign.planners(1).problem("m", "p", treeInstance());
    const ResultTable results = campaign.run(solveSmoothly);
    const CaseTable table = caseTable(results);
    EXPECT_EQ(commonCases(table, "path_length").cases.size(), 3U);
    EXPECT_EQ(commonCases(table, "optimized_sum_of_costs").cases.size(), 0U);
}

} // namespace
} // namespace mrpp
