#include "reports/KeyFacts.h"
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
    FakeCampaign campaign("facts", 4);
    campaign.planner("a").planner("b").problem("m", "p", treeInstance());
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
    EXPECT_EQ(facts[0], "Of 8 finished runs, 7 solved; the others: 1 timeout.");
    EXPECT_EQ(facts[1], "Most of the 4 cases that all planners finished were solved by b: 4.");
    EXPECT_EQ(facts[2], "Median path length over its lower bound, before optimizing, on the cases that every "
                        "planner solved (n = 3): a 2.00 and b 3.00.");
}

TEST(KeyFacts, SayHowManyRunsHadNoSolution)
{
    const auto facts = keyFacts(twoPlanners().run(
        [](RunRecord &record, std::size_t planner)
        {
            solve(record, planner);
            if (record.repetition > 0)
                return;
            record.status = PlannerStatus::infeasible;
            record.solvable = "no";
        }));
    EXPECT_EQ(facts[0],
              "Of 8 finished runs, 6 solved; the others: 2 infeasible. 2 runs had no solution under the "
              "planner's motion rule.");
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
    EXPECT_EQ(facts[1], "All planners solved equally many of the 4 cases that all finished: 2 each.");
    EXPECT_EQ(facts[2], "No case with a positive lower bound was solved by every planner, so their path "
                        "lengths cannot be compared.");
    EXPECT_TRUE(keyFacts(ResultTable(twoPlanners().plan(), {}, {})).empty());
}

} // namespace
} // namespace mrpp
