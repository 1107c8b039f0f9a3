#include "algorithms/PushAndSwap.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/evaluation/Validator.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/BruteForce.h"
#include "tests/support/RandomCases.h"

#include <chrono>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using test::Answer;
using test::smallProblem;

Answer plan(const Instance &instance, double seconds = 60, const test::PlannerSettings &settings = {})
{
    return test::plan<PushAndSwap>(instance, settings, seconds);
}

struct Limits
{
    std::string problem;
    std::size_t fewest;    ///< exact optimum, or a lower bound
    std::size_t most;      ///< what was published, or measured for another planner
    std::size_t optimized; ///< at most so many moves after redundancy removal
};

class SmallProblems : public testing::TestWithParam<Limits>
{};

TEST_P(SmallProblems, AreSolvedWithNoMoreMovesThanPublished)
{
    const Instance instance = smallProblem(GetParam().problem);
    const Answer answer = plan(instance);
    ASSERT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
    ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
    EXPECT_GE(answer.solution.pathLength(), GetParam().fewest);
    EXPECT_LE(answer.solution.pathLength(), GetParam().most);
    const Solution optimized = RedundancyRemoval().improve(instance, answer.solution, {});
    ASSERT_TRUE(validate(instance, optimized, MotionRule::pebble).valid());
    EXPECT_GE(optimized.pathLength(), GetParam().fewest);
    EXPECT_LE(optimized.pathLength(), GetParam().optimized);
}

INSTANTIATE_TEST_SUITE_P(Published, SmallProblems,
                         testing::Values(Limits{"tree", 12, 38, 38}, Limits{"tunnel", 49, 167, 167},
                                         Limits{"string", 20, 48, 48}, Limits{"corners", 55, 161, 161},
                                         Limits{"corners_published", 50, 520, 520},
                                         Limits{"connector", 60, 1318, 1278},
                                         Limits{"loop_chain", 98, 1206, 1206},
                                         Limits{"biconnected", 25, 361, 361}, Limits{"grid", 30, 105, 105},
                                         Limits{"polygon", 6, 6, 6}, Limits{"theta", 4, 40, 40}),
                         [](const auto &test) { return test.param.problem; });

TEST(PushAndSwap, GivesUpHonestlyWhereOnlyRotationsHelp)
{
    const Answer answer = plan(smallProblem("tree_with_cycle_leaves"));
    EXPECT_EQ(answer.status, PlannerStatus::gave_up);
    EXPECT_NE(answer.reason.find("robot"), std::string::npos) << answer.reason;
    EXPECT_TRUE(answer.solution.empty());
}

struct Regression
{
    const char *what;
    std::size_t vertices;
    std::vector<std::pair<Vertex, Vertex>> edges;
    std::vector<Vertex> starts;
    std::vector<Vertex> goals;
};

class Regressions : public testing::TestWithParam<Regression>
{};

TEST_P(Regressions, AreSolvedAtTheFirstAttempt)
{
    const Regression &c = GetParam();
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b] : c.edges)
        edges.push_back({a, b});
    const Instance instance{Graph::fromEdges(c.vertices, edges), c.starts, c.goals};
    const Answer answer = plan(instance, 60, {{"attempts", "1"}});
    ASSERT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
    EXPECT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
}

// Instances on which printed versions of Push and Swap or Push and Rotate fail.
INSTANTIATE_TEST_SUITE_P(
    Known, Regressions,
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
        Regression{"arrived_robots_must_be_pushed",
                   11,
                   {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 6}, {4, 5}, {4, 7}, {6, 8}, {6, 9}, {9, 10}},
                   {5, 0, 1, 6, 9, 2, 8, 7, 3},
                   {5, 2, 6, 8, 10, 1, 9, 4, 3}}),
    [](const auto &test) { return std::string(test.param.what); });

