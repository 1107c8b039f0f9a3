#include "algorithms/OneBlank.h"

#include "framework/Problem.h"
#include "tests/algorithms/OneBlankCases.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/BruteForce.h"
#include "tests/support/PollWatch.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace test; // NOLINT(google-build-using-namespace): its cases

/// The graphs joined in a row, each by one vertex to the next.
std::shared_ptr<const Graph> necklace(const std::vector<std::shared_ptr<const Graph>> &pearls, Random &random)
{
    std::vector<Graph::Edge> edges;
    Vertex count = 1;
    for (const auto &pearl : pearls)
    {
        const auto shared = static_cast<Vertex>(random.below(pearl->vertexCount()));
        const auto joint = static_cast<Vertex>(random.below(count));
        const auto name = [&](Vertex v) { return v == shared ? joint : count + v - (v > shared ? 1 : 0); };
        for (const auto &edge : pearl->edges())
            edges.push_back({name(edge.a), name(edge.b)});
        count += static_cast<Vertex>(pearl->vertexCount()) - 1;
    }
    return Graph::fromEdges(count, edges);
}

TEST(OneBlank, SolvesNecklacesOfScrambledBlocks)
{
    for (Seed seed = 1; seed <= 150; ++seed)
    {
        Random random(seed);
        std::vector<std::shared_ptr<const Graph>> pearls;
        for (std::size_t i = 2 + random.below(6); i > 0; --i)
        {
            switch (random.below(6))
            {
            case 0:
                pearls.push_back(cycleWith(3 + random.below(6), {}));
                break;
            case 1:
                pearls.push_back(Graph::fromEdges(2, {{0, 1}}));
                break;
            case 2:
                pearls.push_back(thetaGraph({1, 2, 2}));
                break;
            case 3:
                pearls.push_back(test::gridGraph(2 + random.below(3), 3));
                break;
            case 4:
                pearls.push_back(wheel(3 + random.below(6)));
                break;
            default:
                pearls.push_back(randomBiconnected(4 + random.below(20), random));
                break;
            }
        }
        const auto graph = necklace(pearls, random);
        const Instance instance = scrambled(graph, 5000, seed);
        expectSolved<OneBlank>(instance, "seed " + std::to_string(seed));
        if (HasFatalFailure())
            return;
    }
}

TEST(OneBlank, SolvesTreesAndSparseGraphs)
{
    for (Seed seed = 1; seed <= 500; ++seed)
    {
        Random random(seed);
        const std::size_t vertices = 2 + random.below(150);
        const auto graph = test::randomConnectedGraph(vertices, random.below(30), seed);
        expectSolved<OneBlank>(scrambled(graph, 3000, seed), "seed " + std::to_string(seed));
        if (HasFatalFailure())
            return;
    }
}

/// Each reason, on the smallest graph that has it; brute force agrees.
TEST(OneBlank, SaysWhyThereIsNoSolution)
{
    struct Case
    {
        std::shared_ptr<const Graph> graph;
        std::vector<Vertex> starts;
        std::vector<Vertex> goals;
        std::string reason;
    };
    const std::vector<Case> cases = {
        {Graph::fromEdges(3, {{0, 1}, {1, 2}}), {0, 2}, {2, 0}, "cut vertex 1"},
        {cycleWith(4, {}), {0, 1, 2}, {1, 0, 2}, "the cycle of vertices 0, 1, 2, 3"},
        {test::gridGraph(3, 2), {0, 1, 2, 3, 4}, {1, 0, 2, 3, 4}, "odd permutation"},
        {thetaGraph({1, 2, 2}), {0, 1, 2, 3, 4, 5}, {1, 0, 2, 3, 4, 5}, "theta_0"},
        {Graph::fromEdges(3, {{0, 1}}), {0}, {2}, "no path leads robot 0"},
        {Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}}), {0, 1, 2}, {1, 2, 0}, "no vertex of its component"},
    };
    for (const Case &c : cases)
    {
        const Instance instance{c.graph, c.starts, c.goals};
        const Answer answer = plan<OneBlank>(instance);
        EXPECT_EQ(answer.status, PlannerStatus::infeasible);
        EXPECT_NE(answer.reason.find(c.reason), std::string::npos) << answer.reason;
        EXPECT_FALSE(test::isSolvable(instance, MotionRule::pebble));
    }
}

