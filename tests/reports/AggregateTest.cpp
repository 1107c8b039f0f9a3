#include "reports/summary/Aggregate.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

RunRecord record(const std::string &planner, std::optional<double> at, PlannerStatus status,
                 std::int64_t moves)
{
    RunRecord run;
    run.model = "m";
    run.problem = "p";
    run.sweepVariable = at ? "robots" : "";
    run.sweepValue = at;
    run.planner = planner;
    run.status = status;
    run.pathLength = moves;
    run.pathLengthLowerBound = 4;
    return run;
}

TEST(RunGroup, SumsUpTheSameInstancesForAllPlanners)
{
    // a solves 3 of 5, b all; one instance has no solution, and nobody compares costs on it.
    std::vector<RunRecord> records;
    for (const char *planner : {"a", "b"})
        for (const std::int64_t moves : {8, 16, 24, 32, 40})
        {
            const bool isSolved = *planner == 'b' || moves <= 24;
            records.push_back(
                record(planner, {}, isSolved ? PlannerStatus::solved : PlannerStatus::timeout, moves));
            records.back().caseId = "m/p/" + std::to_string(moves);
            records.back().time = 1;
        }
    for (const char *planner : {"a", "b"})
    {
        records.push_back(record(planner, {}, PlannerStatus::gave_up, 1));
        records.back().caseId = "m/p/hopeless";
        records.back().solvable = "no";
    }
    records.back().status = PlannerStatus::infeasible;
    const auto groups = groupRuns(records);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].answers.size(), 6U);
    EXPECT_EQ(groups[0].solved(), 3U);
    EXPECT_EQ(groups[0].counted(), 5U);
    EXPECT_EQ(groups[0].count(Outcome::failed), 3U);
    EXPECT_EQ(groups[1].count(Outcome::proved), 1U);
    EXPECT_EQ(groups[0].successRate(), 0.6);
    EXPECT_EQ(groups[1].successRate(), 1);
    EXPECT_EQ(groups[0].cost("path_length"), (Quartiles{16, 24, kNoAnswer, 5}));
    EXPECT_EQ(groups[1].cost("path_length"), (Quartiles{16, 24, 32, 5}));
    EXPECT_EQ(groups[0].ratio("path_length", "path_length_lower_bound"), (Quartiles{4, 6, kNoAnswer, 5}));
    EXPECT_EQ(groups[0].cost("makespan"), std::nullopt);
    EXPECT_EQ(groups[0].penalizedTime(10, 2), 8.6); // (1 + 1 + 1 + 20 + 20) / 5, without the hopeless one
    EXPECT_EQ(groups[1].penalizedTime(10, 2), 1);   // nor the one that was proved
}

TEST(RunGroup, HasNoMedianWhereHalfOfTheInstancesFailed)
{
    std::vector<RunRecord> records = {record("a", {}, PlannerStatus::solved, 8),
                                      record("a", {}, PlannerStatus::partial, 4)};
    records[0].caseId = "m/p/0";
    records[1].caseId = "m/p/1";
    EXPECT_EQ(groupRuns(records)[0].cost("path_length"), std::nullopt);
    EXPECT_EQ(groupRuns(records)[0].successRate(), 0.5);
}

TEST(RunGroup, IsNeverBelowTheMedianOfALowerBound)
{
    // Easy instances and hard ones; whoever solves the easy ones alone has no median below the bound's.
    std::vector<RunRecord> records;
    for (int i = 0; i < 9; ++i)
        for (const char *planner : {"strong", "weak"})
        {
            records.push_back(record(planner, {}, PlannerStatus::solved, 10 * (i + 1)));
            records.back().pathLengthLowerBound = 10 * (i + 1);
            records.back().caseId = "m/p/" + std::to_string(i);
            if (*planner == 'w' && i > 2)
                records.back().status = PlannerStatus::timeout;
        }
    EXPECT_EQ(groupRuns(records)[0].cost("path_length")->median, 50);
    EXPECT_EQ(groupRuns(records)[1].cost("path_length"), std::nullopt);
}

TEST(RunGroup, CountsCopiesOnce)
{
    std::vector<RunRecord> records(20, record("a", {}, PlannerStatus::solved, 8));
    for (std::size_t i = 0; i < records.size(); ++i)
    {
        records[i].caseId = "m/p/" + std::to_string(i);
        records[i].instanceFingerprint = "the same";
    }
    const auto groups = groupRuns(records);
    EXPECT_EQ(groups[0].runs.size(), 20U);
    EXPECT_EQ(groups[0].answers.size(), 1U);
    EXPECT_EQ(groups[0].cost("path_length"), (Quartiles{8, 8, 8, 1}));
    EXPECT_EQ(groups[0].solved(), 1U);
}

TEST(IsCost, IsWhatAPlannerSpends)
{
    EXPECT_TRUE(isCost("time"));
    EXPECT_TRUE(isCost("path_length"));
    EXPECT_FALSE(isCost("path_length_lower_bound"));
    EXPECT_FALSE(isCost("completed"));
    EXPECT_FALSE(isCost("vertices"));
}

TEST(SummarizeProblems, OrdersSweepPointsByValueAndPlannersAsTheyCome)
{
    const std::vector<RunRecord> records = {
        record("b", 100, PlannerStatus::solved, 1), record("a", 100, PlannerStatus::solved, 1),
        record("b", 20, PlannerStatus::solved, 1), record("a", 20, PlannerStatus::solved, 1)};
    const auto problems = summarizeProblems(records);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_TRUE(problems[0].swept());
    std::string order;
    for (const RunGroup &group : problems[0].groups)
        order += group.planner + std::to_string(static_cast<int>(*group.sweepValue)) + " ";
    EXPECT_EQ(order, "b20 a20 b100 a100 ");
}

TEST(MetricTitle, HasTheUnit)
{
    EXPECT_EQ(metricTitle("time"), "Time (s)");
    EXPECT_EQ(metricTitle("path_length"), "Path length (moves)");
    EXPECT_EQ(metricTitle("my_column"), "my_column");
}

} // namespace
} // namespace mrpp
