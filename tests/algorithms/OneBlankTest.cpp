/// \file
/// one_blank and bibox_theta: exact on every small graph with one free vertex, against brute force over
/// permutations that shares no code with them, and on larger graphs of the kinds that are special.

#include "algorithms/OneBlank.h"

#include "algorithms/BiboxTheta.h"
#include "algorithms/pebble/BlockPuzzle.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/BruteForce.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>
#include <set>

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

template <class Planner>
Answer plan(const Instance &instance, const std::vector<std::pair<std::string, std::string>> &settings = {},
            double seconds = 60)
{
    Planner planner;
    EXPECT_FALSE(planner.reasonToReject(instance)) << *planner.reasonToReject(instance);
    for (const auto &[name, value] : settings)
        planner.parameters().set(name, value);
    planner.setInstance(std::make_shared<Instance>(instance));
    planner.setup();
    Answer answer;
    answer.status = planner.solve(TerminationCondition::after(seconds));
    answer.solution = planner.takeSolution();
    answer.reason = planner.reason();
    return answer;
}

/// What stands on each vertex: a robot, or −1.
using Board = std::vector<int>;

/// Every board that walks of the blank can make of this one.
std::set<Board> reachable(const Graph &graph, const Board &start)
{
    std::set<Board> seen{start};
    std::vector<Board> queue{start};
    for (std::size_t head = 0; head < queue.size(); ++head)
    {
        const auto blank =
            static_cast<Vertex>(std::find(queue[head].begin(), queue[head].end(), -1) - queue[head].begin());
        for (const Vertex v : graph.neighbors(blank))
        {
            Board next = queue[head];
            std::swap(next[v], next[blank]);
            if (seen.insert(next).second)
                queue.push_back(next);
        }
    }
    return seen;
}

/// Robot i starts on the i-th occupied vertex; goals as on the board.
Instance instanceOf(const std::shared_ptr<const Graph> &graph, const Board &start, const Board &goal)
{
    Instance instance{graph, std::vector<Vertex>(start.size() - 1), std::vector<Vertex>(start.size() - 1)};
    for (Vertex v = 0; v < start.size(); ++v)
    {
        if (start[v] >= 0)
            instance.starts[static_cast<std::size_t>(start[v])] = v;
        if (goal[v] >= 0)
            instance.goals[static_cast<std::size_t>(goal[v])] = v;
    }
    return instance;
}

/// Compares a planner with brute force on every `stride`-th instance of the graph with one free vertex (up to
/// the robots' names); returns how many there were.
template <class Planner>
std::size_t compareAll(const std::shared_ptr<const Graph> &graph, std::size_t stride)
{
    const std::size_t n = graph->vertexCount();
    std::size_t instances = 0;
    std::size_t number = n;
    for (Vertex blank = 0; blank < n; ++blank)
    {
        Board start(n);
        int robot = 0;
        for (Vertex v = 0; v < n; ++v)
            start[v] = v == blank ? -1 : robot++;
        const std::set<Board> solvable = reachable(*graph, start);
        Board goal = start;
        std::sort(goal.begin(), goal.end());
        do
        {
            if (++number % stride != 0)
                continue;
            ++instances;
            const Instance instance = instanceOf(graph, start, goal);
            // Small cores, which leave more to handles and 3-cycles, take turns with the usual ones.
            const char *coreSize = (number / stride) % 3 == 0 ? "9" : (number / stride) % 3 == 1 ? "0" : "5";
            const Answer answer = plan<Planner>(instance, {{"core_size", coreSize}});
            const bool isSolvable = solvable.count(goal) > 0;
            EXPECT_EQ(answer.status, isSolvable ? PlannerStatus::solved : PlannerStatus::infeasible)
                << answer.reason;
            EXPECT_EQ(answer.reason.empty(), isSolvable);
            if (isSolvable)
            {
                const Verdict verdict = validate(instance, answer.solution, MotionRule::pebble);
                EXPECT_TRUE(verdict.valid()) << verdict.violation;
            }
            if (testing::Test::HasFailure())
                return instances;
        } while (std::next_permutation(goal.begin(), goal.end()));
    }
    return instances;
}

bool isBiconnected(const Graph &graph)
{
    const Blocks blocks(graph);
    return blocks.count() == 1 && !blocks.isEdge(0) && !blocks.isCycle(0);
}

