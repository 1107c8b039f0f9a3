#include "algorithms/PushAndSpin.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/analysis/LowerBounds.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/ConfigurationOrbits.h"
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
using SpinRun = test::TrailRun<PushAndSpin>;

void expectSolved(const Instance &instance, SpinRun &run, Seed seed = 1)
{
    ASSERT_NO_FATAL_FAILURE(run.expectSolved(instance, seed));
    EXPECT_GE(run.solution().pathLength(), lowerBounds(instance)->pathLength);
}

/// A cycle 0 … n−1.
std::shared_ptr<const Graph> polygon(std::size_t n)
{
    Edges edges;
    for (Vertex v = 0; v < n; ++v)
        edges.emplace_back(v, (v + 1) % n);
    return graphOf(n, edges);
}

struct SpinLimits
{
    std::string problem;
    std::size_t moves;     ///< of the first attempt; far below what was published
    std::size_t actions;   ///< likewise
    std::size_t restarted; ///< moves with 1000 restarts, after redundancy removal
};

class SmallProblemsBySpins : public testing::TestWithParam<SpinLimits>
{};

TEST_P(SmallProblemsBySpins, AreSolvedWithFarFewerMovesThanPublished)
{
    const Instance instance = smallProblem(GetParam().problem);
    SpinRun run;
    expectSolved(instance, run);
    EXPECT_EQ(run.fallbacks(), 0);
    EXPECT_LE(run.solution().pathLength(), GetParam().moves);
    EXPECT_LE(run.solution().actionCount(), GetParam().actions);
}

TEST_P(SmallProblemsBySpins, BecomeShortByRestarts)
{
    const Instance instance = smallProblem(GetParam().problem);
    for (const Seed seed : {1U, 2U})
    {
        SpinRun run("1000");
        expectSolved(instance, run, seed);
        const Solution optimized = RedundancyRemoval().improve(instance, run.solution(), {});
        ASSERT_TRUE(validate(instance, optimized, MotionRule::rotation).valid());
        EXPECT_GE(optimized.pathLength(), lowerBounds(instance)->pathLength);
        EXPECT_LE(optimized.pathLength(), GetParam().restarted);
    }
}

// Published by the authors: moves and actions of tree_with_cycle_leaves 33 and 26, biconnected 361 and 101,
// grid 105 and 75, corners_published 520 and 185, loop_chain 1206 and 327, connector 1318 and 502.
INSTANTIATE_TEST_SUITE_P(
    Published, SmallProblemsBySpins,
    testing::Values(SpinLimits{"tree", 34, 34, 14}, SpinLimits{"tunnel", 167, 167, 53},
                    SpinLimits{"string", 48, 48, 20}, SpinLimits{"corners", 161, 161, 81},
                    SpinLimits{"corners_published", 150, 150, 72}, SpinLimits{"connector", 300, 300, 130},
                    SpinLimits{"loop_chain", 340, 327, 130}, SpinLimits{"tree_with_cycle_leaves", 22, 20, 18},
                    SpinLimits{"biconnected", 90, 90, 60}, SpinLimits{"grid", 80, 75, 56},
                    SpinLimits{"polygon", 6, 6, 6}, SpinLimits{"theta", 12, 12, 8}),
    [](const auto &test) { return test.param.problem; });

/// Every connected graph of that many vertices, every number of robots but one for each vertex, every start,
/// every goal: solved, or proved unsolvable, exactly as brute force says.
/// \param stride takes every so manieth of the instances
void expectExact(std::size_t vertices, std::size_t stride)
{
    SpinRun run;
    std::size_t number = 0;
    std::size_t solvable = 0;
    const RedundancyRemoval removal;
    for (const auto &graph : test::connectedGraphs(vertices))
    {
        for (std::size_t robots = 1; robots < vertices; ++robots)
        {
            const test::ConfigurationOrbits orbits(*graph, robots, MotionRule::rotation);
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
                        expectSolved(instance, run);
                        ASSERT_EQ(run.fallbacks(), 0);
                        const Solution shorter = removal.improve(instance, run.solution(), {});
                        ASSERT_TRUE(validate(instance, shorter, MotionRule::rotation).valid());
                        ASSERT_LE(shorter.pathLength(), run.solution().pathLength());
                    }
                    else
                    {
                        ASSERT_EQ(run(instance), PlannerStatus::infeasible);
                        ASSERT_FALSE(run.reason().empty());
                    }
                    ASSERT_FALSE(testing::Test::HasFailure()) << "starts " << testing::PrintToString(starts)
                                                              << " goals " << testing::PrintToString(goals);
                }
            }
        }
    }
    EXPECT_GT(solvable, number / stride / 2);
}

TEST(PushAndSpin, SolvesExactlyWhatCanBeSolvedOnGraphsOfUpToFiveVertices)
{
    for (const std::size_t vertices : {2U, 3U, 4U, 5U})
        expectExact(vertices, 1);
}

