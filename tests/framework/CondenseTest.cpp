#include "framework/evaluation/Condense.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/BruteForce.h"
#include "tests/support/RandomCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

constexpr MotionRule kParallelRules[] = {MotionRule::parallel, MotionRule::following, MotionRule::rotation};

std::size_t makespan(const test::SolvedCase &test, MotionRule rule)
{
    return condense(test.instance, test.solution, rule).makespan();
}

/// Robots 0, 1, 2 in a row on a path of 6 vertices; all go one vertex to the right.
test::SolvedCase queue()
{
    return {{Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}), {2, 1, 0}, {3, 2, 1}},
            Solution({{0, 2, 3}, {1, 1, 2}, {2, 0, 1}})};
}

/// Robots on a triangle 0–1–2 that turn, then robot 0 leaves for vertex 3 and robot 3 comes from 4 to 1.
test::SolvedCase turnAndLeave()
{
    const Move turn[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};
    test::SolvedCase test{
        {Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}, {1, 3}, {1, 4}}), {0, 1, 2, 4}, {3, 2, 0, 1}}, {}};
    test.solution.appendRotation(turn);
    test.solution.append({0, 1, 3});
    test.solution.append({3, 4, 1});
    return test;
}

TEST(Condense, UnderPebbleAnActionIsAStep)
{
    EXPECT_THAT(moveSteps(queue().instance, queue().solution, MotionRule::pebble), ElementsAre(0, 1, 2));
    EXPECT_THAT(moveSteps(turnAndLeave().instance, turnAndLeave().solution, MotionRule::pebble),
                ElementsAre(0, 0, 0, 1, 2));
}

TEST(Condense, UnderParallelAVertexIsEnteredAStepAfterItWasLeft)
{
    EXPECT_THAT(moveSteps(queue().instance, queue().solution, MotionRule::parallel), ElementsAre(0, 1, 2));
}

TEST(Condense, UnderFollowingAVertexIsEnteredInTheStepInWhichItIsLeft)
{
    EXPECT_THAT(moveSteps(queue().instance, queue().solution, MotionRule::following), ElementsAre(0, 0, 0));
    EXPECT_EQ(condense(queue().instance, queue().solution, MotionRule::following),
              Schedule({{0, 2, 3}, {1, 1, 2}, {2, 0, 1}}, {3}));
}

TEST(Condense, RotationsStayTogetherUnderEveryRule)
{
    const auto test = turnAndLeave();
    EXPECT_THAT(moveSteps(test.instance, test.solution, MotionRule::parallel), ElementsAre(0, 0, 0, 1, 2));
    EXPECT_THAT(moveSteps(test.instance, test.solution, MotionRule::following), ElementsAre(0, 0, 0, 1, 1));
    EXPECT_THAT(moveSteps(test.instance, test.solution, MotionRule::rotation), ElementsAre(0, 0, 0, 1, 1));
}

TEST(Condense, ARotationWaitsForTheLastOfItsRobots)
{
    // Robot 2 needs a move before the triangle is closed; robots 0 and 1 have been there from the start.
    const Move turn[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};
    Solution solution;
    solution.append({2, 3, 2});
    solution.appendRotation(turn);
    const Instance instance{Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 0}, {2, 3}}), {0, 1, 3}, {1, 2, 0}};
    EXPECT_THAT(moveSteps(instance, solution, MotionRule::rotation), ElementsAre(0, 1, 1, 1));
}

TEST(Condense, OrdersTheMovesOfAStepByRobot)
{
    const Instance instance{Graph::fromEdges(6, {{0, 1}, {2, 3}, {4, 5}}), {0, 2, 4}, {1, 3, 5}};
    const Solution solution({{2, 4, 5}, {0, 0, 1}, {1, 2, 3}});
    EXPECT_EQ(condense(instance, solution, MotionRule::parallel),
              Schedule({{0, 0, 1}, {1, 2, 3}, {2, 4, 5}}, {3}));
}

TEST(Condense, NothingHasNoSteps)
{
    const Instance instance{Graph::fromEdges(2, {{0, 1}}), {0}, {0}};
    for (const MotionRule rule : kParallelRules)
        EXPECT_EQ(condense(instance, {}, rule), Schedule());
    EXPECT_EQ(condense(instance, {}, MotionRule::pebble), Schedule());
}

