#include "reports/Findings.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;
using ::testing::HasSubstr;

/// Twenty points of two repetitions; the second planner needs a third more moves, and fails where `fails`
/// says.
ResultTable sweep(const std::vector<std::string> &planners,
                  const std::function<bool(const RunRecord &)> &fails)
{
    FakeCampaign campaign("found", 2);
    for (const std::string &name : planners)
        campaign.planner(name);
    std::vector<double> values;
    for (int i = 1; i <= 20; ++i)
        values.push_back(i);
    campaign.sweep("fg_vr", "grid", "robots", values, [](double) { return gridInstance(4, 1); });
    return campaign.run(
        [&](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, 0);
            const auto place = static_cast<std::int64_t>(*record.sweepValue);
            record.pathLength = 100 * place + 10 * record.repetition;
            // From 18 on the second planner is the better one.
            if (planner == 1)
                record.pathLength = *record.pathLength * (place <= 18 ? 4 : 2) / 3 + place % 3;
            if (planner == 1 && fails(record))
                record.status = PlannerStatus::timeout;
        });
}

const auto kNever = [](const RunRecord &) { return false; };

TEST(Findings, SayWhoNeedsFewerMovesWithNumbers)
{
    const Findings findings = findingsOf(caseTable(sweep({"push_and_rotate", "push_and_swap"}, kNever)));
    const CostFinding &moves = findings.costs.front();
    EXPECT_EQ(moves.first, "push_and_rotate");
    EXPECT_EQ(moves.pointsLess, 18U);
    EXPECT_EQ(moves.points, 20U);
    EXPECT_EQ(moves.comparison.pairs, 40U);
    EXPECT_EQ(moves.comparison.firstLess, 36U);
    EXPECT_TRUE(moves.isSignificant());
    EXPECT_THAT(moves.sentence(),
                HasSubstr("push_and_rotate needs fewer moves than push_and_swap on 18 of 20 points, "
                          "median ratio 0.75, 95 % CI 0.75–0.75 (40 cases that both solved, fewer on "
                          "36, more on 4; Wilcoxon signed-rank p < 0.001, Holm-corrected; A12 = 0."));
    EXPECT_THAT(findings.sentences(),
                ::testing::Contains("No difference in what they solve is shown between push_and_rotate and "
                                    "push_and_swap."));
}

TEST(Findings, SayWhoSolvesMore)
{
    const auto fails = [](const RunRecord &run) { return *run.sweepValue > 12; };
    const Findings findings = findingsOf(caseTable(sweep({"a", "b"}, fails)));
    ASSERT_EQ(findings.success.size(), 1U);
    EXPECT_EQ(findings.success[0].onlyFirst, 16U);
    EXPECT_NEAR(findings.success[0].p, 2.0 / 65536, 1e-12);
    EXPECT_THAT(
        findings.success[0].sentence(),
        HasSubstr(
            "a solves more than b: 16 cases that b does not, against 0 the other way; 100.0 % [91.2, 100.0] "
            "against 60.0 % [44.6, 73.7] of 40 cases"));
    EXPECT_EQ(findings.costs[0].comparison.pairs, 24U); // the others are no pairs
}

TEST(Findings, RefuseWhereThereIsTooLittle)
{
    const auto fails = [](const RunRecord &run) { return *run.sweepValue > 2; };
    const Findings findings = findingsOf(caseTable(sweep({"a", "b"}, fails)));
    EXPECT_FALSE(findings.costs[0].p);
    EXPECT_FALSE(findings.costs[0].comparison.ratioInterval);
    EXPECT_THAT(findings.sentences(),
                ::testing::Contains("Not tested for moves: a and b (only 4 of 4 pairs differ; a "
                                    "test needs 6)."));
}

TEST(Findings, HolmCountsEveryTest)
{
    const Findings three = findingsOf(caseTable(sweep({"a", "b", "c"}, kNever)));
    EXPECT_EQ(three.success.size(), 3U);
    EXPECT_EQ(three.costs.size(), 9U);
    // a and c are the same: all pairs tie, so that nothing is tested.
    EXPECT_EQ(three.costs[1].comparison.test.refusal, "only 0 of 40 pairs differ; a test needs 6");
    EXPECT_NEAR(*three.costs[0].p, 2 * *three.costs[0].comparison.test.p, 1e-15);
}

TEST(Findings, OfOnePlannerAreNone)
{
    EXPECT_TRUE(findingsOf(caseTable(sweep({"a"}, kNever))).sentences().empty());
}

} // namespace
} // namespace mrpp
