#include "algorithms/pebble/SpinOperations.h"

#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"
#include "tests/support/SmallGraphs.h"

#include <bit>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

/// A board whose robots stand on the given vertices (goals do not matter).
struct Table
{
    Table(std::shared_ptr<const Graph> graph, std::vector<Vertex> starts)
        : instance{std::move(graph), starts, starts}, blocks(*instance.graph), board(instance),
          operations(board, blocks, ptc)
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
    Blocks blocks;
    PebbleBoard board;
    SpinOperations operations;
};

TEST(CycleSearch, FindsShortestCyclesThroughAnEdge)
{
    const auto graph = test::gridGraph(3, 3);
    const TerminationCondition never;
    CycleSearch cycles(*graph, never);
    const auto none = [](Vertex) { return false; };
    EXPECT_EQ(cycles.through(0, 1, 9, none), (std::vector<Vertex>{0, 1, 4, 3}));
    EXPECT_TRUE(cycles.through(0, 1, 3, none).empty());
    EXPECT_EQ(cycles.through(0, 1, 9, [](Vertex v) { return v == 4; }).size(), 8U);
    EXPECT_TRUE(cycles.through(0, 1, 9, [](Vertex v) { return v == 4 || v == 7; }).empty());
}

TEST(CycleSearch, FindsShortestCyclesAtAVertex)
{
    // A square 0 1 2 3 and a triangle 0 4 5 with a tail 6.
    const auto graph = Graph::fromEdges(7, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 0}, {5, 6}});
    const TerminationCondition never;
    CycleSearch cycles(*graph, never);
    const auto sorted = [](std::vector<Vertex> list)
    {
        std::sort(list.begin(), list.end());
        return list;
    };
    EXPECT_EQ(sorted(cycles.at(0, 6)), (std::vector<Vertex>{0, 4, 5}));
    EXPECT_EQ(sorted(cycles.at(0, 4)), (std::vector<Vertex>{0, 1, 2, 3}));
    EXPECT_EQ(cycles.at(2, 6).front(), 2U);
    EXPECT_TRUE(cycles.at(2, 1).empty());
    EXPECT_TRUE(cycles.at(6, 0).empty());
}

TEST(Spin, PushTurnsAFullCycleWhereThatIsShorter)
{
    // A full triangle at the end of a full corridor whose free vertex is far away.
    Table table(Graph::fromEdges(8, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}}),
                {0, 1, 2, 3, 4, 5, 6});
    ASSERT_TRUE(table.operations.push(0, 1, nullptr));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{1, 2, 0, 3, 4, 5, 6}));
    EXPECT_EQ(table.board.takeSolution().actionCount(), 1U);
}

TEST(Spin, PushDoesNotTurnRobotsThatStay)
{
    Table table(Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}}), {0, 1, 2});
    const std::vector<char> stay = {0, 0, 1};
    EXPECT_FALSE(table.operations.push(0, 1, &stay));
    EXPECT_TRUE(table.operations.push(0, 1, nullptr));
}

TEST(Spin, RotatesFullCyclesAtOnceAndOthersIntoTheirHoles)
{
    Table full(test::gridGraph(2, 2), {0, 1, 3, 2});
    const std::vector<Vertex> square = {0, 1, 3, 2};
    ASSERT_TRUE(full.operations.rotate(square));
    EXPECT_EQ(full.positions(), (std::vector<Vertex>{1, 3, 2, 0}));
    EXPECT_EQ(full.board.takeSolution().actionCount(), 1U);

    Table two(test::gridGraph(2, 2), {0, 3});
    ASSERT_TRUE(two.operations.rotate(square));
    EXPECT_EQ(two.positions(), (std::vector<Vertex>{1, 2}));
    EXPECT_EQ(two.board.takeSolution().pathLength(), 2U);
}

TEST(Spin, ExchangesAcrossABridgeWithOneFreeVertex)
{
    // Two triangles joined by an edge 0-3; the only free vertex is 1.
    Table table(Graph::fromEdges(6, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 5}, {5, 3}}),
                {0, 2, 3, 4, 5});
    ASSERT_TRUE(table.operations.swap(0, 2));
    EXPECT_EQ(table.positions(), (std::vector<Vertex>{3, 2, 0, 4, 5}));
    EXPECT_EQ(table.board.moves().size(), 8U);
}

TEST(Spin, StopsWhenAsked)
{
    Table table(test::gridGraph(3, 3), {0, 1, 2, 3, 4, 5, 6, 7});
    table.ptc = TerminationCondition::after(0);
    EXPECT_FALSE(table.operations.swap(0, 1));
    EXPECT_TRUE(table.board.moves().empty());
}

/// Every connected graph of up to six vertices, every set of occupied vertices with one free vertex or more,
/// every pair of neighbours: a swap works just where brute force can exchange robots between the two
/// positions, and moves nobody else.
TEST(Spin, SwapsEveryPairThatCanBeSwapped)
{
    std::size_t swapped = 0;
    std::size_t refused = 0;
    for (std::size_t n = 3; n <= 6; ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            if (componentShapes(*graph, Components(*graph))[0] != ComponentShape::branching)
                continue;
            const std::vector<Vertex> orbits = test::positionOrbits(*graph, MotionRule::rotation);
            for (std::size_t set = 1; set + 1 < (std::size_t{1} << n); ++set)
            {
                std::vector<Vertex> occupied;
                for (Vertex v = 0; v < n; ++v)
                    if ((set >> v & 1U) != 0)
                        occupied.push_back(v);
                for (Robot r = 0; r < occupied.size(); ++r)
                {
                    for (Robot s = r + 1; s < occupied.size(); ++s)
                    {
                        if (!graph->hasEdge(occupied[r], occupied[s]))
                            continue;
                        Table table(graph, occupied);
                        const bool possible = orbits[set * n + occupied[r]] == orbits[set * n + occupied[s]];
                        ASSERT_EQ(table.operations.swap(r, s), possible)
                            << "n " << n << " set " << set << " pair " << occupied[r] << " " << occupied[s];
                        std::vector<Vertex> expected = occupied;
                        if (possible)
                            std::swap(expected[r], expected[s]);
                        ASSERT_EQ(table.positions(), expected);
                        table.instance.goals = expected;
                        const Solution solution = table.board.takeSolution();
                        const Verdict verdict = validate(table.instance, solution, MotionRule::rotation);
                        ASSERT_TRUE(verdict.valid()) << verdict.violation;
                        ++(possible ? swapped : refused);
                    }
                }
            }
        }
    }
    EXPECT_GT(swapped, 10000U);
    EXPECT_GT(refused, 100U);
}

} // namespace
} // namespace mrpp
