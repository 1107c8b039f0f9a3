#include "problems/SmallBenchmark.h"

#include "framework/support/Error.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using Edges = std::vector<std::pair<Vertex, Vertex>>;

struct Expected
{
    const char *name;
    std::size_t vertices;
    Edges edges;
    std::vector<Vertex> starts;
    std::vector<Vertex> goals;
};

const std::vector<Expected> kExpected = {
    {"tree", 7, {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {4, 5}, {4, 6}}, {1, 4, 6}, {6, 1, 4}},
    {"tunnel",
     9,
     {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {4, 8}, {5, 6}, {6, 7}},
     {0, 1, 2, 4},
     {3, 2, 1, 0}},
    {"string",
     11,
     {{0, 3}, {1, 5}, {2, 3}, {2, 8}, {3, 4}, {4, 5}, {4, 9}, {5, 6}, {6, 7}, {6, 10}},
     {8, 0, 9, 1, 10},
     {0, 9, 1, 10, 8}},
    {"corners",
     12,
     {{0, 4}, {1, 2}, {1, 5}, {2, 3}, {3, 4}, {3, 6}, {5, 8}, {6, 10}, {7, 8}, {7, 11}, {8, 9}, {9, 10}},
     {11, 4, 0, 7, 5, 8, 9},
     {0, 7, 11, 4, 5, 3, 8}},
    {"corners_published",
     12,
     {{0, 1}, {1, 2}, {2, 3}, {2, 9}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {6, 10}, {7, 8}, {8, 9}, {10, 11}},
     {11, 4, 0, 7, 5, 8, 9},
     {0, 7, 11, 4, 5, 3, 8}},
    {"connector",
     18,
     {{0, 1},
      {0, 3},
      {1, 2},
      {2, 4},
      {3, 5},
      {4, 7},
      {5, 6},
      {5, 9},
      {6, 7},
      {8, 9},
      {8, 12},
      {10, 11},
      {10, 13},
      {11, 12},
      {12, 14},
      {13, 15},
      {14, 17},
      {15, 16},
      {16, 17}},
     {15, 2, 13, 4, 16, 1, 3, 0, 10, 11},
     {2, 15, 9, 8, 5, 12, 3, 0, 10, 11}},
    {"loop_chain",
     9,
     {{0, 1}, {0, 3}, {1, 2}, {2, 4}, {3, 5}, {4, 7}, {5, 6}, {6, 7}, {7, 8}},
     {0, 3, 5, 6, 7, 4, 2},
     {2, 4, 7, 6, 5, 3, 0}},
    {"tree_with_cycle_leaves",
     10,
     {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {7, 9}, {8, 9}},
     {1, 2, 5, 8},
     {2, 6, 5, 9}},
    {"biconnected",
     13,
     {{0, 1},
      {0, 3},
      {0, 4},
      {1, 2},
      {1, 8},
      {2, 3},
      {2, 6},
      {3, 12},
      {4, 5},
      {4, 7},
      {5, 6},
      {6, 9},
      {6, 11},
      {7, 8},
      {7, 10},
      {9, 10},
      {11, 12}},
     {0, 1, 2, 3, 4, 5, 6, 8, 10, 11, 12},
     {6, 2, 3, 5, 1, 8, 9, 4, 0, 12, 10}},
    {"theta", 7, {{0, 1}, {0, 5}, {0, 6}, {1, 2}, {2, 3}, {3, 4}, {3, 6}, {4, 5}}, {2, 5}, {5, 2}},
    {"grid",
     15,
     {{0, 1}, {0, 5},  {1, 2}, {1, 6},  {2, 3}, {2, 7},  {3, 4},  {3, 8},   {4, 9},   {5, 6},   {5, 10},
      {6, 7}, {6, 11}, {7, 8}, {7, 12}, {8, 9}, {8, 13}, {9, 14}, {10, 11}, {11, 12}, {12, 13}, {13, 14}},
     {3, 4, 14, 9, 13, 7, 1, 5, 11, 2, 10},
     {5, 0, 13, 11, 1, 3, 8, 10, 7, 2, 12}},
    {"polygon", 6, {{0, 1}, {0, 5}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}, {0, 5}, {5, 0}},
};

std::unique_ptr<SmallBenchmark> configured(const std::string &name)
{
    auto problem = std::make_unique<SmallBenchmark>();
    problem->configure(Config::scalar(name, {"plan.yaml", 3, 5}), {});
    return problem;
}

class SmallProblem : public testing::TestWithParam<Expected>
{};

