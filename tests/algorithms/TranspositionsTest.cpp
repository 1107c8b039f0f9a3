#include "algorithms/pebble/Transpositions.h"

#include "algorithms/pebble/PebbleOperations.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

TEST(OccupyGoals, BringsSomeRobotToEveryGoal)
{
    for (Seed seed = 1; seed <= 200; ++seed)
    {
        SCOPED_TRACE(seed);
        Random random(seed);
        const std::size_t vertices = 2 + random.below(40);
        const auto graph = test::randomConnectedGraph(vertices, random.below(6), seed);
        Instance instance = randomInstance(graph, random.below(vertices + 1), seed);
        PebbleBoard board(instance);
        ASSERT_TRUE(occupyGoals(instance, board, {}));
        std::vector<Vertex> reached;
        for (Robot r = 0; r < instance.robotCount(); ++r)
            reached.push_back(board.position(r));
        std::vector<Vertex> goals = instance.goals;
        instance.goals = reached;
        EXPECT_TRUE(validate(instance, board.takeSolution(), MotionRule::pebble).valid());
        std::sort(goals.begin(), goals.end());
        std::sort(reached.begin(), reached.end());
        EXPECT_EQ(reached, goals);
    }
}

TEST(Transpositions, ReachAnyPermutationOfBiconnectedGraphs)
{
    for (Seed seed = 1; seed <= 100; ++seed)
    {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto graph = test::gridGraph(2 + random.below(4), 3 + random.below(4));
        const Instance instance = randomInstance(graph, graph->vertexCount() - 2 - random.below(3), seed);
        const std::vector<std::uint32_t> oneSubgraph(instance.robotCount(), 0);
        PebbleBoard board(instance);
        const TerminationCondition never;
        PebbleOperations operations(board, never);
        Transpositions transpositions(instance, board, operations, oneSubgraph, never);
        ASSERT_TRUE(transpositions.run());
        EXPECT_TRUE(validate(instance, board.takeSolution(), MotionRule::pebble).valid());
    }
}

TEST(Transpositions, StopWhenTheyAreTold)
{
    const Instance instance = randomInstance(test::gridGraph(8, 8), 60, 1);
    const std::vector<std::uint32_t> oneSubgraph(instance.robotCount(), 0);
    int polls = 0;
    const auto stop = TerminationCondition::when([&polls] { return ++polls > 200; });
    PebbleBoard board(instance);
    PebbleOperations operations(board, stop);
    Transpositions transpositions(instance, board, operations, oneSubgraph, stop);
    EXPECT_FALSE(transpositions.run());
}

} // namespace
} // namespace mrpp
