#include "framework/analysis/Solvability.h"

#include "framework/analysis/Normalization.h"
#include "tests/support/BruteForce.h"
#include "tests/support/ConfigurationOrbits.h"
#include "tests/support/RandomCases.h"
#include "tests/support/ReasonCheck.h"
#include "tests/support/SmallGraphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace mrpp
{
namespace
{

/// Every instance on a graph with that many robots, up to their names: oracle and brute force agree.
void expectExact(const std::shared_ptr<const Graph> &graph, std::size_t robots, MotionRule rule)
{
    const test::ConfigurationOrbits orbits(*graph, robots, rule);
    const test::ReasonCheck check(graph, robots, rule, orbits);
    for (const auto &goals : orbits.configurations())
    {
        if (!std::ranges::is_sorted(goals))
            continue;
        for (const auto &starts : orbits.configurations())
        {
            const Instance instance{graph, starts, goals};
            const Solvability answer = solvability(instance, rule);
            ASSERT_EQ(answer.solvable, orbits.of(starts) == orbits.of(goals))
                << toString(rule) << " " << ::testing::PrintToString(starts) << " to "
                << ::testing::PrintToString(goals) << "\n"
                << answer.reason;
            ASSERT_EQ(answer.solvable, answer.reason.empty());
            if (!answer.solvable)
            {
                ASSERT_EQ(check.complaint(instance, answer.reason), "")
                    << toString(rule) << " " << ::testing::PrintToString(starts) << " to "
                    << ::testing::PrintToString(goals) << "\n"
                    << answer.reason;
            }
        }
    }
}

struct Case
{
    std::string name;
    MotionRule rule = MotionRule::pebble;
    std::shared_ptr<const Graph> graph;
    std::vector<Vertex> starts;
    std::vector<Vertex> goals;
    std::string reason; ///< the whole answer
};

void PrintTo(const Case &test, std::ostream *out)
{
    *out << test.name;
}

std::shared_ptr<const Graph> path(Vertex vertices)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 1; v < vertices; ++v)
        edges.push_back({v - 1, v});
    return Graph::fromEdges(vertices, edges);
}

/// Triangles 0 1 2 and 5 6 7; three edges from 2 to 5.
std::shared_ptr<const Graph> dumbbell()
{
    return Graph::fromEdges(8, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 5}});
}

/// Arms 0–1, 0–2 and 0–3–4–5.
std::shared_ptr<const Graph> spider()
{
    return Graph::fromEdges(6, {{0, 1}, {0, 2}, {0, 3}, {3, 4}, {4, 5}});
}

/// A triangle 0 1 2 with a tail 2–3–4–5.
std::shared_ptr<const Graph> tadpole()
{
    return Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}});
}

/// Two triangles that share vertex 2.
std::shared_ptr<const Graph> bowtie()
{
    return Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}});
}

/// From 0 to 1 over 2, over 3 4 and over 5 6.
std::shared_ptr<const Graph> thetaZero()
{
    return Graph::fromEdges(7, {{0, 2}, {2, 1}, {0, 3}, {3, 4}, {4, 1}, {0, 5}, {5, 6}, {6, 1}});
}