/// The tests look at some of the instances of six vertices; MRPP_EXHAUSTIVE=7 has every one up to seven.
std::size_t exhaustiveUpTo()
{
    const char *value = std::getenv("MRPP_EXHAUSTIVE");
    return value == nullptr ? 0 : std::strtoul(value, nullptr, 10);
}

TEST(OneBlank, AgreesWithBruteForceOnEverySmallGraph)
{
    std::size_t instances = 0;
    for (std::size_t n = 2; n <= std::max<std::size_t>(6, exhaustiveUpTo()); ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            instances += compareAll<OneBlank>(graph, n <= std::max<std::size_t>(5, exhaustiveUpTo()) ? 1 : 7);
            ASSERT_FALSE(HasFailure()) << "graph of " << n << " vertices, " << graph->edgeCount() << " edges";
        }
    }
    RecordProperty("instances", std::to_string(instances));
    EXPECT_GT(instances, 70000U);
}

TEST(BiboxTheta, AgreesWithBruteForceOnEverySmallBiconnectedGraph)
{
    std::size_t instances = 0;
    for (std::size_t n = 4; n <= 7; ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            const bool isWhole = n <= std::max<std::size_t>(5, exhaustiveUpTo());
            // Of seven vertices theta_0 alone.
            if (!isBiconnected(*graph) || (!isWhole && n == 7 && !isThetaZero(*graph)))
                continue;
            instances += compareAll<BiboxTheta>(graph, isWhole ? 1 : n == 6 ? 13 : 31);
            ASSERT_FALSE(HasFailure()) << "graph of " << n << " vertices, " << graph->edgeCount() << " edges";
        }
    }
    EXPECT_GT(instances, 5000U);
}

/// With two free vertices or more nothing on such a graph is impossible but for theta_0, which is refused.
TEST(BiboxTheta, SolvesEverySmallBiconnectedGraphWithMoreRoomToo)
{
    for (std::size_t n = 4; n <= 7; ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            if (!isBiconnected(*graph))
                continue;
            for (Seed seed = 1; seed <= 12; ++seed)
            {
                const Instance instance = randomInstance(graph, seed % (n - 1), seed);
                if (BiboxTheta().reasonToReject(instance))
                {
                    EXPECT_TRUE(isThetaZero(*graph));
                    continue;
                }
                const Answer answer = plan<BiboxTheta>(instance);
                ASSERT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
                ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
            }
        }
    }
}

std::shared_ptr<const Graph> cycleWith(std::size_t size, std::vector<Graph::Edge> edges)
{
    for (Vertex v = 0; v < size; ++v)
        edges.push_back({v, static_cast<Vertex>((v + 1) % size)});
    Vertex top = 0;
    for (const auto &edge : edges)
        top = std::max({top, edge.a, edge.b});
    return Graph::fromEdges(top + 1, edges);
}

std::shared_ptr<const Graph> thetaGraph(const std::vector<std::size_t> &arms)
{
    std::vector<Graph::Edge> edges;
    Vertex next = 2;
    for (const std::size_t arm : arms)
    {
        Vertex last = 0;
        for (std::size_t i = 0; i < arm; ++i)
        {
            edges.push_back({last, next});
            last = next++;
        }
        edges.push_back({last, 1});
    }
    return Graph::fromEdges(next, edges);
}

std::shared_ptr<const Graph> wheel(std::size_t spokes)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < spokes; ++v)
        edges.push_back({v, static_cast<Vertex>(spokes)});
    return cycleWith(spokes, edges);
}

std::shared_ptr<const Graph> prism(std::size_t sides)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < sides; ++v)
    {
        edges.push_back({v, static_cast<Vertex>(v + sides)});
        edges.push_back({static_cast<Vertex>(v + sides), static_cast<Vertex>((v + 1) % sides + sides)});
    }
    return cycleWith(sides, edges);
}

std::shared_ptr<const Graph> completeBipartite(std::size_t a, std::size_t b)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v < a; ++v)
        for (Vertex w = 0; w < b; ++w)
            edges.push_back({v, static_cast<Vertex>(a + w)});
    return Graph::fromEdges(a + b, edges);
}

