#include "algorithms/PushAndRotate.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/ConfigurationOrbits.h"
#include "tests/support/CpuClock.h"
#include "tests/support/PollWatch.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using test::Edges;
using test::graphOf;
using test::smallProblem;
using Rotator = test::TrailRun<PushAndRotate>;

struct Limits
{
    std::string problem;
    std::size_t fewest;    ///< exact optimum, or a lower bound
    std::size_t most;      ///< of the first attempt; published, or measured for a plain implementation
    std::size_t restarted; ///< with 1000 restarts, after redundancy removal
};

class SmallProblemsByRotation : public testing::TestWithParam<Limits>
{};

TEST_P(SmallProblemsByRotation, AreSolvedWithNoMoreMovesThanPublished)
{
    const Instance instance = smallProblem(GetParam().problem);
    Rotator run;
    run.expectSolved(instance);
    EXPECT_GE(run.solution().pathLength(), GetParam().fewest);
    EXPECT_LE(run.solution().pathLength(), GetParam().most);
}

TEST_P(SmallProblemsByRotation, BecomeShortByRestarts)
{
    const Instance instance = smallProblem(GetParam().problem);
    for (const Seed seed : {1U, 2U, 3U})
    {
        Rotator run("1000");
        const double start = test::cpuSeconds();
        run.expectSolved(instance, seed);
        EXPECT_LT(test::cpuSeconds() - start, 20 * test::kPromptly); // a second, of all threads
        const Solution optimized = RedundancyRemoval().improve(instance, run.solution(), {});
        ASSERT_TRUE(validate(instance, optimized, MotionRule::pebble).valid());
        EXPECT_GE(optimized.pathLength(), GetParam().fewest);
        EXPECT_LE(optimized.pathLength(), GetParam().restarted);
    }
}

INSTANTIATE_TEST_SUITE_P(Published, SmallProblemsByRotation,
                         testing::Values(Limits{"tree", 12, 34, 12}, Limits{"tunnel", 49, 167, 53},
                                         Limits{"string", 20, 48, 20}, Limits{"corners", 55, 161, 81},
                                         Limits{"corners_published", 50, 264, 70},
                                         Limits{"connector", 60, 398, 120},
                                         Limits{"loop_chain", 98, 444, 120},
                                         Limits{"biconnected", 25, 104, 66}, Limits{"grid", 30, 107, 61},
                                         Limits{"polygon", 6, 6, 6}, Limits{"theta", 4, 40, 8}),
                         [](const auto &test) { return test.param.problem; });

TEST(PushAndRotate, ProvesThatOnlyRotationsHelp)
{
    Rotator run;
    EXPECT_EQ(run(smallProblem("tree_with_cycle_leaves")), PlannerStatus::infeasible);
    EXPECT_NE(run.reason().find("corridor"), std::string::npos) << run.reason();
}

struct Regression
{
    const char *what;
    std::size_t vertices;
    Edges edges;
    std::vector<Vertex> starts;
    std::vector<Vertex> goals;
};

class RotationRegressions : public testing::TestWithParam<Regression>
{};

TEST_P(RotationRegressions, AreSolvedByTheMainLoop)
{
    const Regression &c = GetParam();
    Rotator run;
    run.expectSolved({graphOf(c.vertices, c.edges), c.starts, c.goals});
    EXPECT_EQ(run.fallbacks(), 0);
}

// Instances on which printed versions of Push and Rotate fail.
INSTANTIATE_TEST_SUITE_P(
    Known, RotationRegressions,
    testing::Values(
        Regression{"two_vertex_cycle_of_displaced_robots",
                   5,
                   {{4, 0}, {4, 1}, {4, 2}, {4, 3}},
                   {0, 1, 2},
                   {4, 2, 1}},
        Regression{
            "dead_end_that_must_be_filled_first", 5, {{0, 4}, {4, 3}, {3, 1}, {3, 2}}, {0, 1, 2}, {3, 2, 1}},
        Regression{"clear_needs_stage_3", 5, {{0, 1}, {0, 2}, {0, 4}, {1, 2}, {2, 3}}, {0, 1, 2}, {0, 1, 4}},
        Regression{"clear_needs_stage_4", 5, {{0, 1}, {1, 3}, {1, 4}, {2, 3}, {2, 4}}, {0, 1, 2}, {0, 3, 1}},
        Regression{"subgraphs_in_the_wrong_order",
                   7,
                   {{0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 5}, {2, 6}},
                   {0, 1, 2, 3, 5},
                   {1, 4, 2, 3, 6}},
        Regression{"cycle_of_displaced_robots",
                   7,
                   {{0, 1}, {0, 2}, {0, 4}, {0, 6}, {1, 2}, {1, 3}, {1, 5}, {2, 3}, {2, 5}},
                   {0, 1, 2, 4, 5},
                   {0, 1, 4, 5, 2}},
        Regression{"blocked_by_a_subgraph_that_is_planned_later",
                   11,
                   {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 6}, {4, 5}, {4, 7}, {6, 8}, {6, 9}, {9, 10}},
                   {5, 0, 1, 6, 9, 2, 8, 7, 3},
                   {5, 2, 6, 8, 10, 1, 9, 4, 3}}),
    [](const auto &test) { return std::string(test.param.what); });