/// The precedences written out: a weighted arc between any two actions of which one must wait for the other,
/// then the longest path to each action by trying all arcs.
std::vector<std::uint32_t> longestPaths(const Solution &solution, MotionRule rule)
{
    std::vector<std::vector<Move>> actions;
    solution.forEachAction([&](std::span<const Move> action)
                           { actions.emplace_back(action.begin(), action.end()); });
    const std::uint32_t delay = rule == MotionRule::parallel ? 1 : 0;
    std::vector<std::uint32_t> begin(actions.size(), 0);
    std::vector<std::uint32_t> steps;
    for (std::size_t late = 0; late < actions.size(); ++late)
    {
        for (std::size_t early = 0; early < late; ++early)
        {
            for (const Move &x : actions[early])
            {
                for (const Move &y : actions[late])
                {
                    if (x.robot == y.robot)
                        begin[late] = std::max(begin[late], begin[early] + 1);
                    if (x.from == y.to)
                        begin[late] = std::max(begin[late], begin[early] + delay);
                }
            }
        }
        steps.insert(steps.end(), actions[late].size(), begin[late]);
    }
    return steps;
}

/// The least makespan of all schedules in which each robot takes its path and each vertex is visited by the
/// same robots in the same order: breadth-first search over how far each robot has come.
class FixedOrderSearch
{
public:
    FixedOrderSearch(const test::SolvedCase &test, MotionRule rule) : rule_(rule)
    {
        paths_.resize(test.instance.robotCount());
        std::vector<std::uint32_t> visits(test.instance.graph->vertexCount(), 0);
        for (std::size_t robot = 0; robot < paths_.size(); ++robot)
            paths_[robot].push_back({test.instance.starts[robot], visits[test.instance.starts[robot]]++});
        for (const Move &move : test.solution.moves())
            paths_[move.robot].push_back({move.to, visits[move.to]++});
    }

    std::uint32_t leastMakespan() const
    {
        std::set<Progress> rim = {Progress(paths_.size(), 0)};
        std::set<Progress> seen = rim;
        Progress end;
        for (const auto &path : paths_)
            end.push_back(path.size() - 1);
        for (std::uint32_t steps = 0;; ++steps)
        {
            if (rim.contains(end))
                return steps;
            std::set<Progress> next;
            for (const Progress &progress : rim)
                for (std::uint32_t movers = 1; movers < (1U << paths_.size()); ++movers)
                    if (const auto reached = advance(progress, movers);
                        reached && seen.insert(*reached).second)
                        next.insert(*reached);
            RC_ASSERT(!next.empty());
            rim = std::move(next);
        }
    }

private:
    struct Visit
    {
        Vertex vertex;
        std::uint32_t turn; ///< how many visits the vertex had before
    };
    using Progress = std::vector<std::size_t>;

    [[nodiscard]] std::optional<Progress> advance(const Progress &before, std::uint32_t movers) const
    {
        Progress after = before;
        for (std::size_t robot = 0; robot < before.size(); ++robot)
        {
            if ((movers >> robot & 1U) != 0 && ++after[robot] >= paths_[robot].size())
                return std::nullopt;
        }
        std::map<Vertex, std::size_t> standing;
        std::map<Vertex, std::size_t> entered;
        for (std::size_t robot = 0; robot < before.size(); ++robot)
        {
            standing[paths_[robot][before[robot]].vertex] = robot;
            if (!entered.emplace(paths_[robot][after[robot]].vertex, robot).second)
                return std::nullopt;
        }
        for (std::size_t robot = 0; robot < before.size(); ++robot)
        {
            if (after[robot] == before[robot])
                continue;
            const Visit &visit = paths_[robot][after[robot]];
            if (visitsBefore(after, visit.vertex) != visit.turn)
                return std::nullopt;
            const auto ahead = standing.find(visit.vertex);
            if (ahead == standing.end())
                continue;
            const std::size_t other = ahead->second;
            if (rule_ == MotionRule::parallel ||
                paths_[other][after[other]].vertex == paths_[robot][before[robot]].vertex)
                return std::nullopt;
        }
        return after;
    }

    /// How many visits of the vertex lie before the one that is on now.
    [[nodiscard]] std::uint32_t visitsBefore(const Progress &progress, Vertex vertex) const
    {
        std::uint32_t count = 0;
        for (std::size_t robot = 0; robot < progress.size(); ++robot)
            for (std::size_t i = 0; i < progress[robot]; ++i)
                count += paths_[robot][i].vertex == vertex ? 1 : 0;
        return count;
    }