TEST_P(SmallProblem, HasThePublishedGraphStartsAndGoals)
{
    const Expected &expected = GetParam();
    const auto problem = configured(expected.name);
    EXPECT_EQ(problem->name(), expected.name);
    const auto graph = problem->makeGraph(1);
    EXPECT_EQ(graph->vertexCount(), expected.vertices);
    Edges edges;
    for (const Graph::Edge &edge : graph->edges())
        edges.emplace_back(edge.a, edge.b);
    EXPECT_EQ(edges, expected.edges);
    EXPECT_EQ(problem->robotCount(*graph), expected.starts.size());

    const Instance instance = problem->makeInstance(graph, expected.starts.size(), 7);
    EXPECT_EQ(instance.graph, graph);
    EXPECT_EQ(instance.starts, expected.starts);
    EXPECT_EQ(instance.goals, expected.goals);
    EXPECT_EQ(instance.defect(), std::nullopt);
}

TEST_P(SmallProblem, IsDrawnWithoutOverlaps)
{
    const auto graph = configured(GetParam().name)->makeGraph(1);
    ASSERT_TRUE(graph->hasCoordinates());
    for (Vertex a = 0; a < graph->vertexCount(); ++a)
        for (Vertex b = 0; b < a; ++b)
        {
            const Point &p = graph->coordinate(a);
            const Point &q = graph->coordinate(b);
            EXPECT_GE(std::hypot(p.x - q.x, p.y - q.y), 0.99) << a << " and " << b;
        }

    // No vertex lies on an edge that is not its own, and no two edges cross.
    const auto side = [&](Vertex a, Vertex b, Vertex c)
    {
        const Point &p = graph->coordinate(a);
        const Point &q = graph->coordinate(b);
        const Point &r = graph->coordinate(c);
        const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        return std::abs(area) < 1e-9 ? 0 : area > 0 ? 1 : -1;
    };
    const auto between = [&](Vertex a, Vertex b, Vertex c)
    {
        const Point &p = graph->coordinate(a);
        const Point &q = graph->coordinate(b);
        const Point &r = graph->coordinate(c);
        return side(a, b, c) == 0 && (r.x - p.x) * (r.x - q.x) + (r.y - p.y) * (r.y - q.y) < 0;
    };
    const auto edges = graph->edges();
    for (const Graph::Edge &e : edges)
    {
        for (Vertex v = 0; v < graph->vertexCount(); ++v)
            EXPECT_FALSE(between(e.a, e.b, v)) << v << " on " << e.a << "-" << e.b;
        for (const Graph::Edge &f : edges)
            EXPECT_FALSE(side(e.a, e.b, f.a) * side(e.a, e.b, f.b) < 0 &&
                         side(f.a, f.b, e.a) * side(f.a, f.b, e.b) < 0)
                << e.a << "-" << e.b << " crosses " << f.a << "-" << f.b;
    }
}

INSTANTIATE_TEST_SUITE_P(All, SmallProblem, testing::ValuesIn(kExpected),
                         [](const auto &row) { return std::string(row.param.name); });

TEST(SmallBenchmark, KnowsExactlyTheseProblems)
{
    std::vector<std::string> expected;
    for (const Expected &row : kExpected)
        expected.emplace_back(row.name);
    EXPECT_EQ(smallProblemNames(), expected);
}

TEST(SmallBenchmark, SuggestsTheNearestName)
{
    SmallBenchmark problem;
    try
    {
        problem.configure(Config::scalar("tunel", {"plan.yaml", 3, 5}), {});
        FAIL() << "an unknown name was accepted";
    }
    catch (const PlanError &error)
    {
        EXPECT_EQ(error.where().toString(), "plan.yaml:3:5");
        EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'tunnel'?"));
    }
    EXPECT_THROW((void)smallProblem("no such thing"), InputError);
}

TEST(SmallBenchmark, NeedsAName)
{
    SmallBenchmark problem;
    EXPECT_THROW(problem.configure(Config::map({}), {}), PlanError);
}

TEST(SmallBenchmark, BringsItsOwnRobots)
{
    EXPECT_FALSE(SmallBenchmark().takesRobotCount());
    SmallBenchmark problem;
    const Config settings =
        Config::map({{"problem", {}, Config::scalar("tree")}, {"robots", {}, Config::scalar("2")}});
    EXPECT_THROW(problem.configure(settings, {}), PlanError);
    const auto tree = configured("tree");
    EXPECT_THROW((void)tree->makeInstance(tree->makeGraph(0), 4, 0), InputError);
    EXPECT_EQ(tree->makeInstance(tree->makeGraph(0), 2, 0).goals, (std::vector<Vertex>{6, 1}));
}

} // namespace
} // namespace mrpp