std::vector<Case> unsolvableCases()
{
    using enum MotionRule;
    const auto square = Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    const auto squareWithTail = Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}});
    return {
        {"anotherComponent",
         pebble,
         Graph::fromEdges(5, {{0, 1}, {2, 3}, {3, 4}}),
         {0, 2},
         {1, 0},
         "robot 1's goal 0 lies in another component than its start 2"},
        {"nothingFree",
         pebble,
         path(3),
         {0, 1, 2},
         {1, 0, 2},
         "robot 0 cannot leave 0 for its goal 1: no vertex is free"},
        {"path",
         parallel,
         path(5),
         {4, 0, 2},
         {0, 3, 1},
         "robots 0 and 1 cannot pass each other on the path 0–4"},
        {"pathWithRotations",
         rotation,
         path(3),
         {0, 1},
         {1, 0},
         "robots 0 and 1 cannot pass each other on the path 0–2"},
        {"polygon",
         pebble,
         square,
         {0, 1, 2},
         {0, 2, 1},
         "the cyclic order 0, 1, 2 of robots on the polygon {0, 1, 2, 3} would have to become 0, 2, 1"},
        {"fullPolygon",
         rotation,
         square,
         {0, 1, 2, 3},
         {1, 0, 2, 3},
         "the cyclic order 0, 1, 2 of robots on the polygon {0, 1, 2, 3} would have to become 0, 2, 1"},
        {"cutVertex",
         pebble,
         bowtie(),
         {0, 1, 2, 3},
         {3, 1, 2, 0},
         "robot 0 would have to cross the cut vertex 2 to reach its goal 3: with one free vertex it cannot "
         "leave the "
         "block {0, 1, 2} once vertex 4 is free as in the end"},
        {"leaveCutVertex",
         pebble,
         spider(),
         {0, 1, 2, 3, 4},
         {1, 0, 2, 3, 4},
         "robot 0 would have to cross the cut vertex 0 to reach its goal 1: with one free vertex it cannot "
         "leave the "
         "block {0, 3} once vertex 5 is free as in the end"},
        {"crossFromLeafToLeaf",
         pebble,
         spider(),
         {1, 2, 3, 4, 5},
         {2, 1, 3, 4, 5},
         "robot 0 would have to cross the cut vertex 0 to reach its goal 2: with one free vertex it cannot "
         "leave the "
         "block {0, 1} once vertex 0 is free as in the end"},
        {"restOnCutVertex",
         pebble,
         spider(),
         {1, 0, 3, 4, 5},
         {0, 1, 3, 4, 5},
         "robot 0 cannot come to rest on the cut vertex 0, its goal: with one free vertex it stays on the "
         "other "
         "vertices of the block {0, 1} once vertex 2 is free as in the end"},
        {"cycle",
         pebble,
         squareWithTail,
         {0, 1, 2, 3},
         {0, 3, 2, 1},
         "the cyclic order 1, 2, 3 of robots on the cycle {0, 1, 2, 3} once vertex 4 is free as in the end "
         "would have to "
         "become 1, 3, 2"},
        {"thetaZero",
         pebble,
         thetaZero(),
         {1, 2, 3, 4, 5, 6},
         {2, 1, 3, 4, 5, 6},
         "the permutation on the block {0, 1, 2, 3, 4, 5, 6} once vertex 0 is free as in the end is none of "
         "the 120 of "
         "720 that one free vertex makes there: the block is theta_0"},
        {"oddOnBipartite",
         following,
         test::gridGraph(3, 2),
         {0, 1, 2, 3, 4},
         {1, 0, 2, 3, 4},
         "odd permutation on the bipartite block {0, 1, 2, 3, 4, 5} once vertex 5 is free as in the end: one "
         "free vertex "
         "makes only even ones"},
        {"corridor",
         pebble,
         dumbbell(),
         {0, 1, 6, 7},
         {6, 1, 0, 7},
         "robots 0 and 2 cannot pass each other in the corridor 2–5: it needs 5 free vertices, there are 4"},
        {"corridorWithRotations",
         rotation,
         dumbbell(),
         {0, 1, 2, 5, 6, 7},
         {5, 1, 2, 0, 6, 7},
         "robots 0 and 3 cannot pass each other in the corridor 2–5: it needs 3 free vertices, there are 2"},
        {"deadEnd",
         pebble,
         spider(),
         {3, 4, 5},
         {3, 5, 4},
         "robots 1 and 2 cannot pass each other in the dead end 0–5: it needs 4 free vertices, there are 3"},
        {"deadEndAtACycle",
         rotation,
         tadpole(),
         {0, 1, 4, 5},
         {0, 1, 5, 4},
         "robots 2 and 3 cannot pass each other in the dead end 2–5: it needs 3 free vertices, there are 2"},
        {"deadEndAtAFork",
         rotation,
         spider(),
         {1, 2, 4, 5},
         {1, 2, 5, 4},
         "robots 2 and 3 cannot pass each other in the dead end 0–5: it needs 4 free vertices, there are 2"},
        {"allFreeInADeadEnd",
         pebble,
         spider(),
         {0, 1, 2},
         {1, 0, 2},
         "robots 0 and 1 cannot pass each other in the dead end 0–5: it needs 4 free vertices, there are 3"},
        {"pulledFromBothEnds",
         pebble,
         Graph::fromEdges(6, {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}}),
         {0, 1, 2, 3},
         {2, 3, 4, 5},
         "robots 0 and 2 cannot pass each other in the corridor 0–1: it needs 3 free vertices, there are 2"},
        {"allFreeBeyondAJoin",
         pebble,
         Graph::fromEdges(6, {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}}),
         {1, 4, 2, 3},
         {0, 2, 3, 4},
         "robots 1 and 3 cannot pass each other in the corridor 0–1: it needs 3 free vertices, there are 2"},
        {"bridge",
         rotation,
         tadpole(),
         {0, 1, 2, 3, 4, 5},
         {0, 1, 3, 2, 4, 5},
         "robot 2 cannot cross the bridge 2–3 to its goal 3: no vertex is free"},
        {"fullCycle",
         rotation,
         squareWithTail,
         {0, 1, 2, 3, 4},
         {0, 1, 3, 2, 4},
         "the cyclic order 0, 2, 3 of robots on the cycle {0, 1, 2, 3} would have to become 0, 3, 2"},
        {"oddOnCycles",
         rotation,
         bowtie(),
         {0, 1, 2, 3, 4},
         {1, 0, 2, 3, 4},
         "odd permutation on the cycles {0, 1, 2, 3, 4}: all are of odd length, and no vertex is free"},
    };
}

