#include "framework/evaluation/Metrics.h"
#include "tests/support/RandomCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mrpp
{
namespace
{

TEST(Metrics, AreTheNumericColumnsInTheirOrder)
{
    std::vector<std::string_view> names;
    for (const Metric &metric : metrics())
        names.push_back(metric.name);
    EXPECT_THAT(names,
                ::testing::ElementsAre("time", "setup_time", "optimization_time", "memory", "path_length",
                                       "actions", "makespan", "optimized_path_length", "optimized_actions",
                                       "optimized_makespan", "sum_of_costs", "optimized_sum_of_costs",
                                       "path_length_lower_bound", "makespan_lower_bound", "completed",
                                       "cpu_time", "sum_of_costs_lower_bound", "bound_time"));
}

TEST(Metrics, EachHasATitleOfItsOwnAndASentence)
{
    std::set<std::string_view> titles;
    for (const Metric &metric : metrics())
    {
        EXPECT_TRUE(titles.insert(metric.title).second) << metric.title;
        EXPECT_TRUE(metric.description.ends_with('.')) << metric.name;
        EXPECT_EQ(metric.better == Metric::Better::higher, metric.name == "completed");
    }
}

TEST(Metrics, AreFoundByName)
{
    ASSERT_NE(findMetric("makespan"), nullptr);
    EXPECT_EQ(findMetric("makespan")->title, "Makespan");
    EXPECT_EQ(findMetric("makespan")->unit, "steps");
    EXPECT_EQ(findMetric("time")->unit, "s");
    EXPECT_EQ(findMetric("memory")->unit, "MB");
    EXPECT_EQ(findMetric("Makespan"), nullptr);
}

/// Robot 0 goes from 0 to 2 by way of 1, robot 1 follows from 3 to 0, robot 2 stays on 4.
const Instance kFollow{Graph::fromEdges(5, {{0, 1}, {1, 2}, {3, 0}, {2, 4}}), {0, 3, 4}, {2, 0, 4}};
const Solution kFollowSolution({{0, 0, 1}, {0, 1, 2}, {1, 3, 0}});

TEST(Measure, CountsMovesStepsAndCosts)
{
    const SolutionMetrics following = measure(kFollow, kFollowSolution, MotionRule::following);
    EXPECT_EQ(following.pathLength, 3U);
    EXPECT_EQ(following.actions, 3U);
    EXPECT_EQ(following.makespan, 2U);
    EXPECT_EQ(following.sumOfCosts, 3U); // 2 + 1 + 0
    EXPECT_EQ(following.completed, 1);

    const SolutionMetrics parallel = measure(kFollow, kFollowSolution, MotionRule::parallel);
    EXPECT_EQ(parallel.makespan, 2U);
    EXPECT_EQ(parallel.sumOfCosts, 4U); // 2 + 2 + 0

    const SolutionMetrics pebble = measure(kFollow, kFollowSolution, MotionRule::pebble);
    EXPECT_EQ(pebble.makespan, 3U);
    EXPECT_EQ(pebble.sumOfCosts, 5U); // 2 + 3 + 0
}

TEST(Measure, ARobotThatReturnsCostsUntilItStays)
{
    const Instance instance{Graph::fromEdges(2, {{0, 1}}), {0}, {0}};
    const SolutionMetrics metrics =
        measure(instance, Solution({{0, 0, 1}, {0, 1, 0}}), MotionRule::following);
    EXPECT_EQ(metrics.sumOfCosts, 2U);
    EXPECT_EQ(metrics.completed, 1);
}

TEST(Measure, ARobotThatDoesNotArriveCostsTheWholeMakespan)
{
    // Robot 0 stops on 1 after one step, robot 1 goes to its goal, out of it and back.
    const Solution solution({{0, 0, 1}, {1, 3, 0}, {1, 0, 3}, {1, 3, 0}});
    const SolutionMetrics metrics = measure(kFollow, solution, MotionRule::following);
    EXPECT_EQ(metrics.makespan, 3U);
    EXPECT_EQ(metrics.sumOfCosts, 6U); // 3 + 3 + 0
}

TEST(Measure, CompletedIsTheShareOfRobotsThatEndAtTheirGoals)
{
    const SolutionMetrics metrics = measure(kFollow, Solution({{0, 0, 1}, {1, 3, 0}}), MotionRule::following);
    EXPECT_DOUBLE_EQ(metrics.completed, 2.0 / 3);
    EXPECT_EQ(metrics.makespan, 1U);
    EXPECT_EQ(metrics.sumOfCosts, 2U); // robot 0 is on its way: 1, robot 1: 1, robot 2: 0
}

TEST(Measure, WithoutRobotsEverythingIsDone)
{
    const SolutionMetrics metrics = measure({Graph::fromEdges(1, {}), {}, {}}, {}, MotionRule::following);
    EXPECT_EQ(metrics.completed, 1);
    EXPECT_EQ(metrics.makespan, 0U);
    EXPECT_EQ(metrics.sumOfCosts, 0U);
}

TEST(Measure, ARotationIsOneActionOfOneStep)
{
    const Move turn[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};
    Solution solution;
    solution.appendRotation(turn);
    const SolutionMetrics metrics =
        measure({Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}}), {0, 1, 2}, {1, 2, 0}}, solution,
                MotionRule::following);
    EXPECT_EQ(metrics.pathLength, 3U);
    EXPECT_EQ(metrics.actions, 1U);
    EXPECT_EQ(metrics.makespan, 1U);
    EXPECT_EQ(metrics.sumOfCosts, 3U);
}

} // namespace
} // namespace mrpp
