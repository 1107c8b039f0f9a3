#include "framework/analysis/LowerBounds.h"
#include "framework/Problem.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "tests/support/RandomCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

/// Distances by trying all edges as often as there are vertices.
std::vector<std::uint32_t> distancesFrom(const Graph &graph, Vertex source)
{
    std::vector<std::uint32_t> distance(graph.vertexCount(), kUnreachable);
    distance[source] = 0;
    for (std::size_t round = 0; round < graph.vertexCount(); ++round)
    {
        for (const Graph::Edge &edge : graph.edges())
        {
            if (distance[edge.a] != kUnreachable)
                distance[edge.b] = std::min(distance[edge.b], distance[edge.a] + 1);
            if (distance[edge.b] != kUnreachable)
                distance[edge.a] = std::min(distance[edge.a], distance[edge.b] + 1);
        }
    }
    return distance;
}

/// A random graph of one or two components.
std::shared_ptr<const Graph> halves(Seed seed)
{
    std::vector<Graph::Edge> edges;
    for (const Graph::Edge &edge : test::randomConnectedGraph(9, 3, seed)->edges())
        edges.push_back(edge);
    for (const Graph::Edge &edge : test::randomConnectedGraph(7, 2, seed + 1)->edges())
        edges.push_back({edge.a + 9, edge.b + 9});
    if (seed % 2 == 0)
        edges.push_back({4, 11});
    return Graph::fromEdges(16, edges);
}

TEST(BreadthFirstSearch, FindsAllDistancesRunAfterRun)
{
    for (Seed seed = 0; seed < 20; ++seed)
    {
        const auto graph = halves(seed);
        BreadthFirstSearch search(*graph);
        for (Vertex source = 0; source < graph->vertexCount(); ++source)
        {
            const auto expected = distancesFrom(*graph, source);
            search.run(source);
            for (Vertex v = 0; v < graph->vertexCount(); ++v)
            {
                EXPECT_EQ(search.distance(v), expected[v]);
                EXPECT_EQ(search.reached(v), expected[v] != kUnreachable);
            }
        }
    }
}

TEST(BreadthFirstSearch, ListsVerticesNearestFirst)
{
    const auto graph = test::gridGraph(3, 3);
    BreadthFirstSearch search(*graph);
    search.run(0);
    EXPECT_THAT(search.order(), ElementsAre(0, 1, 3, 2, 4, 6, 5, 7, 8));
}

TEST(BreadthFirstSearch, StopsAtTheTarget)
{
    const auto graph = test::gridGraph(10, 10);
    BreadthFirstSearch search(*graph);
    search.run(0, 11);
    EXPECT_EQ(search.distance(11), 2U);
    EXPECT_FALSE(search.reached(99));
    EXPECT_LT(search.order().size(), 7U);
    search.run(5, 5);
    EXPECT_THAT(search.order(), ElementsAre(5));
}

TEST(BreadthFirstSearch, ShowsAShortestPath)
{
    const auto graph = test::gridGraph(3, 3);
    BreadthFirstSearch search(*graph);
    search.run(0);
    EXPECT_THAT(search.path(8), ElementsAre(0, 1, 2, 5, 8));
    EXPECT_THAT(search.path(0), ElementsAre(0));
}

TEST(LowerBounds, AreTheSumAndTheLargestOfTheDistances)
{
    const Instance instance{test::gridGraph(4, 3), {0, 5, 3}, {11, 6, 3}};
    const auto bounds = lowerBounds(instance);
    ASSERT_TRUE(bounds);
    EXPECT_EQ(bounds->pathLength, 6U); // 5 + 1 + 0
    EXPECT_EQ(bounds->makespan, 5U);
}

TEST(LowerBounds, AreNothingWhereAGoalCannotBeReached)
{
    const auto graph = Graph::fromEdges(4, {{0, 1}, {2, 3}});
    EXPECT_FALSE(lowerBounds({graph, {0, 2}, {1, 1}}).has_value());
    EXPECT_FALSE(lowerBounds({Graph::fromEdges(2, {}), {0}, {1}}).has_value());
    EXPECT_TRUE(lowerBounds({graph, {0, 2}, {1, 3}}).has_value());
}

TEST(LowerBounds, WithoutRobotsAreZero)
{
    const auto bounds = lowerBounds({Graph::fromEdges(0, {}), {}, {}});
    ASSERT_TRUE(bounds);
    EXPECT_EQ(bounds->pathLength, 0U);
    EXPECT_EQ(bounds->makespan, 0U);
}

TEST(LowerBounds, AgreeWithOneSearchForEachPair)
{
    for (Seed seed = 0; seed < 20; ++seed)
    {
        const auto graph = halves(seed);
        for (Vertex a = 0; a < graph->vertexCount(); ++a)
        {
            const auto expected = distancesFrom(*graph, a);
            for (Vertex b = 0; b < graph->vertexCount(); ++b)
            {
                const auto bounds = lowerBounds({graph, {a}, {b}});
                EXPECT_EQ(bounds ? bounds->makespan : kUnreachable, expected[b]);
            }
        }
    }
}

