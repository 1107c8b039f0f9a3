#include "framework/model/Schedule.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

TEST(Schedule, IsMadeStepByStep)
{
    Schedule schedule;
    const Move first[] = {{0, 0, 1}, {1, 3, 4}};
    const Move second[] = {{1, 4, 5}};
    schedule.appendStep(first);
    schedule.appendStep({});
    schedule.appendStep(second);
    EXPECT_EQ(schedule.makespan(), 3U);
    EXPECT_EQ(schedule.pathLength(), 3U);
    EXPECT_THAT(schedule.step(0), ElementsAre(first[0], first[1]));
    EXPECT_TRUE(schedule.step(1).empty());
    EXPECT_THAT(schedule.step(2), ElementsAre(second[0]));
    EXPECT_EQ(schedule, Schedule({first[0], first[1], second[0]}, {2, 2, 3}));
    EXPECT_EQ(Schedule().makespan(), 0U);
}

TEST(Schedule, SequentializesAChainFromItsHead)
{
    // Robots 0, 1, 2 follow each other towards vertex 3; written tail first.
    const Schedule schedule({{0, 0, 1}, {1, 1, 2}, {2, 2, 3}}, {3});
    const Solution solution = schedule.toSolution(4);
    EXPECT_EQ(solution, Solution({{2, 2, 3}, {1, 1, 2}, {0, 0, 1}}));
}

TEST(Schedule, SequentializesACycleAsARotation)
{
    // A cycle 0–1–2 beside a chain 4, 5, 6.
    const Schedule schedule({{0, 0, 1}, {3, 4, 5}, {1, 1, 2}, {4, 5, 6}, {2, 2, 0}}, {5});
    const Solution solution = schedule.toSolution(7);
    ASSERT_EQ(solution.rotations().size(), 1U);
    EXPECT_EQ(solution.rotations()[0], (Solution::Rotation{2, 3}));
    EXPECT_THAT(solution.moves(),
                ElementsAre(Move{4, 5, 6}, Move{3, 4, 5}, Move{0, 0, 1}, Move{1, 1, 2}, Move{2, 2, 0}));
}

TEST(Schedule, StepsDoNotDisturbEachOther)
{
    // The vertex that is left in the first step is entered in the second.
    const Schedule schedule({{0, 1, 2}, {1, 0, 1}, {0, 2, 3}}, {1, 3});
    EXPECT_EQ(schedule.toSolution(4), Solution({{0, 1, 2}, {1, 0, 1}, {0, 2, 3}}));
}

TEST(Schedule, OfActionsHasAStepForEach)
{
    const Move cycle[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};
    Solution solution;
    solution.append({3, 3, 4});
    solution.appendRotation(cycle);
    const Schedule schedule = Schedule::fromActions(solution);
    EXPECT_EQ(schedule.makespan(), 2U);
    EXPECT_THAT(schedule.step(1), ElementsAre(cycle[0], cycle[1], cycle[2]));
    EXPECT_EQ(schedule.toSolution(5), solution);
}

RC_GTEST_PROP(Schedule, ALegalOneSequentializesIntoALegalSolution, ())
{
    const auto seed = *rc::gen::arbitrary<Seed>();
    const auto vertices = *rc::gen::inRange<std::size_t>(3, 20);
    const auto robots = *rc::gen::inRange<std::size_t>(1, vertices + 1);
    const auto rule = *rc::gen::element(MotionRule::parallel, MotionRule::following, MotionRule::rotation);
    const auto test = test::randomScheduledCase(test::randomConnectedGraph(vertices, vertices / 2, seed),
                                                robots, 12, rule, seed);
    RC_ASSERT(validate(test.instance, test.schedule, rule).violation.empty());

    const Solution solution = test.schedule.toSolution(vertices);
    const MotionRule sequential = rule == MotionRule::rotation ? rule : MotionRule::pebble;
    const Verdict verdict = validate(test.instance, solution, sequential);
    RC_ASSERT(verdict.violation.empty());
    RC_ASSERT(verdict.valid());
    RC_ASSERT(solution.pathLength() == test.schedule.pathLength());
    RC_TAG(solution.rotations().empty() ? "without rotations" : "with rotations");
}

} // namespace
} // namespace mrpp