class Unsolvable : public ::testing::TestWithParam<Case>
{};

TEST_P(Unsolvable, IsExplained)
{
    const auto &[name, rule, graph, starts, goals, reason] = GetParam();
    const Instance instance{graph, starts, goals};
    ASSERT_FALSE(instance.defect());
    const Solvability answer = solvability(instance, rule);
    EXPECT_FALSE(answer.solvable);
    EXPECT_EQ(answer.reason, reason);
    EXPECT_FALSE(test::isSolvable(instance, rule));
}

INSTANTIATE_TEST_SUITE_P(Reasons, Unsolvable, ::testing::ValuesIn(unsolvableCases()),
                         [](const auto &test) { return test.param.name; });

TEST(Solvability, IsThatOfBruteForceOnSmallGraphsAndItsReasonsAreTrue)
{
    for (std::size_t n = 1; n <= 5; ++n)
        for (const auto &graph : test::connectedGraphs(n))
            for (std::size_t robots = 0; robots <= n; ++robots)
                for (const MotionRule rule : {MotionRule::pebble, MotionRule::rotation})
                    ASSERT_NO_FATAL_FAILURE(expectExact(graph, robots, rule));
}

TEST(Solvability, OfSeveralComponentsIsThatOfEach)
{
    // A triangle with one free vertex, a path with one, a full square.
    const auto graph =
        Graph::fromEdges(10, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {6, 7}, {7, 8}, {8, 9}, {9, 6}});
    const std::vector<Vertex> starts = {0, 1, 3, 4, 6, 7, 8, 9};
    const std::vector<Vertex> turned = {1, 0, 4, 5, 7, 8, 9, 6};
    EXPECT_EQ(solvability({graph, starts, turned}, MotionRule::following).reason,
              "robot 4 cannot leave 6 for its goal 7: no vertex is free");
    EXPECT_TRUE(solvability({graph, starts, turned}, MotionRule::rotation).solvable);
    const std::vector<Vertex> reversed = {1, 0, 5, 4, 6, 7, 8, 9};
    EXPECT_EQ(solvability({graph, starts, reversed}, MotionRule::rotation).reason,
              "robots 2 and 3 cannot pass each other on the path 3–5");
}

TEST(Solvability, OfNoRobotsAndOfRobotsAtTheirGoalsIsGiven)
{
    EXPECT_TRUE(solvability({path(3), {}, {}}, MotionRule::pebble).solvable);
    EXPECT_TRUE(solvability({Graph::fromEdges(0, {}), {}, {}}, MotionRule::rotation).solvable);
    EXPECT_TRUE(solvability({path(3), {0, 1, 2}, {0, 1, 2}}, MotionRule::pebble).solvable);
}

