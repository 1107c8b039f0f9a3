#include "algorithms/Bibox.h"

#include "framework/Problem.h"
#include "framework/analysis/Blocks.h"
#include "framework/evaluation/Validator.h"
#include "problems/generators/Biconnected.h"
#include "tests/algorithms/Planning.h"
#include "tests/support/BiconnectedGraphs.h"
#include "tests/support/BruteForce.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>

namespace mrpp
{
namespace
{

using test::Answer;
using ::testing::HasSubstr;
using Settings = test::PlannerSettings;

Answer plan(const Instance &instance, const Settings &settings = {}, double seconds = 60)
{
    return test::plan<Bibox>(instance, settings, seconds);
}

/// How often something is tried: more than usual where the environment says so.
std::size_t rounds(const char *variable, std::size_t usual)
{
    const char *setting = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody writes it
    return setting == nullptr ? usual : std::strtoull(setting, nullptr, 10);
}

/// The graph of the published program's generator.
std::shared_ptr<const Graph> publishedGraph(int cycle, int handles, int longest, Seed seed)
{
    Biconnected generator;
    generator.parameters().set("initial_cycle", std::to_string(cycle));
    generator.parameters().set("handles", std::to_string(handles));
    generator.parameters().set("max_handle_length", std::to_string(longest));
    return generator.makeGraph(seed);
}

/// With robots on all but some vertices.
Instance published(int cycle, int handles, int longest, std::size_t free, Seed seed)
{
    const auto graph = publishedGraph(cycle, handles, longest, seed);
    return randomInstance(graph, graph->vertexCount() - free, seed);
}

/// Solves every instance of the graph with that many robots, up to the robots' names, or a random one of each
/// `stride` of them.
void solveAll(const std::shared_ptr<const Graph> &graph, std::size_t robots, std::size_t stride)
{
    Bibox planner;
    Random random(deriveSeed(7, graph->fingerprint(), robots));
    const std::size_t n = graph->vertexCount();
    std::size_t skip = random.below(stride);
    for (std::uint32_t set = 0; set < (1U << n); ++set)
    {
        if (static_cast<std::size_t>(std::popcount(set)) != robots)
            continue;
        Instance instance{graph, {}, {}};
        for (Vertex v = 0; v < n; ++v)
            if ((set >> v & 1U) != 0)
                instance.starts.push_back(v);
        std::vector<Vertex> order(n);
        std::iota(order.begin(), order.end(), 0);
        do
        {
            // Of the orders with the same front, the one with the rest descending is the last.
            const bool last = std::is_sorted(order.begin() + static_cast<std::ptrdiff_t>(robots), order.end(),
                                             std::greater<>());
            if (!last || skip-- > 0)
                continue;
            skip = stride == 1 ? 0 : random.below(2 * stride - 1);
            instance.goals.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(robots));
            planner.setInstance(std::make_shared<Instance>(instance));
            planner.setup();
            ASSERT_EQ(planner.solve({}), PlannerStatus::solved);
            const Verdict verdict = validate(instance, planner.solution(), MotionRule::pebble);
            ASSERT_TRUE(verdict.valid()) << verdict.violation;
        } while (std::next_permutation(order.begin(), order.end()));
    }
}

TEST(Bibox, SolvesEverythingOnEveryBiconnectedGraphOfUpToSevenVertices)
{
    // All with up to six vertices, and a sample with seven; MRPP_BIBOX_STRIDE=1 takes all of these too.
    const std::size_t stride = rounds("MRPP_BIBOX_STRIDE", 2000);
    for (std::size_t vertices = 4; vertices <= 7; ++vertices)
        for (const auto &graph : test::connectedGraphs(vertices))
        {
            if (!test::isBiconnected(*graph) || Blocks(*graph).isCycle(0))
                continue;
            for (std::size_t robots = 0; robots + 2 <= vertices; ++robots)
                solveAll(graph, robots, vertices == 7 ? stride : 1);
        }
}

TEST(Bibox, SolvesRandomBiconnectedGraphs)
{
    const std::size_t cases = rounds("MRPP_BIBOX_CASES", 400);
    for (Seed seed = 1; seed <= cases; ++seed)
    {
        const auto graph = test::randomBiconnectedGraph(seed);
        Random random(seed);
        const std::size_t n = graph->vertexCount();
        const std::size_t free = 2 + random.below(seed % 2 == 0 ? 4 : n - 1);
        const Instance instance = randomInstance(graph, n - std::min(free, n), seed);
        const Answer answer = plan(instance, {{"handles", seed % 3 == 0 ? "depth_first" : "shortest"},
                                              {"restarts", seed % 5 == 0 ? "2" : "1"}});
        ASSERT_EQ(answer.status, PlannerStatus::solved) << "seed " << seed;
        const Verdict verdict = validate(instance, answer.solution, MotionRule::pebble);
        ASSERT_TRUE(verdict.valid()) << "seed " << seed << ": " << verdict.violation;
    }
}

struct Published
{
    int cycle;
    int handles;
    int longest;
    double moves;   ///< at most, mean
    double seconds; ///< at most, processor time, mean
    Seed seeds;
};

class PublishedProgram : public testing::TestWithParam<Published>
{};

TEST_P(PublishedProgram, NeedsMoreMovesAndTime)
{
    const Published &p = GetParam();
    double moves = 0;
    double seconds = 0;
    for (Seed seed = 1; seed <= p.seeds; ++seed)
    {
        const Instance instance = published(p.cycle, p.handles, p.longest, 2, seed);
        const Answer answer = plan(instance);
        ASSERT_EQ(answer.status, PlannerStatus::solved);
        ASSERT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
        moves += static_cast<double>(answer.solution.pathLength()) / static_cast<double>(p.seeds);
        seconds += answer.cpuSeconds / static_cast<double>(p.seeds);
    }
    EXPECT_LE(moves, p.moves);
    EXPECT_LE(seconds, p.seconds);
    RecordProperty("moves", static_cast<int>(moves));
    RecordProperty("microseconds", static_cast<int>(seconds * 1e6));
}

// On its own generator's graphs; (50, 50, 50) it does not solve within 30 s.
INSTANTIATE_TEST_SUITE_P(OfItsGenerator, PublishedProgram,
                         testing::Values(Published{5, 3, 4, 117, 0.00077, 10},
                                         Published{10, 10, 10, 3551, 0.003, 10},
                                         Published{20, 20, 20, 53'700, 0.05, 10},
                                         Published{50, 50, 50, 3'000'000, 5, 2}),
                         [](const auto &test) { return "Cycle" + std::to_string(test.param.cycle); });

TEST(Bibox, NeedsFewerMovesWithMoreRoom)
{
    std::map<std::size_t, std::size_t> moves; // by free vertices
    for (Seed seed = 1; seed <= 10; ++seed)
    {
        const auto graph = publishedGraph(20, 20, 20, seed);
        for (const std::size_t free : {2U, 3U, 4U, 6U, 10U, 20U, 50U, 100U, 200U})
        {
            const Answer answer = plan(randomInstance(graph, graph->vertexCount() - free, seed));
            ASSERT_EQ(answer.status, PlannerStatus::solved);
            moves[free] += answer.solution.pathLength();
        }
    }
    for (auto more = std::next(moves.begin()); more != moves.end(); ++more)
        EXPECT_LT(more->second, std::prev(more)->second) << more->first << " free vertices";
}

TEST(Bibox, StaysAboveTheOptimum)
{
    double moves = 0;
    double optimum = 0;
    for (Seed seed = 1; seed <= 60; ++seed)
    {
        const auto graph = test::gridGraph(3, 2);
        const Instance instance = randomInstance(graph, 2 + seed % 3, seed);
        const Answer answer = plan(instance, {{"restarts", "20"}});
        const auto fewest = test::fewestMoves(instance);
        ASSERT_TRUE(fewest.has_value());
        ASSERT_GE(answer.solution.pathLength(), *fewest);
        moves += static_cast<double>(answer.solution.pathLength());
        optimum += *fewest;
    }
    EXPECT_LE(moves, 2 * optimum);
}

TEST(Bibox, SaysWhyItRejects)
{
    const auto reason = [](const std::shared_ptr<const Graph> &graph, std::size_t robots)
    { return Bibox().reasonToReject(randomInstance(graph, robots, 1)).value_or(""); };
    const auto bowtie = Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}});
    EXPECT_THAT(reason(bowtie, 2), HasSubstr("vertex 2 is a cut vertex"));
    EXPECT_THAT(reason(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}), 2), HasSubstr("cycle"));
    EXPECT_THAT(reason(Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}}), 1),
                HasSubstr("no path leads from vertex 0 to vertex 3"));
    EXPECT_THAT(reason(test::gridGraph(3, 3), 8), HasSubstr("bibox_theta"));
    EXPECT_THAT(reason(Graph::fromEdges(2, {{0, 1}}), 0), HasSubstr("2 vertices"));
    EXPECT_EQ(reason(test::gridGraph(3, 3), 7), "");
    EXPECT_EQ(reason(test::gridGraph(3, 3), 0), "");
}

