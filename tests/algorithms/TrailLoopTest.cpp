#include "algorithms/pebble/TrailLoop.h"

#include "algorithms/pebble/PebbleOperations.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>
#include <numeric>
#include <utility>

namespace mrpp
{
namespace
{

struct Loop
{
    explicit Loop(const Instance &given, TerminationCondition stop = {})
        : instance(given), ptc(std::move(stop)), landmarks(*instance.graph),
          paths(*instance.graph, landmarks), board(instance), operations(board, ptc),
          loop(instance, board, operations, paths, ptc, {.mostSetbacks = 100})
    {}

    TrailLoop<PebbleOperations>::End run()
    {
        std::vector<Robot> order(instance.robotCount());
        std::iota(order.begin(), order.end(), 0);
        return loop.run(order);
    }

    const Instance instance;
    TerminationCondition ptc;
    Landmarks landmarks;
    PathFinder paths;
    PebbleBoard board;
    PebbleOperations operations;
    TrailLoop<PebbleOperations> loop;
};

using End = TrailLoop<PebbleOperations>::End;

void expectSolved(const Instance &instance)
{
    Loop loop(instance);
    ASSERT_EQ(loop.run(), End::solved) << loop.loop.reason();
    const Verdict verdict = validate(instance, loop.board.takeSolution(), MotionRule::pebble);
    EXPECT_TRUE(verdict.valid()) << verdict.violation;
}

TEST(TrailLoop, TurnsATrailThatClosesInTwoVerticesByASwap)
{
    expectSolved({Graph::fromEdges(5, {{4, 0}, {4, 1}, {4, 2}, {4, 3}}), {0, 1, 2}, {4, 2, 1}});
}

TEST(TrailLoop, TurnsACycleOfDisplacedRobots)
{
    expectSolved(
        {Graph::fromEdges(7, {{0, 1}, {0, 2}, {0, 4}, {0, 6}, {1, 2}, {1, 3}, {1, 5}, {2, 3}, {2, 5}}),
         {0, 1, 2, 4, 5},
         {0, 1, 4, 5, 2}});
}

TEST(TrailLoop, SolvesBiconnectedGraphsWithTwoFreeVertices)
{
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto graph = test::gridGraph(2 + random.below(6), 3 + random.below(6));
        expectSolved(randomInstance(graph, graph->vertexCount() - 2, seed));
    }
}

TEST(TrailLoop, GetsStuckWithAReasonWhereNobodyCanPass)
{
    Loop loop({Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}}), {0, 1}, {1, 0}});
    EXPECT_EQ(loop.run(), End::stuck);
    EXPECT_NE(loop.loop.reason().find("robot"), std::string::npos) << loop.loop.reason();
}

TEST(TrailLoop, StopsWhenItIsTold)
{
    Loop loop(randomInstance(test::gridGraph(5, 5), 20, 1), TerminationCondition::after(0));
    EXPECT_EQ(loop.run(), End::stopped);
}

TEST(Rotate, TurnsAFullCycleAndNothingElse)
{
    // A square with a corridor, and a junction elsewhere where two robots can exchange.
    const auto graph = Graph::fromEdges(8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}, {4, 5}, {4, 6}, {5, 7}});
    const Instance instance{graph, {0, 1, 2, 3, 6}, {1, 2, 3, 0, 6}};
    const TerminationCondition never;
    PebbleBoard board(instance);
    PebbleOperations operations(board, never);
    const std::vector<Vertex> cycle{0, 1, 2, 3};
    ASSERT_TRUE(operations.rotate(cycle));
    EXPECT_TRUE(validate(instance, board.takeSolution(), MotionRule::pebble).valid());
}

TEST(Rotate, MovesEachRobotOnceWhereTheCycleHasHoles)
{
    const auto graph = Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}});
    const Instance instance{graph, {0, 1, 3, 4}, {1, 2, 4, 5}};
    const TerminationCondition never;
    PebbleBoard board(instance);
    PebbleOperations operations(board, never);
    const std::vector<Vertex> cycle{0, 1, 2, 3, 4, 5};
    ASSERT_TRUE(operations.rotate(cycle));
    EXPECT_EQ(board.moves().size(), 4U);
    EXPECT_TRUE(validate(instance, board.takeSolution(), MotionRule::pebble).valid());
}

} // namespace
} // namespace mrpp
