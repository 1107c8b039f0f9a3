#include "algorithms/Mapp.h"

#include "algorithms/mapp/Alternates.h"
#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
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
    std::vector<Robot> slidable;
};

using Parameters = std::vector<std::pair<std::string, std::string>>;

Answer plan(const Instance &instance, const Parameters &parameters = {})
{
    Mapp planner;
    for (const auto &[name, value] : parameters)
        planner.parameters().set(name, value);
    planner.setInstance(std::make_shared<Instance>(instance));
    planner.setup();
    Answer answer;
    answer.slidable = planner.slidableRobots();
    answer.status = planner.solve({});
    answer.solution = planner.takeSolution();
    answer.reason = planner.reason();
    return answer;
}

std::vector<Vertex> ends(const Instance &instance, const Solution &solution)
{
    std::vector<Vertex> positions = instance.starts;
    for (const Move &move : solution.moves())
        positions[move.robot] = move.to;
    return positions;
}

/// The largest component of a grid with obstacles.
std::shared_ptr<const Graph> gridWithObstacles(std::size_t width, std::size_t height, double share, Seed seed)
{
    Random random(seed);
    const auto full = test::gridGraph(width, height);
    std::vector<char> open(full->vertexCount());
    for (char &cell : open)
        cell = random.uniform() >= share ? 1 : 0;
    std::vector<Graph::Edge> edges;
    for (const Graph::Edge &edge : full->edges())
        if (open[edge.a] != 0 && open[edge.b] != 0)
            edges.push_back(edge);
    const auto graph = Graph::fromEdges(full->vertexCount(), edges);
    const Components components(*graph);
    std::vector<Vertex> numbers(graph->vertexCount(), kNoVertex);
    Vertex next = 0;
    for (Vertex v = 0; v < graph->vertexCount(); ++v)
        if (components.of(v) == components.largest())
            numbers[v] = next++;
    std::vector<Graph::Edge> kept;
    for (const Graph::Edge &edge : edges)
        if (numbers[edge.a] != kNoVertex)
            kept.push_back({numbers[edge.a], numbers[edge.b]});
    return Graph::fromEdges(next, kept);
}

/// Every kind of setting, so that each extension is tested with and without the others.
Parameters settingsOf(Seed seed)
{
    Parameters result;
    if (seed % 2 == 0)
        return result; // the default, in every other case
    result.emplace_back("target_isolation", seed / 2 % 3 == 0 ? "strict" : "ordered");
    result.emplace_back("tunnels", seed / 2 % 2 == 0 ? "true" : "false");
    result.emplace_back("repositioning", seed / 4 % 2 == 0 ? "undo" : "counting");
    result.emplace_back("attempt_all", seed / 8 % 2 == 0 ? "true" : "false");
    result.emplace_back("alternate_length", seed / 16 % 2 == 0 ? "6" : "60");
    return result;
}

/// Moves are legal, who was SLIDABLE arrives, and the status says what is true.
void check(const Instance &instance, const Answer &answer)
{
    const Verdict verdict = validate(instance, answer.solution, MotionRule::pebble);
    ASSERT_TRUE(verdict.legal) << verdict.violation;
    const std::vector<Vertex> at = ends(instance, answer.solution);
    for (const Robot r : answer.slidable)
        ASSERT_EQ(at[r], instance.goals[r]) << "robot " << r << " is SLIDABLE";
    ASSERT_EQ(answer.status, at == instance.goals ? PlannerStatus::solved : PlannerStatus::partial);
    ASSERT_EQ(answer.reason.empty(), answer.status == PlannerStatus::solved);
}

TEST(Mapp, EverySlidableRobotArrivesOnGridsWithObstacles)
{
    std::size_t slidable = 0;
    std::size_t robots = 0;
    for (Seed seed = 1; seed <= 700; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto graph =
            gridWithObstacles(4 + random.below(24), 4 + random.below(24), 0.1 + 0.2 * random.uniform(), seed);
        const auto most = static_cast<double>(graph->vertexCount());
        const auto count =
            static_cast<std::size_t>(most * (0.02 + 0.5 * random.uniform() * random.uniform()));
        const Instance instance = randomInstance(graph, count, seed);
        const Answer answer = plan(instance, settingsOf(seed));
        check(instance, answer);
        if (HasFatalFailure())
            return;
        slidable += answer.slidable.size();
        robots += count;
    }
    RecordProperty("slidable", std::to_string(slidable) + " of " + std::to_string(robots));
    EXPECT_GT(slidable * 3, robots);
}

TEST(Mapp, EverySlidableRobotArrivesOnGeneralGraphs)
{
    std::size_t slidable = 0;
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t vertices = 5 + random.below(150);
        const auto graph = test::randomConnectedGraph(vertices, random.below(2 * vertices), seed);
        const Instance instance = randomInstance(graph, 1 + random.below(vertices / 2), seed);
        const Answer answer = plan(instance, settingsOf(seed));
        check(instance, answer);
        if (HasFatalFailure())
            return;
        slidable += answer.slidable.size();
    }
    EXPECT_GT(slidable, 1000U);
}

