#include "algorithms/Tass.h"

#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/BruteForce.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

namespace mrpp
{
namespace
{

struct Answer
{
    PlannerStatus status = PlannerStatus::unknown;
    Solution solution;
    std::string reason;
};

Answer plan(const Instance &instance, const char *restarts = "1")
{
    Tass planner;
    EXPECT_FALSE(planner.reasonToReject(instance)) << *planner.reasonToReject(instance);
    planner.parameters().set("restarts", restarts);
    planner.setInstance(std::make_shared<Instance>(instance));
    planner.setup();
    Answer answer;
    answer.status = planner.solve({});
    answer.solution = planner.takeSolution();
    answer.reason = planner.reason();
    return answer;
}

/// The shape of the subtree at v, the same for isomorphic ones.
std::string shape(const Graph &tree, Vertex v, Vertex parent)
{
    std::vector<std::string> children;
    for (const Vertex w : tree.neighbors(v))
        if (w != parent)
            children.push_back(shape(tree, w, v));
    std::sort(children.begin(), children.end());
    std::string result = "(";
    for (const std::string &child : children)
        result += child;
    return result + ")";
}

/// Every tree of that many vertices once: 1, 1, 1, 2, 3, 6, 11, 23, 47 for 1 to 9.
std::vector<std::shared_ptr<const Graph>> trees(std::size_t vertices)
{
    std::vector<std::shared_ptr<const Graph>> result;
    std::set<std::string> seen;
    std::vector<Graph::Edge> edges(vertices - 1); // edge i joins i+1 to any of 0…i
    for (std::size_t i = 0; i + 1 < vertices; ++i)
        edges[i] = {static_cast<Vertex>(i + 1), 0};
    for (;;)
    {
        auto tree = Graph::fromEdges(vertices, edges);
        std::string least;
        for (Vertex v = 0; v < vertices; ++v)
            if (std::string at = shape(*tree, v, kNoVertex); least.empty() || at < least)
                least = std::move(at);
        if (seen.insert(least).second)
            result.push_back(std::move(tree));
        std::size_t i = 0;
        while (i + 1 < vertices && ++edges[i].b > i)
            edges[i++].b = 0;
        if (i + 1 >= vertices)
            return result;
    }
}

/// Moves robots about by chance.
struct PebbleWalk
{
    const Graph &graph;
    std::vector<Vertex> positions;

