#include "reports/summary/KeyFacts.h"
#include "tests/reports/Campaigns.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

/// Planner 0 needs 20 moves, planner 1 30, for a lower bound of 10.
void solve(RunRecord &record, std::size_t planner)
{
    record.status = PlannerStatus::solved;
    record.pathLengthLowerBound = 10;
    record.pathLength = 20 + 10 * static_cast<std::int64_t>(planner);
}

FakeCampaign twoPlanners()
{
    FakeCampaign campaign("facts", 10);
    campaign.planner("a").planner("b", MotionRule::rotation).problem("m", "p", treeInstance());
    return campaign;
}

TEST(KeyFacts, CompareOnlyWhatEveryPlannerSolved)
{
    const auto facts = keyFacts(twoPlanners().run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            if (planner == 0 && record.repetition == 3)
                record.status = PlannerStatus::timeout;
            if (planner == 1 && record.repetition == 3)
                record.pathLength = 1000; // counts for nothing: a did not solve it
        }));
    ASSERT_EQ(facts.size(), 3U);
    EXPECT_EQ(facts[0], "Of 20 finished runs on 10 distinct instances, 19 solved; the others: 1 timeout.");
    EXPECT_EQ(facts[1],
              "Solved, of the 10 instances that all planners finished, where there is a solution under the "
              "planner's motion rule and it applies: b (rotation) 10 of 10 and a (pebble) 9 of 10.");
    EXPECT_EQ(facts[2], "Median path length over its lower bound [quartiles], before optimizing, on the "
                        "instances that every planner "
                        "solved (n = 9): a (pebble) 2.00 [2.00, 2.00] and b (rotation) 3.00 [3.00, 3.00].");
}

TEST(KeyFacts, CountProofsAsAnswers)
{
    const auto facts = keyFacts(twoPlanners().run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            if (record.repetition > 1)
                return;
            record.status = planner == 0 ? PlannerStatus::infeasible : PlannerStatus::gave_up;
            record.solvable = "no";
        }));
    EXPECT_EQ(
        facts[0],
        "Of 20 finished runs on 10 distinct instances, 16 solved; the others: 2 infeasible, 2 gave up. 4 "
        "runs had no solution under the planner's motion rule.");
    EXPECT_EQ(
        facts[1],
        "Solved, of the 10 instances that all planners finished, where there is a solution under the "
        "planner's motion rule and it applies: a (pebble) 8 of 8 and b (rotation) 8 of 8. Proved, of those "
        "without a solution: a (pebble) 2 of 2 and b (rotation) 0 of 2.");
}

TEST(KeyFacts, AWeakPlannerTakesNoHeadline)
{
    FakeCampaign campaign("weak", 10);
    campaign.planners(3).problem("m", "p", treeInstance());
    const auto facts = keyFacts(campaign.run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            if (planner == 2 && record.repetition > 0)
                record.status = PlannerStatus::gave_up;
            if (planner == 2)
                record.pathLength = 10; // the shortest of all, on the one instance that it solved
        }));
    EXPECT_EQ(facts[2], "Median path length over its lower bound [quartiles], before optimizing, on the "
                        "instances that all of these "
                        "planners solved (n = 10): planner_0 (pebble) 2.00 [2.00, 2.00] and planner_1 "
                        "(pebble) 3.00 [3.00, 3.00]. Not "
                        "among them, for having solved too few of the same: planner_2 (pebble).");
}

TEST(KeyFacts, SayWhereNothingCanBeCompared)
{
    const auto facts = keyFacts(twoPlanners().run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            if (record.repetition % 2 == static_cast<std::int64_t>(planner))
                record.status = PlannerStatus::gave_up;
        }));
    ASSERT_EQ(facts.size(), 3U);
    EXPECT_EQ(facts[2],
              "No two planners have solved 8 instances with a positive lower bound in common, so their path "
              "lengths are not compared here.");
    EXPECT_TRUE(keyFacts(ResultTable(twoPlanners().plan(), {}, {})).empty());
}

TEST(KeyFacts, OfCopiesCountTheInstance)
{
    const auto facts = keyFacts(twoPlanners().run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            record.instanceFingerprint = "one";
        }));
    EXPECT_EQ(facts[0], "Of 20 finished runs on 1 distinct instance, 20 solved.");
    EXPECT_EQ(facts[2],
              "No two planners have solved 8 instances with a positive lower bound in common, so their path "
              "lengths are not compared here.");
}

} // namespace
} // namespace mrpp
