#include "algorithms/pebble/PebbleOperations.h"

#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

/// A board whose robots stand on the given vertices (goals do not matter).
struct Table
{
    Table(std::shared_ptr<const Graph> graph, std::vector<Vertex> starts)
        : instance{std::move(graph), starts, starts}, board(instance), operations(board, ptc)
    {}

    [[nodiscard]] std::vector<Vertex> positions() const
    {
        std::vector<Vertex> list;
        for (Robot r = 0; r < board.robotCount(); ++r)
            list.push_back(board.position(r));
        return list;
    }

    TerminationCondition ptc;
    Instance instance;
    PebbleBoard board;
    PebbleOperations operations;
};

TEST(PebbleBoard, TakesMovesBack)
{
    Table table(test::gridGraph(3, 3), {0, 8});
    const auto mark = table.board.mark();
    table.board.move(0, 1);
    table.board.move(0, 2);
    table.board.rollback(mark);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{0, 8}));
    EXPECT_TRUE(table.board.moves().empty());
    EXPECT_TRUE(table.board.isFree(1));
}

TEST(PebbleBoard, TakesRotationsBack)
{
    Table table(Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}}), {0, 1, 2});
    const std::vector<Vertex> triangle = {0, 1, 2};
    table.board.move(0, 3);
    table.board.move(0, 0);
    const auto mark = table.board.mark();
    table.board.rotate(triangle);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2, 0}));
    table.board.rotate(triangle);
    table.board.move(1, 3);
    table.board.rollback(mark);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{0, 1, 2}));
    table.board.rollback(0);
    EXPECT_TRUE(table.board.moves().empty());
    EXPECT_EQ(table.board.takeSolution().actionCount(), 0U);
}

TEST(PebbleBoard, ReversesRotations)
{
    Table table(Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}}), {0, 1, 2});
    const std::vector<Vertex> triangle = {0, 1, 2};
    table.board.rotate(triangle);
    table.board.move(2, 3);
    table.board.move(2, 0);
    const auto first = table.board.mark();
    table.board.rotate(triangle);
    table.board.rotate(triangle);
    table.board.move(0, 3);
    table.board.move(0, 0);
    table.board.reverse(first, table.board.mark(), 0, 0);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2, 0}));
    table.board.reverse(0, first, 0, 0);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{0, 1, 2}));
    const Solution solution = table.board.takeSolution();
    EXPECT_EQ(solution.pathLength(), 26U);
    EXPECT_EQ(solution.actionCount(), 14U);
    EXPECT_TRUE(validate(table.instance, solution, MotionRule::rotation).valid());
}

TEST(PebbleBoard, ReplaysWhatWasCut)
{
    Table table(Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}}), {0, 1, 2});
    const std::vector<Vertex> triangle = {0, 1, 2};
    const std::vector<Vertex> backwards = {2, 1, 0};
    table.board.rotate(triangle);
    table.board.rotate(triangle);
    table.board.move(1, 3);
    const Solution forth = table.board.cut(0);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{0, 1, 2}));
    table.board.replay(forth);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{2, 3, 1}));

    const auto mark = table.board.mark();
    table.board.move(1, 0);
    table.board.rotate(backwards);
    table.board.move(2, 3);
    const Solution back = table.board.cut(mark);
    table.board.replay(back);
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2, 3}));
    const Solution solution = table.board.takeSolution();
    EXPECT_EQ(solution.pathLength(), 4U) << "the way back takes the last two actions back";
    EXPECT_EQ(solution.actionCount(), 2U);
}

TEST(ClearVertex, ShiftsEverybodyOnTheShortestWayToAFreeVertex)
{
    // 0-1-2-3-4, robots on 0 1 2: freeing 1 pushes robots 1 and 2 outwards.
    Table table(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}), {0, 1, 2});
    ASSERT_TRUE(table.operations.clearVertex(1, {{0}}));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{0, 2, 3}));
    EXPECT_EQ(table.board.moves().size(), 2U);
}

TEST(ClearVertex, LeavesTheBoardWhereNoFreeVertexCanBeReached)
{
    Table table(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}), {0, 1, 2});
    EXPECT_FALSE(table.operations.clearVertex(1, {{2}}));
    EXPECT_FALSE(table.operations.clearVertex(1, {{1}}));
    EXPECT_TRUE(table.board.moves().empty());
}

