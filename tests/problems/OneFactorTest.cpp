/// The one-factor models and instances that are solvable by construction.

#include "problems/OneFactor.h"
#include "framework/Catalog.h"
#include "framework/support/Error.h"
#include "problems/Problems.h"
#include "problems/PublicBenchmark.h"
#include "problems/SolvableInstance.h"
#include "tests/problems/Generated.h"
#include "tests/support/BruteForce.h"
#include "yaml/ProblemList.h"
#include "yaml/YamlConfig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mrpp::test
{
namespace
{

using ::testing::HasSubstr;

const Catalog &catalog()
{
    static const Catalog kCatalog = []
    {
        Catalog filled;
        registerProblems(filled);
        return filled;
    }();
    return kCatalog;
}

/// The points of a plan with these lines as its problems.
std::vector<ProblemPoint> points(const std::string &problems)
{
    return readProblems(parseYaml("problems:\n" + problems, "plan.yaml").find("problems")->items(),
                        {.catalog = &catalog()});
}

std::string complaintOf(const std::string &problems)
{
    try
    {
        static_cast<void>(points(problems));
    }
    catch (const InputError &error)
    {
        return error.what();
    }
    return "nothing is wrong";
}

TEST(FixedGraph, IsOneGraphWhoseRobotsGrow)
{
    const auto sweep =
        points("  - fg_vr: {graph: {biconnected: {initial_cycle: 5, handles: 4, max_handle_length: 3}},"
               " free: {from: 2, to: 7, step: 1}}");
    ASSERT_EQ(sweep.size(), 6U);
    const auto graph = sweep.front().problem->makeGraph(11);
    std::vector<Vertex> starts;
    std::vector<Vertex> goals;
    for (std::size_t i = sweep.size(); i-- > 0;)
    {
        const Problem &problem = *sweep[i].problem;
        EXPECT_EQ(sweep[i].model, "fg_vr");
        EXPECT_EQ(sweep[i].name, "biconnected 5-4-3");
        EXPECT_EQ(sweep[i].sweepVariable, "free");
        EXPECT_EQ(sweep[i].sweepValue, static_cast<double>(i + 2));
        EXPECT_EQ(problem.identity(), sweep.front().problem->identity());
        EXPECT_FALSE(problem.variesGraph());
        EXPECT_EQ(problem.makeGraph(11)->fingerprint(), graph->fingerprint());
        const Instance instance = problem.makeInstance(graph, problem.robotCount(*graph), 3);
        ASSERT_EQ(instance.robotCount(), 9 - (i + 2));
        ASSERT_GT(instance.robotCount(), starts.size());
        EXPECT_TRUE(std::equal(starts.begin(), starts.end(), instance.starts.begin()));
        EXPECT_TRUE(std::equal(goals.begin(), goals.end(), instance.goals.begin()));
        starts = instance.starts;
        goals = instance.goals;
    }
}

TEST(FixedGraph, TakesEveryGenerator)
{
    for (const std::string &family : generatorNames(catalog()))
    {
        const auto sweep = points("  - fg_vr: {graph: {" + family + ": {}}, robots: [1, 3]}");
        ASSERT_EQ(sweep.size(), 2U) << family;
        const auto graph = sweep[1].problem->makeGraph(1);
        EXPECT_EQ(sweep[1].problem->makeInstance(graph, 3, 1).defect(), std::nullopt) << family;
        EXPECT_EQ(points("  - fg_vr: {graph: " + family + ", robots: 3}").size(), 1U) << family;
    }
    EXPECT_GE(generatorNames(catalog()).size(), 9U);
}

TEST(VariableGraph, KeepsTheOccupancy)
{
    const auto sweep =
        points("  - fr_vg: {graph: {grid: {side: {from: 2, to: 20, step: 2}}}, occupancy: 0.98}");
    ASSERT_EQ(sweep.size(), 10U);
    const std::vector<std::size_t> robots = {3, 15, 35, 62, 98, 141, 192, 250, 317, 392};
    for (std::size_t i = 0; i < sweep.size(); ++i)
    {
        EXPECT_EQ(sweep[i].name, "grid");
        EXPECT_EQ(sweep[i].sweepVariable, "side");
        EXPECT_TRUE(sweep[i].problem->variesGraph());
        const auto graph = sweep[i].problem->makeGraph(1);
        EXPECT_EQ(graph->vertexCount(), 4 * (i + 1) * (i + 1));
        EXPECT_EQ(sweep[i].problem->robotCount(*graph), robots[i]);
    }
}

TEST(VariableGraph, LetsOneNumberDriveSeveralParameters)
{
    const auto sweep =
        points("  - fr_vg: {graph: {biconnected: {initial_cycle: x, handles: x, max_handle_length: x}},"
               " occupancy: 0.98, x: {from: 4, to: 100, step: 4}}");
    ASSERT_EQ(sweep.size(), 25U);
    EXPECT_EQ(sweep.front().name, "biconnected");
    EXPECT_EQ(sweep.front().sweepVariable, "x");
    EXPECT_EQ(sweep.front().problem->makeGraph(1)->vertexCount(), 12U);
    EXPECT_EQ(sweep.back().problem->makeGraph(1)->vertexCount(), 5100U);

    const auto isthmus = points("  - fg_vr: {graph: {isthmus: {vertices: 100, longest_isthmus: x}}, free: x,"
                                " x: {from: 2, to: 60, step: 2}}");
    ASSERT_EQ(isthmus.size(), 30U);
    for (std::size_t i = 0; i < isthmus.size(); ++i)
    {
        const auto graph = isthmus[i].problem->makeGraph(i);
        EXPECT_EQ(longestIsthmus(*graph), 2 * (i + 1));
        EXPECT_EQ(isthmus[i].problem->robotCount(*graph), 100 - 2 * (i + 1));
    }
}

TEST(OneFactor, SaysWhereSettingsAreWrong)
{
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {gird: {side: 3}}, robots: 2}"),
                HasSubstr("plan.yaml:2:21: there is no generator 'gird'; did you mean 'grid'?"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {small_benchmark: tree}, robots: 2}"),
                HasSubstr("there is no generator 'small_benchmark'"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {fg_vr: {}}, robots: 2}"),
                HasSubstr("there is no generator 'fg_vr'"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {seid: 3}}, robots: 2}"),
                HasSubstr("plan.yaml:2:28: unknown key 'seid'; did you mean 'side'?"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {side: many}}, robots: 2}"),
                HasSubstr("plan.yaml:2:34: "));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {side: 3, robots: 2}}}"),
                HasSubstr("plan.yaml:2:37: 'robots' stands beside 'graph', not in it"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {side: 3}, tree: {}}, robots: 2}"),
                HasSubstr("plan.yaml:2:38: 'graph' names one generator"));
    EXPECT_THAT(complaintOf("  - fg_vr: {robots: 2}"), HasSubstr("needs a 'graph'"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {side: 3}}}"),
                HasSubstr("give one of robots, free, occupancy"));
    EXPECT_THAT(complaintOf("  - fg_vr: {graph: {grid: {side: 3}}, solvable: {yes: 1}, robots: 1}"),
                HasSubstr("'solvable' takes one value"));
    EXPECT_THAT(complaintOf("  - public_benchmark: {map: a.map, scenario: a.scen, solvable: true}"),
                HasSubstr("leave out 'solvable' or 'scenario'"));
}

