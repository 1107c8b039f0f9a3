#include "tests/support/RandomCases.h"
#include "framework/analysis/Components.h"
#include "framework/evaluation/Validator.h"

#include <gtest/gtest.h>

namespace mrpp::test
{
namespace
{

TEST(RandomCases, GraphsAreConnectedAndHaveTheEdgesAskedFor)
{
    for (Seed seed = 0; seed < 50; ++seed)
    {
        const auto graph = randomConnectedGraph(10, 4, seed);
        EXPECT_EQ(Components(*graph).count(), 1U);
        EXPECT_EQ(graph->edgeCount(), 13U);
    }
    EXPECT_EQ(randomConnectedGraph(4, 100, 1)->edgeCount(), 6U);
    EXPECT_EQ(randomConnectedGraph(1, 3, 1)->edgeCount(), 0U);
}

TEST(RandomCases, GridsHaveTheirEdges)
{
    EXPECT_EQ(gridGraph(5, 3)->vertexCount(), 15U);
    EXPECT_EQ(gridGraph(5, 3)->edgeCount(), 22U);
    EXPECT_TRUE(gridGraph(5, 3)->hasEdge(3, 8));
    EXPECT_FALSE(gridGraph(5, 3)->hasEdge(4, 5));
}

TEST(RandomCases, SolutionsAreValidAndAsLongAsAskedFor)
{
    for (Seed seed = 0; seed < 100; ++seed)
    {
        const auto test = randomSolvedCase(randomConnectedGraph(12, 3, seed), 7, 60, seed);
        EXPECT_EQ(validate(test.instance, test.solution, MotionRule::pebble).violation, "");
        EXPECT_EQ(test.solution.pathLength(), 60U);
    }
}

TEST(RandomCases, RotationsOccurAndAreValid)
{
    std::size_t rotations = 0;
    for (Seed seed = 0; seed < 100; ++seed)
    {
        const auto test = randomSolvedCaseWithRotations(gridGraph(4, 3), 9, 40, seed);
        EXPECT_EQ(validate(test.instance, test.solution, MotionRule::rotation).violation, "");
        rotations += test.solution.rotations().size();
    }
    EXPECT_GT(rotations, 300U);
}

TEST(RandomCases, SchedulesAreLegalUnderTheirRuleAndUseIt)
{
    for (const MotionRule rule :
         {MotionRule::pebble, MotionRule::parallel, MotionRule::following, MotionRule::rotation})
    {
        std::size_t moves = 0;
        bool narrower = true;
        for (Seed seed = 0; seed < 50; ++seed)
        {
            const auto test = randomScheduledCase(gridGraph(4, 4), 10, 20, rule, seed);
            EXPECT_EQ(validate(test.instance, test.schedule, rule).violation, "");
            moves += test.schedule.pathLength();
            if (rule != MotionRule::pebble)
                narrower = narrower && validate(test.instance, test.schedule,
                                                static_cast<MotionRule>(static_cast<int>(rule) - 1))
                                           .valid();
        }
        EXPECT_GT(moves, rule == MotionRule::pebble ? 500U : 1500U) << toString(rule);
        EXPECT_EQ(narrower, rule == MotionRule::pebble) << toString(rule);
    }
}

TEST(RandomCases, TheSameSeedGivesTheSameCase)
{
    const auto first = randomSolvedCase(randomConnectedGraph(12, 3, 5), 4, 30, 5);
    const auto second = randomSolvedCase(randomConnectedGraph(12, 3, 5), 4, 30, 5);
    EXPECT_EQ(first.instance.fingerprint(), second.instance.fingerprint());
    EXPECT_EQ(first.solution, second.solution);
    EXPECT_NE(randomSolvedCase(randomConnectedGraph(12, 3, 5), 4, 30, 6).solution, first.solution);
    EXPECT_EQ(randomSolvableInstance(gridGraph(3, 3), 4, 1).fingerprint(),
              randomSolvableInstance(gridGraph(3, 3), 4, 1).fingerprint());
}

} // namespace
} // namespace mrpp::test
