/// \file
/// The oracle's time, in breadth-first searches of the same graph.

#include "framework/Problem.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/Solvability.h"
#include "problems/formats/MovingAiMap.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr bool kMeasure = false;
#else
constexpr bool kMeasure = true;
#endif

/// The best of a few tries on either side: other work on the machine only ever makes them slower.
double searchesFor(const Instance &instance, MotionRule rule, bool solvable)
{
    BreadthFirstSearch search(*instance.graph);
    double fastestSearch = 1e9;
    double fastestAnswer = 1e9;
    for (int i = 0; i < (kMeasure ? 5 : 1); ++i)
    {
        double start = test::cpuSeconds();
        search.run(instance.starts[0]);
        fastestSearch = std::min(fastestSearch, test::cpuSeconds() - start);
        start = test::cpuSeconds();
        const Solvability answer = solvability(instance, rule);
        fastestAnswer = std::min(fastestAnswer, test::cpuSeconds() - start);
        EXPECT_EQ(answer.solvable, solvable) << answer.reason;
    }
    ::testing::Test::RecordProperty("searches", std::to_string(fastestAnswer / fastestSearch));
    return kMeasure ? fastestAnswer / fastestSearch : 0;
}

TEST(SolvabilityScale, AMapWithThousandsOfRobotsTakesTwoHundredSearches)
{
    const auto file = std::filesystem::path(MRPP_SHARED_DATA) / "movingai/bg512/AR0603SR.map";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no map " << file;
    const Instance instance = randomInstance(readMovingAiMap(file).graph, 3000, 1);
    for (const MotionRule rule : {MotionRule::pebble, MotionRule::rotation})
        EXPECT_LE(searchesFor(instance, rule, true), 200);
}

TEST(SolvabilityScale, ALongPathFullOfRobotsIsNoWorse)
{
    // Half of the vertices are occupied, at first on the left, in the end on the right.
    constexpr Vertex kLength = kMeasure ? 1'000'000 : 50'000;
    std::vector<Graph::Edge> edges;
    for (Vertex v = 1; v < kLength; ++v)
        edges.push_back({v - 1, v});
    Instance instance{Graph::fromEdges(kLength, edges), {}, {}};
    for (Vertex v = 0; v < kLength / 2; ++v)
    {
        instance.starts.push_back(v);
        instance.goals.push_back(v + kLength / 2);
    }
    EXPECT_LE(searchesFor(instance, MotionRule::pebble, true), 300);
    std::swap(instance.goals.front(), instance.goals.back());
    EXPECT_LE(searchesFor(instance, MotionRule::rotation, false), 300);
}

TEST(SolvabilityScale, ATreeThatIsNearlyFullIsNoWorse)
{
    constexpr std::size_t kVertices = kMeasure ? 100'000 : 20'000;
    const auto graph = test::randomConnectedGraph(kVertices, 0, 1);
    for (const std::size_t free : {1U, 3U})
    {
        Instance instance = randomInstance(graph, kVertices - free, 1);
        EXPECT_LE(searchesFor(instance, MotionRule::pebble, false), 300);
    }
}

} // namespace
} // namespace mrpp