    MotionRule rule_;
    std::vector<std::vector<Visit>> paths_;
};

/// Small and large cases alike, whatever rapidcheck's size is.
std::size_t pick(std::size_t low, std::size_t high)
{
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

test::SolvedCase arbitraryCase(std::size_t maxVertices, std::size_t maxRobots, std::size_t maxMoves,
                               bool rotations)
{
    const auto seed = *rc::gen::arbitrary<Seed>();
    const std::size_t vertices = pick(2, maxVertices);
    const std::size_t robots = pick(1, std::min(rotations ? vertices : vertices - 1, maxRobots));
    const std::size_t moves = pick(0, maxMoves);
    const auto graph = test::randomConnectedGraph(vertices, pick(0, vertices), seed);
    return rotations ? test::randomSolvedCaseWithRotations(graph, robots, moves, seed)
                     : test::randomSolvedCase(graph, robots, moves, seed);
}

RC_GTEST_PROP(Condense, IsTheLongestPathOfThePrecedences, (bool rotations))
{
    const auto test = arbitraryCase(12, 8, 60, rotations);
    for (const MotionRule rule : kParallelRules)
        RC_ASSERT(moveSteps(test.instance, test.solution, rule) == longestPaths(test.solution, rule));
}

RC_GTEST_PROP(Condense, NoScheduleOfTheSameVisitsIsShorter, ())
{
    const auto test = arbitraryCase(6, 3, 9, false);
    for (const MotionRule rule : kParallelRules)
        RC_ASSERT(makespan(test, rule) == FixedOrderSearch(test, rule).leastMakespan());
}

RC_GTEST_PROP(Condense, IsLegalUnderItsRuleAndEndsAtTheGoals, (bool rotations))
{
    const auto test = arbitraryCase(12, 8, 60, rotations);
    for (const MotionRule rule : kParallelRules)
    {
        // Rotations stay, so their own rule is needed where there are any; nothing else needs more.
        const MotionRule needed = test.solution.rotations().empty() ? rule : MotionRule::rotation;
        const Schedule schedule = condense(test.instance, test.solution, rule);
        const Verdict verdict = validate(test.instance, schedule, needed);
        RC_ASSERT(verdict.violation == "");
        RC_ASSERT(verdict.valid());
        RC_ASSERT(schedule.pathLength() == test.solution.pathLength());
        for (std::size_t step = 0; step < schedule.makespan(); ++step)
            RC_ASSERT(!schedule.step(step).empty());
    }
}

RC_GTEST_PROP(Condense, WiderRulesNeverTakeMoreSteps, (bool rotations))
{
    const auto test = arbitraryCase(12, 8, 60, rotations);
    const std::size_t pebble = makespan(test, MotionRule::pebble);
    const std::size_t parallel = makespan(test, MotionRule::parallel);
    const std::size_t following = makespan(test, MotionRule::following);
    const std::size_t rotation = makespan(test, MotionRule::rotation);
    RC_ASSERT(rotation <= following);
    RC_ASSERT(following <= parallel);
    RC_ASSERT(parallel <= pebble);
    RC_ASSERT(pebble == test.solution.actionCount());

    const auto bounds = lowerBounds(test.instance);
    RC_ASSERT(bounds.has_value());
    RC_ASSERT(bounds->makespan <= rotation);
    RC_ASSERT(bounds->pathLength <= test.solution.pathLength());
}

RC_GTEST_PROP(Condense, IsNoShorterThanTheShortestOfAllSolutions, ())
{
    const auto test = arbitraryCase(6, 3, 20, false);
    for (const MotionRule rule : kParallelRules)
        RC_ASSERT(makespan(test, rule) >= *test::leastMakespan(test.instance, rule));
    RC_ASSERT(test.solution.pathLength() >= *test::fewestMoves(test.instance));
}

RC_GTEST_PROP(Condense, WhatIsCondensedAlreadyStaysAsItIs, (bool rotations))
{
    const auto test = arbitraryCase(12, 8, 60, rotations);
    const Schedule schedule = condense(test.instance, test.solution, MotionRule::rotation);
    const Solution again = schedule.toSolution(test.instance.graph->vertexCount());
    RC_ASSERT(condense(test.instance, again, MotionRule::rotation) == schedule);
}

} // namespace
} // namespace mrpp