TEST(ClearVertex, KeepsThePathClearWhereItCan)
{
    // A corridor 0-1-2 with a bay 3 at 1: the robot on 1 goes into the bay, not along the path.
    Table table(Graph::fromEdges(4, {{0, 1}, {1, 2}, {1, 3}}), {0, 1});
    table.operations.avoid(std::vector<Vertex>{0, 1, 2});
    ASSERT_TRUE(table.operations.clearVertex(1, {{0}}));
    EXPECT_EQ(table.board.position(1), 3U);
}

TEST(Push, SparesRobotsThatStay)
{
    Table table(Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}}), {0, 1});
    const std::vector<char> stay = {0, 1};
    EXPECT_FALSE(table.operations.push(0, 1, &stay));
    EXPECT_TRUE(table.operations.push(0, 1, nullptr));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2}));
}

TEST(Swap, ExchangesTheRobotsAtAJunctionInSixMoves)
{
    // The centre 0 of a star: robot 0 on it, robot 1 on a leaf, two leaves free.
    Table table(Graph::fromEdges(4, {{0, 1}, {0, 2}, {0, 3}}), {0, 1});
    ASSERT_TRUE(table.operations.swap(0, 1));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 0}));
    EXPECT_EQ(table.board.moves().size(), 6U);
}

TEST(Swap, FailsWithoutAJunctionAndLeavesTheBoard)
{
    Table table(Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}), {1, 2});
    EXPECT_FALSE(table.operations.swap(0, 1));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2}));
    EXPECT_TRUE(table.board.moves().empty());
}

TEST(Swap, StopsWhenAsked)
{
    Table table(Graph::fromEdges(4, {{0, 1}, {0, 2}, {0, 3}}), {0, 1});
    table.ptc = TerminationCondition::after(0);
    EXPECT_FALSE(table.operations.swap(0, 1));
    EXPECT_TRUE(table.board.moves().empty());
}

/// On boards of every density: a swap exchanges the two, moves nobody else, and a failing one changes
/// nothing.
TEST(Swap, MovesNobodyElse)
{
    std::size_t succeeded = 0;
    for (Seed seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        const auto vertices = static_cast<std::size_t>(4 + random.below(12));
        const auto graph = test::randomConnectedGraph(vertices, random.below(6), seed);
        const auto robots = 2 + random.below(vertices - 2);
        Table table(graph, randomInstance(graph, robots, seed).starts);
        const auto before = table.positions();
        const auto r = static_cast<Robot>(random.below(robots));
        const auto around = graph->neighbors(before[r]);
        const Robot s = table.board.occupant(around[random.below(around.size())]);
        if (s == kNoRobot)
            continue;
        auto expected = before;
        if (table.operations.swap(r, s))
        {
            std::swap(expected[r], expected[s]);
            ++succeeded;
        }
        else
        {
            EXPECT_TRUE(table.board.moves().empty());
        }
        ASSERT_EQ(table.positions(), expected) << "seed " << seed;
    }
    EXPECT_GT(succeeded, 1000U);
}

/// Boards on which *clear* needs its later stages (two free vertices, everything else full).
TEST(Swap, ClearsJunctionsThroughAllItsStages)
{
    struct Case
    {
        std::shared_ptr<const Graph> graph;
        std::vector<Vertex> starts;
    };
    const std::vector<Case> cases = {
        {Graph::fromEdges(5, {{0, 1}, {0, 2}, {0, 4}, {1, 2}, {2, 3}}), {0, 1, 2}},
        {Graph::fromEdges(5, {{0, 1}, {1, 3}, {1, 4}, {2, 3}, {2, 4}}), {0, 1, 2}},
        {Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 3}}), {0, 1, 2, 3}},
    };
    for (const Case &c : cases)
    {
        Table table(c.graph, c.starts);
        EXPECT_TRUE(table.operations.swap(0, 1));
        EXPECT_EQ(table.board.position(0), c.starts[1]);
        EXPECT_EQ(table.board.position(1), c.starts[0]);
        EXPECT_EQ(table.board.position(2), c.starts[2]);
    }
}

} // namespace
} // namespace mrpp