TEST(Mapp, SolvesAnOpenGridWithRoom)
{
    const Instance instance = randomInstance(test::gridGraph(40, 40), 160, 3);
    const Answer answer = plan(instance);
    EXPECT_EQ(answer.status, PlannerStatus::solved) << answer.reason;
    EXPECT_TRUE(validate(instance, answer.solution, MotionRule::pebble).valid());
    EXPECT_GT(answer.slidable.size(), 120U);
}

TEST(Mapp, PassesThroughATunnelOnlyWithTheExtension)
{
    // Two squares, joined by a corridor of three vertices: 0–3, 4 5 6, 7–10.
    const auto graph = Graph::fromEdges(
        11,
        {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 10}, {10, 9}, {9, 7}});
    const Instance instance{graph, {0}, {10}};
    EXPECT_EQ(plan(instance, {{"tunnels", "true"}}).slidable.size(), 1U);
    EXPECT_EQ(plan(instance, {{"tunnels", "false"}}).slidable.size(), 0U);
    // It goes all the same if it is allowed to try; not otherwise.
    EXPECT_EQ(plan(instance, {{"tunnels", "false"}}).status, PlannerStatus::solved);
    const Answer refused = plan(instance, {{"tunnels", "false"}, {"attempt_all", "false"}});
    EXPECT_EQ(refused.status, PlannerStatus::partial);
    EXPECT_TRUE(refused.solution.empty());
    EXPECT_NE(refused.reason.find("passage"), std::string::npos) << refused.reason;
}

TEST(Mapp, GoesFirstAcrossAnothersGoalIfThatIsAllowed)
{
    // A ladder; robot 1's goal is in the way of robot 0 on either rail.
    const auto graph = test::gridGraph(5, 2);
    const Instance instance{graph, {0, 6, 3}, {4, 2, 7}};
    const Answer ordered = plan(instance);
    EXPECT_EQ(ordered.slidable, (std::vector<Robot>{0, 1, 2}));
    EXPECT_EQ(ordered.status, PlannerStatus::solved);
    EXPECT_LT(plan(instance, {{"target_isolation", "strict"}}).slidable.size(), 3U);
}

TEST(Mapp, SaysWhoIsMissingAndWhy)
{
    // Nobody passes on a line.
    const auto line = Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
    const Answer answer = plan({line, {1, 3}, {4, 2}});
    EXPECT_EQ(answer.status, PlannerStatus::partial);
    EXPECT_NE(answer.reason.find("robot"), std::string::npos);
    EXPECT_NE(answer.reason.find("SLIDABLE"), std::string::npos);
}

TEST(Mapp, IsTheSameEveryTimeAndNoWorseWithRestarts)
{
    const Instance instance = randomInstance(gridWithObstacles(20, 20, 0.2, 5), 60, 5);
    const Answer once = plan(instance);
    EXPECT_EQ(plan(instance).solution, once.solution);
    const Answer best = plan(instance, {{"restarts", "10"}, {"threads", "3"}});
    EXPECT_EQ(plan(instance, {{"restarts", "10"}, {"threads", "1"}}).solution, best.solution);
    const auto missing = [&](const Answer &answer)
    {
        const std::vector<Vertex> at = ends(instance, answer.solution);
        std::size_t count = 0;
        for (Robot r = 0; r < at.size(); ++r)
            count += at[r] == instance.goals[r] ? 0U : 1U;
        return count;
    };
    EXPECT_LE(missing(best), missing(once));
}

TEST(Alternates, AreShortestAndAvoidGoalsWhereTheyCan)
{
    // 5 × 5, row by row; around 12, from 11 to 13.
    const auto graph = test::gridGraph(5, 5);
    std::vector<char> isGoal(25, 0);
    mapp::Alternates alternates(*graph, isGoal, 16);
    const auto around = [&](Vertex off)
    {
        const std::uint32_t number = alternates.find(11, 12, 13, off);
        const auto path = alternates.path(number);
        return std::vector<Vertex>(path.begin(), path.end());
    };
    const std::vector<Vertex> above = {8, 7, 6, 11};
    const std::vector<Vertex> below = {18, 17, 16, 11};
    const auto first = around(kNoVertex);
    ASSERT_TRUE(first == above || first == below);
    EXPECT_EQ(around(first[1]), first == above ? below : above);
    isGoal[first[1]] = 1;
    mapp::Alternates others(*graph, isGoal, 16);
    const auto path = others.path(others.find(11, 12, 13, kNoVertex));
    EXPECT_EQ(std::vector<Vertex>(path.begin(), path.end()), first == above ? below : above);
    mapp::Alternates tooShort(*graph, isGoal, 3);
    EXPECT_EQ(tooShort.find(11, 12, 13, kNoVertex), mapp::Alternates::kNone);
    EXPECT_NE(tooShort.find(11, 12, 17, kNoVertex), mapp::Alternates::kNone);
}

} // namespace
} // namespace mrpp