TEST(SolvableInstance, CanBeSolvedOnGraphsWhereMostCannot)
{
    // Trees with two free vertices: most random instances on them have no solution.
    std::size_t unsolvable = 0;
    const auto tree = points("  - fg_vr: {graph: {tree: {vertices: 7}}, free: 2}").front();
    const auto scrambled =
        points("  - fg_vr: {graph: {tree: {vertices: 7}}, free: 2, solvable: true}").front();
    for (Seed seed = 0; seed < 40; ++seed)
    {
        const auto graph = tree.problem->makeGraph(seed);
        unsolvable += isSolvable(tree.problem->makeInstance(graph, 5, seed), MotionRule::pebble) ? 0 : 1;
        const Instance instance = scrambled.problem->makeInstance(graph, 5, seed);
        EXPECT_EQ(instance.defect(), std::nullopt);
        EXPECT_TRUE(isSolvable(instance, MotionRule::pebble)) << "seed " << seed;
        EXPECT_EQ(instance.starts, randomInstance(graph, 5, seed).starts);
    }
    EXPECT_GT(unsolvable, 20U);
}

TEST(SolvableInstance, MeetsEveryArrangementThatCanBeReached)
{
    // On a cycle of 4 with a handle of 1 and 3 robots, all 5 · 4 · 3 arrangements can be reached.
    const auto graph = Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {1, 4}, {4, 3}});
    std::set<std::vector<Vertex>> goals;
    for (Seed seed = 0; seed < 2000; ++seed)
        goals.insert(solvableInstance(graph, 3, seed).goals);
    EXPECT_EQ(goals.size(), 60U);
    // Two robots on a path never pass each other.
    const auto path = Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
    for (Seed seed = 0; seed < 100; ++seed)
    {
        const Instance instance = solvableInstance(path, 2, seed);
        EXPECT_EQ(instance.starts[0] < instance.starts[1], instance.goals[0] < instance.goals[1]);
    }
}

TEST(SolvableInstance, KeepsToTheLargestComponentAndTheSeed)
{
    const auto graph = Graph::fromEdges(6, {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {2, 5}});
    const Instance instance = solvableInstance(graph, 3, 5);
    EXPECT_EQ(instance.fingerprint(), solvableInstance(graph, 3, 5).fingerprint());
    for (const Vertex v : instance.goals)
        EXPECT_GE(v, 2U);
    EXPECT_EQ(solvableInstance(graph, 4, 5).goals, solvableInstance(graph, 4, 5).starts)
        << "nothing can move";
    EXPECT_EQ(solvableInstance(graph, 0, 5).robotCount(), 0U);
    EXPECT_THROW(static_cast<void>(solvableInstance(graph, 5, 5)), InputError);
    const Instance larger = solvableInstance(graph, 3, 5);
    const Instance smaller = solvableInstance(graph, 2, 5);
    EXPECT_TRUE(std::equal(smaller.starts.begin(), smaller.starts.end(), larger.starts.begin()));
}

} // namespace
} // namespace mrpp::test