/// A cycle with random handles; of some three to `vertices` + 9 vertices.
std::shared_ptr<const Graph> randomBiconnected(std::size_t vertices, Random &random)
{
    const auto cycle = static_cast<Vertex>(3 + random.below(7));
    std::vector<Graph::Edge> edges{{0, cycle / 2U}};
    Vertex next = cycle;
    const std::size_t longest = 1 + random.below(9);
    while (next < vertices)
    {
        const auto x = static_cast<Vertex>(random.below(next));
        const auto y = static_cast<Vertex>((x + 1 + random.below(next - 1)) % next);
        Vertex last = x;
        for (std::size_t inner = random.below(longest + 1); inner > 0; --inner)
        {
            edges.push_back({last, next});
            last = next++;
        }
        edges.push_back({last, y});
        if (random.below(60) == 0)
            break;
    }
    return cycleWith(cycle, edges);
}

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

/// Random starts, and goals where a random walk of the blank leads.
Instance scrambled(const std::shared_ptr<const Graph> &graph, std::size_t steps, Seed seed)
{
    Instance instance = randomInstance(graph, graph->vertexCount() - 1, seed);
    std::vector<Robot> occupants(graph->vertexCount(), kNoRobot);
    for (Robot r = 0; r < instance.robotCount(); ++r)
        occupants[instance.starts[r]] = r;
    auto blank =
        static_cast<Vertex>(std::find(occupants.begin(), occupants.end(), kNoRobot) - occupants.begin());
    Random random(seed);
    for (std::size_t i = 0; i < steps; ++i)
    {
        const auto around = graph->neighbors(blank);
        const Vertex next = around[random.below(around.size())];
        std::swap(occupants[blank], occupants[next]);
        blank = next;
    }
    for (Vertex v = 0; v < occupants.size(); ++v)
        if (occupants[v] != kNoRobot)
            instance.goals[occupants[v]] = v;
    return instance;
}

template <class Planner>
void expectSolved(const Instance &instance, const std::string &what)
{
    const Answer answer = plan<Planner>(instance);
    ASSERT_EQ(answer.status, PlannerStatus::solved) << what << ": " << answer.reason;
    const Verdict verdict = validate(instance, answer.solution, MotionRule::pebble);
    ASSERT_TRUE(verdict.valid()) << what << ": " << verdict.violation;
}

/// A random instance with one free vertex on a biconnected graph; on bipartite ones, and on theta_0, only
/// where it is solvable. `isOdd` asks for the wrong parity instead.
std::optional<Instance> randomPuzzle(const std::shared_ptr<const Graph> &graph, Seed seed, bool isOdd = false)
{
    const Blocks blocks(*graph);
    const PreparedBlock block(blocks, 0); // its vertices keep their numbers
    Instance instance = randomInstance(graph, graph->vertexCount() - 1, seed);
    for (int tries = 0; tries < 2; ++tries)
    {
        BlockPuzzle puzzle{&block, std::vector<Vertex>(graph->vertexCount(), kNoVertex), 0};
        std::vector<char> isGoal(graph->vertexCount(), 0);
        for (Robot r = 0; r < instance.robotCount(); ++r)
        {
            puzzle.targets[instance.starts[r]] = instance.goals[r];
            isGoal[instance.goals[r]] = 1;
        }
        puzzle.blank = static_cast<Vertex>(
            std::find(puzzle.targets.begin(), puzzle.targets.end(), kNoVertex) - puzzle.targets.begin());
        puzzle.targets[puzzle.blank] =
            static_cast<Vertex>(std::find(isGoal.begin(), isGoal.end(), 0) - isGoal.begin());
        if (obstacle(puzzle) == (isOdd ? BlockObstacle::oddPermutation : BlockObstacle::none))
            return instance;
        std::swap(instance.goals[0], instance.goals[1]);
    }
    return std::nullopt;
}

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
        if (!isBiconnected(*graph))
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
            const auto start = std::chrono::steady_clock::now();
            const PlannerStatus status = planner.solve(TerminationCondition::after(limit));
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
            EXPECT_TRUE(status == PlannerStatus::timeout || status == PlannerStatus::solved);
            // 50 ms, and room for other work on the machine.
            EXPECT_LT(seconds.count(), limit + 0.15) << "graph " << i << " limit " << limit;
        }
    }
}

} // namespace
} // namespace mrpp
