/// \file
/// one_blank and bibox_theta on every small graph with one free vertex, against brute force over permutations
/// that shares no code with them.

#include "algorithms/BiboxTheta.h"
#include "algorithms/OneBlank.h"
#include "algorithms/pebble/BlockPuzzle.h"
#include "framework/Problem.h"
#include "tests/algorithms/OneBlankCases.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <set>

namespace mrpp
{
namespace
{

using test::Answer;
using test::isBiconnectedAndNoCycle;
using test::plan;

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
            if (!isBiconnectedAndNoCycle(*graph) || (!isWhole && n == 7 && !isThetaZero(*graph)))
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
            if (!isBiconnectedAndNoCycle(*graph))
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

} // namespace
} // namespace mrpp