    void go(Random &random, std::size_t steps)
    {
        for (; steps > 0 && !positions.empty(); --steps)
        {
            Vertex &from = positions[random.below(positions.size())];
            const auto around = graph.neighbors(from);
            const Vertex to = around[random.below(around.size())];
            if (std::find(positions.begin(), positions.end(), to) == positions.end())
                from = to;
        }
    }
};

TEST(Tass, SolvesExactlyTheSolvableInstancesOnEveryTreeOfUpToNineVertices)
{
    std::size_t treeCount = 0;
    std::size_t solved = 0;
    std::size_t refuted = 0;
    for (std::size_t n = 2; n <= 9; ++n)
    {
        for (const auto &tree : trees(n))
        {
            ++treeCount;
            const std::vector<Vertex> orbits = test::positionOrbits(*tree, MotionRule::pebble);
            for (std::size_t set = 0; set < std::size_t{1} << n; ++set)
            {
                std::vector<Vertex> occupied;
                for (Vertex v = 0; v < n; ++v)
                    if ((set >> v & 1U) != 0)
                        occupied.push_back(v);
                if (occupied.size() + 2 > n)
                    continue;
                for (Seed seed = 0; seed < 4; ++seed)
                {
                    // The robots change places by chance, in all but every fourth case within their orbits;
                    // and they start where a walk from there ends.
                    Random random(deriveSeed(seed, set, n, treeCount));
                    std::vector<Vertex> goals = occupied;
                    random.shuffle(std::span(goals));
                    if (seed != 0)
                        std::stable_sort(goals.begin(), goals.end(),
                                         [&](Vertex a, Vertex b)
                                         { return orbits[set * n + a] < orbits[set * n + b]; });
                    std::vector<Vertex> starts = occupied;
                    std::stable_sort(starts.begin(), starts.end(),
                                     [&](Vertex a, Vertex b)
                                     { return orbits[set * n + a] < orbits[set * n + b]; });
                    bool solvable = true;
                    for (std::size_t r = 0; r < starts.size(); ++r)
                        solvable &= orbits[set * n + starts[r]] == orbits[set * n + goals[r]];
                    PebbleWalk walk{*tree, starts};
                    walk.go(random, 30);
                    const Instance instance{tree, walk.positions, goals};
                    const Answer answer = plan(instance);
                    ASSERT_EQ(answer.status, solvable ? PlannerStatus::solved : PlannerStatus::infeasible)
                        << "tree " << treeCount << " of " << n << " vertices, set " << set << ", seed "
                        << seed << ": " << answer.reason;
                    (solvable ? solved : refuted) += 1;
                    if (solvable)
                    {
                        ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
                    }
                    else
                    {
                        ASSERT_FALSE(answer.reason.empty());
                    }
                }
            }
        }
    }
    EXPECT_EQ(treeCount, 94U);
    EXPECT_GT(solved, 50'000U);
    EXPECT_GT(refuted, 5'000U);
}

TEST(Tass, NeedsNoFewerMovesThanTheOptimum)
{
    for (Seed seed = 1; seed <= 60; ++seed)
    {
        const auto tree = test::randomConnectedGraph(7, 0, seed);
        const Instance instance = test::randomSolvableInstance(tree, 1 + seed % 5, seed);
        const Answer answer = plan(instance, "20");
        ASSERT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
        EXPECT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
        EXPECT_GE(answer.solution.pathLength(), *test::fewestMoves(instance));
    }
}

TEST(Tass, SolvesScrambledTreesOfEveryDensity)
{
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        const auto vertices = static_cast<std::size_t>(4 + random.below(80));
        const auto tree = test::randomConnectedGraph(vertices, 0, seed);
        const std::size_t free =
            2 + random.below(std::min<std::size_t>(vertices - 2, seed % 2 == 0 ? 6 : 80));
        const Instance instance = test::randomSolvableInstance(tree, vertices - free, seed);
        const Answer answer = plan(instance);
        ASSERT_EQ(answer.status, PlannerStatus::solved) << "seed " << seed << ": " << answer.reason;
        ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
    }
}

/// A random tree on which four free vertices are always enough: every vertex is a leaf or has three
/// neighbours or more.
std::shared_ptr<const Graph> roomyTree(std::size_t vertices, Seed seed)
{
    Random random(seed);
    std::vector<Graph::Edge> edges = {{0, 1}, {0, 2}, {0, 3}};
    std::vector<Vertex> junctions = {0};
    std::vector<Vertex> leaves = {1, 2, 3};
    Vertex next = 4;
    while (next + 2 <= vertices)
    {
        // A leaf becomes a junction.
        const std::size_t i = random.below(leaves.size());
        const Vertex leaf = leaves[i];
        edges.push_back({leaf, next});
        edges.push_back({leaf, next + 1});
        leaves[i] = next;
        leaves.push_back(next + 1);
        next += 2;
    }
    while (next < vertices)
        edges.push_back({0, next++});
    return Graph::fromEdges(vertices, edges);
}

TEST(Tass, SolvesATreeOfAThousandVerticesWithFourFree)
{
    for (Seed seed = 1; seed <= 3; ++seed)
    {
        const Instance instance = randomInstance(roomyTree(1000, seed), 996, seed);
        const double start = test::cpuSeconds();
        const Answer answer = plan(instance);
        const double seconds = test::cpuSeconds() - start;
        ASSERT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
        EXPECT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
        RecordProperty("seconds", std::to_string(seconds));
        RecordProperty("moves", std::to_string(answer.solution.pathLength()));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        EXPECT_LT(seconds, 3.0);
#endif
    }
}

TEST(Tass, RefusesWhatIsNoTreeAndSaysWhy)
{
    const Tass planner;
    const auto reason = [&](std::size_t vertices, std::initializer_list<std::pair<Vertex, Vertex>> edges)
    {
        const auto refused = planner.reasonToReject({Graph::fromEdges(vertices, edges), {0}, {1}});
        return refused.value_or("");
    };
    EXPECT_EQ(reason(4, {{0, 1}, {1, 2}, {2, 3}}), "");
    EXPECT_EQ(reason(4, {{0, 1}, {1, 2}, {2, 3}, {1, 3}}), "is no tree: the edge 2–3 closes a cycle");
    EXPECT_EQ(reason(4, {{0, 1}, {0, 2}, {1, 3}, {2, 3}}), "is no tree: the edge 3–2 closes a cycle");
    EXPECT_EQ(reason(5, {{0, 1}, {2, 3}, {3, 4}, {2, 4}}), "is no tree: it is not connected");
    EXPECT_EQ(reason(2, {{0, 1}}), "has fewer than two free vertices");
}

TEST(Tass, ProvesThatNobodyPassesOnALine)
{
    const auto line = Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
    const Answer answer = plan({line, {0, 2}, {4, 3}});
    EXPECT_EQ(answer.status, PlannerStatus::infeasible);
    EXPECT_NE(answer.reason.find("robot"), std::string::npos);
    EXPECT_EQ(plan({line, {0, 2}, {3, 4}}).status, PlannerStatus::solved);
}

TEST(Tass, MoreAttemptsAreNeverLongerAndAlwaysTheSame)
{
    const Instance instance = test::randomSolvableInstance(test::randomConnectedGraph(30, 0, 4), 20, 4);
    const Answer one = plan(instance);
    const Answer many = plan(instance, "200");
    ASSERT_EQ(many.status, PlannerStatus::solved);
    EXPECT_TRUE(validate(instance, many.solution, MotionRule::pebble).valid());
    EXPECT_LE(many.solution.pathLength(), one.solution.pathLength());
    EXPECT_EQ(plan(instance, "200").solution, many.solution);
}

} // namespace
} // namespace mrpp
