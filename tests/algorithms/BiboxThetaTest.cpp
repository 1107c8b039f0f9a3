#include "algorithms/BiboxTheta.h"

#include "framework/Problem.h"
#include "tests/algorithms/OneBlankCases.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/RandomCases.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace test; // NOLINT(google-build-using-namespace): its cases

TEST(BiboxTheta, SolvesThetaGraphsOfAllArms)
{
    std::size_t solved = 0;
    for (std::size_t a = 0; a <= 6; ++a)
        for (std::size_t b = std::max<std::size_t>(a, 1); b <= 6; ++b)
            for (std::size_t c = b; c <= 6; ++c)
                for (Seed seed = 1; seed <= 4; ++seed)
                    if (const auto instance = randomPuzzle(thetaGraph({a, b, c}), seed))
                    {
                        ++solved;
                        expectSolved<BiboxTheta>(*instance, "theta " + std::to_string(a) + " " +
                                                                std::to_string(b) + " " + std::to_string(c));
                        if (HasFatalFailure())
                            return;
                    }
    EXPECT_GT(solved, 280U);
    const auto large = randomPuzzle(thetaGraph({12, 1, 18}), 1);
    ASSERT_TRUE(large);
    expectSolved<BiboxTheta>(*large, "theta 12 1 18");
}

TEST(BiboxTheta, SolvesWheelsLaddersPrismsAndCompleteBipartiteGraphs)
{
    std::vector<std::shared_ptr<const Graph>> graphs;
    for (std::size_t n = 3; n <= 12; ++n)
    {
        graphs.push_back(wheel(n));
        graphs.push_back(test::gridGraph(n, 2));
        graphs.push_back(prism(n));
        graphs.push_back(completeBipartite(2, n));
        graphs.push_back(completeBipartite(n, 5));
        graphs.push_back(test::gridGraph(n, n));
    }
    for (std::size_t i = 0; i < graphs.size(); ++i)
        for (Seed seed = 1; seed <= 5; ++seed)
        {
            const auto instance = randomPuzzle(graphs[i], seed);
            ASSERT_TRUE(instance);
            expectSolved<BiboxTheta>(*instance, "graph " + std::to_string(i));
            if (HasFatalFailure())
                return;
        }
}

TEST(BiboxTheta, SolvesRandomBiconnectedGraphsAndRefusesOddPermutations)
{
    std::size_t refused = 0;
    for (Seed seed = 1; seed <= 800; ++seed)
    {
        Random random(seed);
        const auto graph = randomBiconnected(4 + random.below(seed % 10 == 0 ? 150 : 40), random);
        if (!isBiconnectedAndNoCycle(*graph))
            continue;
        const std::string what = "seed " + std::to_string(seed);
        if (const auto instance = randomPuzzle(graph, seed))
            expectSolved<BiboxTheta>(*instance, what);
        if (const auto odd = randomPuzzle(graph, seed, true))
        {
            ++refused;
            const Answer answer = plan<BiboxTheta>(*odd);
            EXPECT_EQ(answer.status, PlannerStatus::infeasible) << what;
            EXPECT_NE(answer.reason.find("odd permutation"), std::string::npos) << answer.reason;
        }
        const Instance roomy = randomInstance(graph, random.below(graph->vertexCount() - 1), seed);
        if (!BiboxTheta().reasonToReject(roomy))
            expectSolved<BiboxTheta>(roomy, what + " with room");
        if (HasFailure())
            return;
    }
    EXPECT_GT(refused, 8U);
}

/// Theta_0 inside of larger graphs must not stand in the way: whatever handle is added to it.
TEST(BiboxTheta, SolvesEveryGraphOfThetaZeroAndALongHandle)
{
    const auto zero = thetaGraph({1, 2, 2});
    for (Vertex x = 0; x < 7; ++x)
        for (Vertex y = x + 1; y < 7; ++y)
            for (const std::size_t inner : {1U, 2U, 3U, 4U, 5U})
                for (Seed seed = 1; seed <= 6; ++seed)
                {
                    auto edges = zero->edges();
                    Vertex last = x;
                    for (Vertex i = 0; i < inner; ++i)
                    {
                        edges.push_back({last, 7 + i});
                        last = 7 + i;
                    }
                    edges.push_back({last, y});
                    const auto graph = Graph::fromEdges(7 + inner, edges);
                    const auto instance = randomPuzzle(graph, seed);
                    ASSERT_TRUE(instance);
                    expectSolved<BiboxTheta>(*instance, "handle " + std::to_string(x) + " to " +
                                                            std::to_string(y) + " of " +
                                                            std::to_string(inner));
                    if (HasFatalFailure())
                        return;
                }
}

TEST(BiboxTheta, SaysWhatItDoesNotTake)
{
    const auto refuse = [](const std::shared_ptr<const Graph> &graph, std::size_t robots)
    { return BiboxTheta().reasonToReject(randomInstance(graph, robots, 1)).value_or(""); };
    EXPECT_EQ(refuse(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}}), 4),
              "the graph is not biconnected: taking vertex 2 away parts it");
    EXPECT_EQ(refuse(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}}), 2), "the graph is not connected");
    EXPECT_NE(refuse(cycleWith(6, {}), 5).find("cycle"), std::string::npos);
    EXPECT_EQ(refuse(test::gridGraph(3, 3), 9), "no vertex is free");
    EXPECT_EQ(refuse(test::gridGraph(3, 3), 8), "");
}

} // namespace
} // namespace mrpp