/// Every connected graph of up to five vertices, every number of robots that leaves two vertices free, every
/// start and every goal that brute force can reach: solved, legally, with no fewer moves than the optimum.
TEST(PushAndSwap, SolvesEverySolvableInstanceOfUpToFiveVertices)
{
    std::size_t instances = 0;
    for (std::size_t n = 3; n <= 5; ++n)
    {
        std::vector<Graph::Edge> all;
        for (Vertex a = 0; a < n; ++a)
            for (Vertex b = a + 1; b < n; ++b)
                all.push_back({a, b});
        // Every fourth edge set: each graph comes in many numberings, so that every shape is met.
        for (std::uint32_t mask = 1; mask < (1U << all.size()); mask += n < 5 ? 1 : 4)
        {
            std::vector<Graph::Edge> edges;
            for (std::size_t i = 0; i < all.size(); ++i)
                if ((mask >> i & 1U) != 0)
                    edges.push_back(all[i]);
            const auto graph = Graph::fromEdges(n, edges);
            for (std::size_t robots = 2; robots + 2 <= n; ++robots)
            {
                for (Seed seed = 0; seed < 6; ++seed)
                {
                    const Instance instance =
                        test::randomSolvableInstance(graph, robots, deriveSeed(seed, mask));
                    ++instances;
                    const Answer answer = plan(instance);
                    ASSERT_EQ(answer.status, PlannerStatus::solved)
                        << "n " << n << " mask " << mask << " seed " << seed;
                    ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
                    ASSERT_GE(answer.solution.pathLength(), *test::fewestMoves(instance));
                }
            }
        }
    }
    EXPECT_GT(instances, 1000U);
}

TEST(PushAndSwap, SolvesScrambledSparseGraphsWithFewFreeVertices)
{
    for (Seed seed = 1; seed <= 400; ++seed)
    {
        Random random(seed);
        const auto vertices = static_cast<std::size_t>(8 + random.below(60));
        const auto graph = test::randomConnectedGraph(vertices, random.below(4), seed);
        const Instance instance = test::randomSolvableInstance(graph, vertices - 2 - random.below(4), seed);
        const Answer answer = plan(instance);
        ASSERT_EQ(answer.status, PlannerStatus::solved) << "seed " << seed << ": " << answer.reason;
        ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
    }
}

/// Dense maps with obstacles, in random order: swaps, resolves and setbacks of many robots at once.
TEST(PushAndSwap, StaysLegalOnDenseMaps)
{
    std::size_t solved = 0;
    for (Seed seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        const std::size_t width = 4 + random.below(10);
        const std::size_t height = 3 + random.below(10);
        const double obstacles = 0.4 * random.uniform();
        std::vector<Vertex> cell(width * height, kNoVertex);
        Vertex cells = 0;
        for (Vertex &c : cell)
            if (random.uniform() >= obstacles)
                c = cells++;
        std::vector<Graph::Edge> edges;
        for (std::size_t i = 0; i < cell.size(); ++i)
        {
            if (cell[i] == kNoVertex)
                continue;
            if ((i + 1) % width != 0 && cell[i + 1] != kNoVertex)
                edges.push_back({cell[i], cell[i + 1]});
            if (i + width < cell.size() && cell[i + width] != kNoVertex)
                edges.push_back({cell[i], cell[i + width]});
        }
        const auto graph = Graph::fromEdges(cells, edges);
        const Components components(*graph);
        const std::size_t room = cells == 0 ? 0 : components.size(components.largest());
        const auto robots =
            static_cast<std::size_t>((0.5 + 0.5 * random.uniform()) * static_cast<double>(room));
        const Instance instance = randomInstance(graph, robots, seed);
        const Answer answer = plan(instance, 5, {{"order", "random"}, {"attempts", "3"}});
        if (answer.status != PlannerStatus::solved)
            continue;
        ++solved;
        const Verdict verdict = validate(instance, answer.solution, MotionRule::pebble);
        ASSERT_TRUE(verdict.valid()) << "seed " << seed << ": " << verdict.violation;
    }
    EXPECT_GT(solved, 500U);
}

TEST(PushAndSwap, IsDeterministic)
{
    const Instance instance = randomInstance(test::gridGraph(20, 20), 300, 5);
    for (const char *order : {"far_first", "given", "random"})
    {
        const Answer first = plan(instance, 60, {{"order", order}});
        const Answer second = plan(instance, 60, {{"order", order}});
        ASSERT_EQ(first.status, PlannerStatus::solved);
        EXPECT_EQ(first.solution, second.solution);
        EXPECT_TRUE(validate(instance, first.solution, MotionRule::pebble).valid());
    }
}

TEST(PushAndSwap, StopsAtItsDeadline)
{
    const Instance instance = randomInstance(test::gridGraph(150, 150), 150 * 150 - 2, 3);
    const auto start = std::chrono::steady_clock::now();
    const Answer answer = plan(instance, 0.2);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(answer.status, PlannerStatus::timeout);
    EXPECT_LT(seconds.count(), 1.0);
}

} // namespace
} // namespace mrpp
