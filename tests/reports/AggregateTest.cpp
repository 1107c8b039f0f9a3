#include "reports/Aggregate.h"

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

TEST(RunGroup, CountsEveryRunButSumsUpTheSolvedOnes)
{
    const std::vector<RunRecord> records = {
        record("a", {}, PlannerStatus::solved, 8), record("a", {}, PlannerStatus::partial, 1000),
        record("a", {}, PlannerStatus::solved, 16), record("a", {}, PlannerStatus::timeout, 1000)};
    const auto groups = groupRuns(records);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].runs.size(), 4U);
    EXPECT_EQ(groups[0].solved(), 2U);
    EXPECT_EQ(groups[0].count(PlannerStatus::timeout), 1U);
    EXPECT_EQ(groups[0].successRate(), 0.5);
    EXPECT_EQ(groups[0].overSolved("path_length"), (Quartiles{10, 12, 14, 2}));
    EXPECT_EQ(groups[0].overSolved("makespan"), std::nullopt);
    EXPECT_EQ(groups[0].ratio("path_length", "path_length_lower_bound"), (Quartiles{2.5, 3, 3.5, 2}));
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