TEST(LowerBounds, TakeTheDistancesOfAllRobotsTogether)
{
    for (Seed seed = 0; seed < 20; ++seed)
    {
        const auto graph = test::randomConnectedGraph(60, 25, seed);
        const Instance instance = test::randomSolvableInstance(graph, 30, seed);
        std::uint64_t sum = 0;
        std::uint64_t largest = 0;
        for (Robot robot = 0; robot < 30; ++robot)
        {
            const std::uint64_t distance =
                distancesFrom(*graph, instance.starts[robot])[instance.goals[robot]];
            sum += distance;
            largest = std::max(largest, distance);
        }
        const auto bounds = lowerBounds(instance);
        ASSERT_TRUE(bounds);
        EXPECT_EQ(bounds->pathLength, sum);
        EXPECT_EQ(bounds->makespan, largest);
    }
}

Instance gridInstance(std::size_t side, std::size_t robots, Seed seed)
{
    return randomInstance(test::gridGraph(side, side), robots, seed);
}

TEST(LowerBounds, AreTheSameForFewRobotsAndForMany)
{
    for (Seed seed = 0; seed < 30; ++seed)
    {
        Random random(seed);
        const std::size_t vertices = 40 + random.below(100);
        const auto graph = test::randomConnectedGraph(vertices, random.below(vertices), seed);
        const Instance instance = randomInstance(graph, vertices / 2, seed);
        LowerBounds expected;
        BreadthFirstSearch search(*graph);
        for (Robot r = 0; r < instance.robotCount(); ++r)
        {
            search.run(instance.starts[r]);
            expected.pathLength += search.distance(instance.goals[r]);
            expected.makespan =
                std::max<std::uint64_t>(expected.makespan, search.distance(instance.goals[r]));
        }
        const auto bounds = lowerBounds(instance);
        ASSERT_TRUE(bounds);
        EXPECT_EQ(bounds->means, BoundMeans::distances);
        EXPECT_EQ(bounds->pathLength, expected.pathLength);
        EXPECT_EQ(bounds->makespan, expected.makespan);
    }
}

TEST(LowerBounds, ComeFromLandmarksWhereDistancesWouldNeedTooManyVisits)
{
    const Instance instance = gridInstance(60, 400, 3);
    const auto exact = lowerBounds(instance);
    const auto bounds = lowerBounds(instance, {}, 1000);
    ASSERT_TRUE(exact && bounds);
    EXPECT_EQ(bounds->means, BoundMeans::landmarks);
    EXPECT_STREQ(toString(bounds->means), "landmarks");
    EXPECT_LE(bounds->pathLength, exact->pathLength);
    EXPECT_GE(bounds->pathLength, exact->pathLength * 9 / 10);
    EXPECT_LE(bounds->makespan, exact->makespan);
}

TEST(LowerBounds, CountThoseWhoAreNotAtHomeWhereThereIsNoTime)
{
    const Instance instance{test::gridGraph(4, 3), {0, 5, 3}, {11, 6, 3}};
    const auto bounds = lowerBounds(instance, {.stop = TerminationCondition::after(0)});
    ASSERT_TRUE(bounds);
    EXPECT_EQ(bounds->means, BoundMeans::displaced);
    EXPECT_EQ(bounds->pathLength, 2U);
    EXPECT_EQ(bounds->makespan, 1U);
}

TEST(LowerBounds, AreBoundsHoweverEarlyTheyAreStopped)
{
    const Instance instance = gridInstance(30, 200, 5);
    const auto exact = lowerBounds(instance);
    for (std::size_t looks = 1; looks < 240; looks += 7)
    {
        std::size_t left = looks;
        const auto stop = TerminationCondition::when([&left] { return left == 0 || --left == 0; });
        const auto bounds = lowerBounds(instance, {.stop = stop});
        ASSERT_TRUE(bounds);
        EXPECT_LE(bounds->pathLength, exact->pathLength);
        EXPECT_LE(bounds->makespan, exact->makespan);
        EXPECT_GE(bounds->makespan, 1U);
    }
}

TEST(LowerBounds, TellTheListenerHowManyRobotsAreDone)
{
    std::size_t most = 0;
    const auto listener = [&most](std::string_view work, std::size_t done, std::size_t total)
    {
        EXPECT_EQ(work, "lower bounds");
        EXPECT_EQ(total, 200U);
        most = std::max(most, done);
    };
    (void)lowerBounds(gridInstance(30, 200, 5), {.listener = listener});
    EXPECT_EQ(most, 199U);
}

} // namespace
} // namespace mrpp