TEST(PushAndSpin, SolvesExactlyWhatCanBeSolvedOnASampleOfGraphsOfSixVertices)
{
    expectExact(6, 61);
}

/// Cycles joined by corridors, hanging like leaves or in a row.
std::shared_ptr<const Graph> cyclesAndCorridors(std::size_t vertices, Seed seed)
{
    Random random(seed);
    Edges edges = {{0, 1}, {1, 2}, {2, 0}};
    Vertex next = 3;
    while (next < vertices)
    {
        Vertex end = static_cast<Vertex>(random.below(next));
        for (std::uint64_t length = random.below(5); length > 0; --length)
        {
            edges.emplace_back(end, next);
            end = next++;
        }
        if (random.below(3) == 0)
            continue;
        const Vertex first = end;
        for (std::uint64_t more = 2 + random.below(4); more > 0; --more)
        {
            edges.emplace_back(end, next);
            end = next++;
        }
        edges.emplace_back(end, first);
    }
    return graphOf(next, edges);
}

TEST(PushAndSpin, SolvesScrambledInstancesWithFewFreeVertices)
{
    SpinRun run;
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        SCOPED_TRACE(seed);
        Random random(seed);
        const std::size_t vertices = 8 + random.below(50);
        const auto graph = seed % 2 == 0 ? test::randomConnectedGraph(vertices, random.below(8), seed)
                                         : cyclesAndCorridors(vertices, seed);
        const std::size_t robots = graph->vertexCount() - 1 - random.below(5);
        expectSolved(test::randomSolvedCaseWithRotations(graph, robots, 20 * vertices, seed).instance, run);
    }
}

TEST(PushAndSpin, TurnsPolygonsEvenFullOnes)
{
    SpinRun run;
    for (const std::size_t n : {3U, 5U, 40U})
    {
        for (const std::size_t robots : {n, n - 1, n - 2})
        {
            std::vector<Vertex> starts;
            std::vector<Vertex> goals;
            for (Vertex v = 0; v < robots; ++v)
            {
                starts.push_back(v);
                goals.push_back(static_cast<Vertex>((v + n / 2) % n));
            }
            expectSolved({polygon(n), starts, goals}, run);
            if (robots < 3)
                continue;
            std::swap(goals[0], goals[1]);
            EXPECT_EQ(run({polygon(n), starts, goals}), PlannerStatus::infeasible);
            EXPECT_NE(run.reason().find("cyclic order"), std::string::npos) << run.reason();
        }
    }
}

TEST(PushAndSpin, RefusesFullComponentsInWhichSomebodyMustMove)
{
    const PushAndSpin planner;
    const auto graph = graphOf(8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {4, 5}, {5, 6}, {5, 7}});
    EXPECT_EQ(planner.reasonToReject({graph, {0, 1, 2, 3, 4}, {0, 1, 2, 3, 6}}), std::nullopt);
    const auto reason = planner.reasonToReject({graph, {0, 1, 2, 3, 4}, {1, 2, 3, 0, 4}});
    ASSERT_TRUE(reason);
    EXPECT_NE(reason->find("robot 0"), std::string::npos) << *reason;
}

TEST(PushAndSpin, SaysWhyNobodyCanPass)
{
    // Two triangles and a corridor of two edges between them: one free vertex is too few.
    const auto graph = graphOf(7, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 4}});
    SpinRun run;
    EXPECT_EQ(run({graph, {0, 1, 2, 3, 4, 5}, {4, 1, 2, 3, 0, 5}}), PlannerStatus::infeasible);
    EXPECT_NE(run.reason().find("robot"), std::string::npos) << run.reason();
    expectSolved({graph, {0, 1, 2, 3, 5}, {5, 1, 2, 3, 0}}, run);
}

TEST(PushAndSpin, IsTheSameForAnyNumberOfThreads)
{
    const Instance instance = smallProblem("connector");
    SpinRun first("50", "1");
    SpinRun second("50", "4");
    expectSolved(instance, first, 7);
    expectSolved(instance, second, 7);
    EXPECT_EQ(first.solution(), second.solution());
}

/// One free vertex on a grid: everything is far away, and every search is long.
TEST(PushAndSpin, StopsAtItsLimit)
{
    const Instance instance = randomInstance(test::gridGraph(120, 120), 120 * 120 - 1, 3);
    PushAndSpin planner;
    planner.setInstance(std::make_shared<Instance>(instance));
    planner.setup();
    for (const double limit : {0.001, 0.01, 0.1, 0.3})
    {
        test::PollWatch watch(limit);
        EXPECT_EQ(planner.solve(TerminationCondition::when([&watch] { return watch.poll(); })),
                  PlannerStatus::timeout);
        watch.poll();
        EXPECT_LT(watch.longest(), test::kPromptly) << "limit of " << limit << " s";
        EXPECT_TRUE(planner.solution().empty());
    }
}

} // namespace
} // namespace mrpp