TEST(Bibox, RestartsFindShorterSolutions)
{
    double once = 0;
    double often = 0;
    for (Seed seed = 1; seed <= 5; ++seed)
    {
        const Instance instance = published(10, 10, 10, 2, seed);
        const Answer best = plan(instance, {{"restarts", "50"}});
        ASSERT_TRUE(validate(instance, best.solution, MotionRule::pebble).valid());
        EXPECT_EQ(plan(instance, {{"restarts", "50"}, {"threads", "1"}}).solution, best.solution);
        once += static_cast<double>(plan(instance).solution.pathLength());
        often += static_cast<double>(best.solution.pathLength());
    }
    EXPECT_LT(often, 0.97 * once);
}

TEST(Bibox, StopsWithinFiftyMilliseconds)
{
    const std::vector<std::shared_ptr<const Graph>> graphs = {
        test::gridGraph(316, 316), test::cycleWithHandles(1000, 200, 1000, 1),
        test::cycleWithHandles(50'000, 1, 100'000, 2), test::cycleWithHandles(3, 60'000, 3, 3),
        test::cycleWithHandles(50, 50, 50, 4)};
    for (std::size_t i = 0; i < graphs.size(); ++i)
        for (const std::size_t free : {std::size_t{2}, graphs[i]->vertexCount() / 2})
        {
            Bibox planner;
            planner.parameters().set("restarts", "2");
            planner.parameters().set("threads", "1"); // so that processor time is time
            planner.setInstance(
                std::make_shared<Instance>(randomInstance(graphs[i], graphs[i]->vertexCount() - free, 1)));
            planner.setup();
            for (const double limit : {0.001, 0.1})
            {
                const double begin = test::cpuSeconds();
                const PlannerStatus status = planner.solve(
                    TerminationCondition::when([&] { return test::cpuSeconds() - begin >= limit; }));
                const double seconds = test::cpuSeconds() - begin;
                if (seconds >= limit)
                {
                    EXPECT_LT(seconds, limit + 0.05) << "graph " << i << ", " << free << " free";
                }
                EXPECT_TRUE(status == PlannerStatus::timeout || status == PlannerStatus::solved);
            }
        }
}

/// The largest of the published sizes, on 98 of 100 vertices a robot.
TEST(Bibox, SolvesFiveThousandVerticesInSeconds)
{
    const Answer answer = plan(published(100, 100, 100, 102, 1), {}, 300);
    ASSERT_EQ(answer.status, PlannerStatus::solved);
    EXPECT_LT(answer.solution.pathLength(), 30'000'000U); // 12 bytes each
}

} // namespace
} // namespace mrpp