TEST(OneBlank, LeavesMoreRoomToPushAndRotate)
{
    Instance instance = randomInstance(test::gridGraph(3, 3), 7, 1);
    EXPECT_NE(OneBlank().reasonToReject(instance).value_or("").find("push_and_rotate"), std::string::npos);
    instance.goals = instance.starts;
    EXPECT_FALSE(OneBlank().reasonToReject(instance));
    EXPECT_TRUE(plan<OneBlank>(instance).solution.empty());
}

TEST(OneBlank, SolvesEachComponentWithItsOwnBlank)
{
    // Two 3 × 2 grids, and a full one in which nobody has to move.
    std::vector<Graph::Edge> edges;
    for (const Vertex first : {0U, 6U, 12U})
        for (const auto &edge : test::gridGraph(3, 2)->edges())
            edges.push_back({edge.a + first, edge.b + first});
    const auto graph = Graph::fromEdges(18, edges);
    const Instance instance{graph,
                            {0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 12, 13, 14, 15, 16, 17},
                            {1, 2, 0, 3, 4, 6, 7, 9, 10, 8, 12, 13, 14, 15, 16, 17}};
    expectSolved<OneBlank>(instance, "three components");
}

TEST(OneBlank, FindsShortestSolutionsOfSmallBlocks)
{
    for (Seed seed = 1; seed <= 20; ++seed)
    {
        const auto instance = randomPuzzle(test::gridGraph(4, 2), seed);
        ASSERT_TRUE(instance);
        EXPECT_EQ(plan<OneBlank>(*instance).solution.pathLength(), *test::fewestMoves(*instance));
    }
}

TEST(OneBlank, NeedsFewMovesOnGrids)
{
    // About 2.2 K^3 moves, on average of ten instances.
    for (const auto &[side, most] : {std::pair<std::size_t, std::size_t>{4, 110}, {6, 480}, {10, 2500}})
    {
        std::size_t moves = 0;
        for (Seed seed = 1; seed <= 10; ++seed)
            moves += plan<OneBlank>(*randomPuzzle(test::gridGraph(side, side), seed)).solution.pathLength();
        EXPECT_LT(moves / 10, most) << side;
    }
    const auto instance = randomPuzzle(test::gridGraph(5, 5), 1);
    EXPECT_LT(plan<OneBlank>(*instance, {{"restarts", "100"}}).solution.pathLength(),
              plan<OneBlank>(*instance).solution.pathLength());
}

TEST(OneBlank, GivesTheSameSolutionOnAnyNumberOfThreads)
{
    const auto instance = randomPuzzle(test::gridGraph(6, 6), 1);
    const Answer one = plan<OneBlank>(*instance, {{"restarts", "20"}, {"threads", "1"}});
    const Answer three = plan<OneBlank>(*instance, {{"restarts", "20"}, {"threads", "3"}});
    EXPECT_EQ(one.solution, three.solution);
}

TEST(OneBlank, StopsWithinFiftyMilliseconds)
{
    const std::vector<std::shared_ptr<const Graph>> graphs = {
        test::gridGraph(40, 40), test::gridGraph(300, 300), thetaGraph({20, 21, 30}), cycleWith(20000, {}),
        cycleWith(30000, {{0, 15000}})};
    for (std::size_t i = 0; i < graphs.size(); ++i)
    {
        const Instance instance = i < 2 ? *randomPuzzle(graphs[i], 1) : scrambled(graphs[i], 300000, 1);
        for (const double limit : {0.001, 0.01, 0.1, 0.4})
        {
            OneBlank planner;
            planner.setInstance(std::make_shared<Instance>(instance));
            planner.setup();
            PollWatch watch(limit);
            const PlannerStatus status =
                planner.solve(TerminationCondition::when([&watch] { return watch.poll(); }));
            watch.poll();
            EXPECT_TRUE(status == PlannerStatus::timeout || status == PlannerStatus::solved);
            EXPECT_LT(watch.longest(), kPromptly) << "graph " << i << " limit " << limit;
        }
    }
}

} // namespace
} // namespace mrpp