TEST(Solvability, IsThatOfBruteForceOnSparseGraphs)
{
    std::size_t unsolvable = 0;
    for (Seed seed = 0; seed < 400; ++seed)
    {
        Random random(seed);
        const std::size_t n = 6 + random.below(5);
        const auto graph = test::randomConnectedGraph(n, random.below(3), seed);
        const std::size_t robots = 1 + random.below(5);
        std::vector<Vertex> vertices(n);
        std::iota(vertices.begin(), vertices.end(), Vertex{0});
        const auto draw = [&]
        {
            random.shuffle(std::span(vertices));
            return std::vector<Vertex>(vertices.begin(),
                                       vertices.begin() + static_cast<std::ptrdiff_t>(robots));
        };
        const Instance instance{graph, draw(), draw()};
        const MotionRule rule = seed % 4 == 0 && robots <= 5 ? MotionRule::rotation : MotionRule::pebble;
        const Solvability answer = solvability(instance, rule);
        ASSERT_EQ(answer.solvable, test::isSolvable(instance, rule))
            << "seed " << seed << " " << answer.reason;
        unsolvable += answer.solvable ? 0U : 1U;
    }
    EXPECT_GT(unsolvable, 30U);
    EXPECT_LT(unsolvable, 350U);
}

TEST(Solvability, ScrambledInstancesAreSolvable)
{
    for (Seed seed = 0; seed < 40; ++seed)
    {
        Random random(seed);
        const std::size_t n = 10 + random.below(70);
        const auto graph = test::randomConnectedGraph(n, random.below(n / 4), seed);
        const Instance pebble = test::randomSolvableInstance(graph, n - 1 - random.below(6), seed);
        EXPECT_EQ(solvability(pebble, MotionRule::pebble).reason, "");
        EXPECT_EQ(solvability(pebble, MotionRule::rotation).reason, "");
        const test::SolvedCase turned =
            test::randomSolvedCaseWithRotations(graph, n - random.below(4), 300, seed);
        EXPECT_EQ(solvability(turned.instance, MotionRule::rotation).reason, "");
    }
}

/// The number of permutations that turns of simple cycles generate. \pre at most 8 vertices
std::size_t orderOfTurns(const Graph &graph)
{
    const std::size_t n = graph.vertexCount();
    const auto cycles = test::simpleCycles(graph);
    std::vector<Vertex> identity(n);
    std::iota(identity.begin(), identity.end(), Vertex{0});
    std::set<std::vector<Vertex>> group = {identity};
    std::vector<std::vector<Vertex>> open = {identity};
    while (!open.empty())
    {
        const std::vector<Vertex> permutation = std::move(open.back());
        open.pop_back();
        for (const auto &cycle : cycles)
        {
            std::vector<Vertex> next = permutation;
            for (std::size_t i = 0; i < cycle.size(); ++i)
                next[cycle[i]] = permutation[cycle[(i + 1) % cycle.size()]];
            if (group.insert(next).second)
                open.push_back(std::move(next));
        }
    }
    return group.size();
}

TEST(Solvability, TurnsOfTheOneGraphWithoutAShortCycleMakeAllPermutations)
{
    // Three paths over two vertices each: every simple cycle leaves out two of the eight vertices.
    const auto graph =
        Graph::fromEdges(8, {{0, 2}, {2, 3}, {3, 1}, {0, 4}, {4, 5}, {5, 1}, {0, 6}, {6, 7}, {7, 1}});
    EXPECT_EQ(orderOfTurns(*graph), 40320U);
}

TEST(Normalization, LeadsToTheSupportByLegalMoves)
{
    for (Seed seed = 0; seed < 1000; ++seed)
    {
        Random random(seed);
        const std::size_t n = 2 + random.below(7);
        const auto graph = test::randomConnectedGraph(n, random.below(3), seed);
        const std::size_t robots = 1 + random.below(std::min<std::size_t>(n, 6));
        std::vector<Vertex> vertices(n);
        std::iota(vertices.begin(), vertices.end(), Vertex{0});
        const auto draw = [&]
        {
            random.shuffle(std::span(vertices));
            return std::vector<Vertex>(vertices.begin(),
                                       vertices.begin() + static_cast<std::ptrdiff_t>(robots));
        };
        const std::vector<Vertex> starts = draw();
        std::vector<Vertex> support = draw();
        std::vector<Vertex> places = normalize(*graph, Blocks(*graph), starts, support);
        ASSERT_TRUE(test::isSolvable({graph, starts, places}, MotionRule::pebble)) << "seed " << seed;
        std::ranges::sort(places);
        std::ranges::sort(support);
        ASSERT_EQ(places, support);
    }
}

} // namespace
} // namespace mrpp
