#include "algorithms/PushAndRotate.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Catalog.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "problems/Problems.h"
#include "tests/support/BruteForce.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <gtest/gtest.h>
#include <map>
#include <numeric>

namespace mrpp
{
namespace
{

using Edges = std::vector<std::pair<Vertex, Vertex>>;

std::shared_ptr<const Graph> graphOf(std::size_t vertices, const Edges &pairs)
{
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b] : pairs)
        edges.push_back({a, b});
    return Graph::fromEdges(vertices, edges);
}

Instance smallProblem(const std::string &name)
{
    Catalog catalog;
    registerProblems(catalog);
    const auto problem = catalog.problems.create("small_benchmark");
    problem->configure(Config::scalar(name), {.catalog = &catalog});
    const auto graph = problem->makeGraph(1);
    return problem->makeInstance(graph, problem->robotCount(*graph), 1);
}

/// The planner with its last instance.
class Rotator
{
public:
    explicit Rotator(const char *restarts = "1", const char *threads = "0")
    {
        planner_.parameters().set("restarts", restarts);
        planner_.parameters().set("threads", threads);
    }

    PlannerStatus operator()(const Instance &instance, Seed seed = 1, const TerminationCondition &ptc = {})
    {
        planner_.setInstance(std::make_shared<Instance>(instance));
        planner_.setSeed(seed);
        planner_.setup();
        return planner_.solve(ptc);
    }

    [[nodiscard]] const Solution &solution() const { return planner_.solution(); }
    [[nodiscard]] const std::string &reason() const { return planner_.reason(); }
    /// How often the main loop failed and the certain way was taken.
    [[nodiscard]] double fallbacks() const { return planner_.progressProperties().front().second(); }

private:
    PushAndRotate planner_;
};

void expectSolved(const Instance &instance, Rotator &run, Seed seed = 1)
{
    ASSERT_EQ(run(instance, seed), PlannerStatus::solved) << run.reason();
    const Verdict verdict = validate(instance, run.solution(), MotionRule::pebble);
    ASSERT_TRUE(verdict.valid()) << verdict.violation;
}

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
    expectSolved(instance, run);
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
        expectSolved(instance, run, seed);
        EXPECT_LT(test::cpuSeconds() - start, 2.0); // of all threads
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
    expectSolved({graphOf(c.vertices, c.edges), c.starts, c.goals}, run);
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

/// The configurations of `robots` robots on a small graph, and which can be reached from which.
class Configurations
{
public:
    Configurations(const Graph &graph, std::size_t robots)
    {
        std::vector<Vertex> configuration;
        enumerate(graph.vertexCount(), robots, configuration);
        leader_.resize(all_.size());
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
        for (std::size_t i = 0; i < all_.size(); ++i)
        {
            std::vector<Vertex> moved = all_[i];
            for (Vertex &position : moved)
            {
                const Vertex from = position;
                for (const Vertex to : graph.neighbors(from))
                {
                    position = to;
                    if (const auto next = numbers_.find(moved); next != numbers_.end())
                        leader_[find(i)] = find(next->second);
                }
                position = from;
            }
        }
    }

    [[nodiscard]] std::size_t count() const { return all_.size(); }
    [[nodiscard]] const std::vector<Vertex> &at(std::size_t i) const { return all_[i]; }
    bool connected(std::size_t i, std::size_t j) { return find(i) == find(j); }

private:
    void enumerate(std::size_t vertices, std::size_t robots, std::vector<Vertex> &configuration)
    {
        if (configuration.size() == robots)
        {
            numbers_.emplace(configuration, all_.size());
            all_.push_back(configuration);
            return;
        }
        for (Vertex v = 0; v < vertices; ++v)
        {
            if (std::find(configuration.begin(), configuration.end(), v) != configuration.end())
                continue;
            configuration.push_back(v);
            enumerate(vertices, robots, configuration);
            configuration.pop_back();
        }
    }

    std::size_t find(std::size_t i)
    {
        while (leader_[i] != i)
            i = leader_[i] = leader_[leader_[i]];
        return i;
    }

    std::vector<std::vector<Vertex>> all_;
    std::map<std::vector<Vertex>, std::size_t> numbers_;
    std::vector<std::size_t> leader_; ///< union-find over legal moves
};

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
            Configurations all(*graph, robots);
            for (std::size_t i = 0; i < all.count(); ++i)
            {
                if (!std::is_sorted(all.at(i).begin(), all.at(i).end()))
                    continue;
                for (std::size_t j = 0; j < all.count(); ++j)
                {
                    if (++number % stride != 0)
                        continue;
                    const Instance instance{graph, all.at(i), all.at(j)};
                    if (all.connected(i, j))
                    {
                        ++solvable;
                        expectSolved(instance, run);
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
        expectSolved(instance, run, seed);
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
    expectSolved({graph, starts, {2, 3, 1, 5, 6, 7, 10, 12, 8, 16, 17}}, run);
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
                expectSolved(test::randomSolvableInstance(graph, robots, seed), run);
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
    expectSolved(instance, first, 7);
    expectSolved(instance, second, 7);
    EXPECT_EQ(first.solution(), second.solution());
}

TEST(PushAndRotate, KeepsTheBestOfRestartsOnMapsToo)
{
    const Instance instance = randomInstance(test::gridGraph(20, 20), 300, 5);
    Rotator once;
    Rotator often("6");
    expectSolved(instance, once);
    expectSolved(instance, often);
    const RedundancyRemoval removal;
    EXPECT_LE(removal.improve(instance, often.solution(), {}).pathLength(),
              removal.improve(instance, once.solution(), {}).pathLength());
}

} // namespace
} // namespace mrpp