/// Every connected graph, every number of robots that leaves two vertices free, every set of starts, every
/// arrangement of goals (of the larger graphs, each `stride`-th): solved exactly where brute force can.
void expectExact(std::size_t vertices, std::size_t stride)
{
    Rotator run;
    std::size_t number = 0;
    std::size_t solvable = 0;
    for (const auto &graph : test::connectedGraphs(vertices))
    {
        for (std::size_t robots = 1; robots + 2 <= vertices; ++robots)
        {
            const test::ConfigurationOrbits orbits(*graph, robots, MotionRule::pebble);
            for (const auto &starts : orbits.configurations())
            {
                if (!std::is_sorted(starts.begin(), starts.end()))
                    continue;
                for (const auto &goals : orbits.configurations())
                {
                    if (++number % stride != 0)
                        continue;
                    const Instance instance{graph, starts, goals};
                    if (orbits.of(starts) == orbits.of(goals))
                    {
                        ++solvable;
                        run.expectSolved(instance);
                        ASSERT_EQ(run.fallbacks(), 0);
                    }
                    else
                    {
                        ASSERT_EQ(run(instance), PlannerStatus::infeasible);
                        ASSERT_FALSE(run.reason().empty());
                    }
                    ASSERT_FALSE(testing::Test::HasFailure())
                        << "starts " << testing::PrintToString(instance.starts) << " goals "
                        << testing::PrintToString(instance.goals);
                }
            }
        }
    }
    EXPECT_GT(solvable, number / stride / 2);
}

TEST(PushAndRotate, SolvesExactlyWhatCanBeSolvedOnGraphsOfUpToFiveVertices)
{
    for (const std::size_t vertices : {3U, 4U, 5U})
        expectExact(vertices, 1);
}

TEST(PushAndRotate, SolvesExactlyWhatCanBeSolvedOnASampleOfGraphsOfSixVertices)
{
    expectExact(6, 37);
}

TEST(PushAndRotate, SolvesScrambledGraphsWithFewFreeVertices)
{
    Rotator run;
    for (Seed seed = 1; seed <= 200; ++seed)
    {
        SCOPED_TRACE(seed);
        Random random(seed);
        const std::size_t vertices = 8 + random.below(60);
        const auto graph = test::randomConnectedGraph(vertices, random.below(4), seed);
        const Instance instance = test::randomSolvableInstance(graph, vertices - 2 - random.below(4), seed);
        run.expectSolved(instance, seed);
    }
}

TEST(PushAndRotate, GivesEachComponentItsOwnFreeVertices)
{
    // A star in which three robots exchange, a full triangle at home, a polygon that turns, a path.
    const auto graph = graphOf(20, {{0, 1},
                                    {0, 2},
                                    {0, 3},
                                    {0, 4},
                                    {5, 6},
                                    {6, 7},
                                    {7, 5},
                                    {8, 9},
                                    {9, 10},
                                    {10, 11},
                                    {11, 12},
                                    {12, 8},
                                    {13, 14},
                                    {14, 15},
                                    {15, 16},
                                    {16, 17},
                                    {18, 19}});
    const std::vector<Vertex> starts{1, 2, 3, 5, 6, 7, 8, 9, 11, 13, 14};
    Rotator run;
    run.expectSolved({graph, starts, {2, 3, 1, 5, 6, 7, 10, 12, 8, 16, 17}});
    EXPECT_EQ(run({graph, starts, {2, 3, 1, 5, 6, 7, 8, 11, 9, 16, 17}}), PlannerStatus::infeasible);
    EXPECT_EQ(run({graph, starts, {2, 3, 1, 5, 6, 7, 10, 12, 8, 17, 16}}), PlannerStatus::infeasible);
    EXPECT_EQ(run({graph, {1}, {18}}), PlannerStatus::infeasible);
    EXPECT_NE(run.reason().find("robot 0"), std::string::npos) << run.reason();
}

TEST(PushAndRotate, TurnsPolygonsWithoutLeavingTheOrder)
{
    Rotator run;
    for (std::size_t n = 3; n <= 9; ++n)
    {
        Edges edges;
        for (Vertex v = 0; v < n; ++v)
            edges.emplace_back(v, (v + 1) % n);
        const auto graph = graphOf(n, edges);
        for (std::size_t robots = 1; robots + 2 <= n; ++robots)
        {
            for (Seed seed = 1; seed <= 5; ++seed)
                run.expectSolved(test::randomSolvableInstance(graph, robots, seed));
        }
    }
}

TEST(PushAndRotate, RefusesFewerThanTwoFreeVerticesWhereSomebodyMustMove)
{
    const PushAndRotate planner;
    const auto graph = graphOf(7, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {4, 6}});
    EXPECT_EQ(planner.reasonToReject({graph, {0, 1, 3}, {0, 1, 5}}), std::nullopt);
    const auto reason = planner.reasonToReject({graph, {0, 1, 3}, {1, 2, 3}});
    ASSERT_TRUE(reason);
    EXPECT_NE(reason->find("one_blank"), std::string::npos) << *reason;
    EXPECT_NE(reason->find("robot 0"), std::string::npos) << *reason;
}

TEST(PushAndRotate, IsTheSameForAnyNumberOfThreads)
{
    const Instance instance = smallProblem("connector");
    Rotator first("50", "1");
    Rotator second("50", "4");
    first.expectSolved(instance, 7);
    second.expectSolved(instance, 7);
    EXPECT_EQ(first.solution(), second.solution());
}

TEST(PushAndRotate, KeepsTheBestOfRestartsOnMapsToo)
{
    const Instance instance = randomInstance(test::gridGraph(20, 20), 300, 5);
    Rotator once;
    Rotator often("6");
    once.expectSolved(instance);
    often.expectSolved(instance);
    const RedundancyRemoval removal;
    EXPECT_LE(removal.improve(instance, often.solution(), {}).pathLength(),
              removal.improve(instance, once.solution(), {}).pathLength());
}

} // namespace
} // namespace mrpp
