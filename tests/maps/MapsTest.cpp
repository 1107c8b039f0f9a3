/// \file
/// A sample of what the target `maps` does, and what other components must not change.

#include "tests/maps/MapCheck.h"

#include "framework/Problem.h"
#include "problems/formats/MovingAiMap.h"
#include "tests/contract/EverythingRegistered.h"

#include <gtest/gtest.h>

namespace mrpp::test
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

const Catalog &catalog()
{
    static const Catalog kCatalog = everythingRegistered();
    return kCatalog;
}

std::shared_ptr<const Graph> mapOrNothing(const char *name)
{
    const auto file = std::filesystem::path(MRPP_SHARED_DATA) / "movingai" / name;
    return std::filesystem::exists(file) ? readMovingAiMap(file).graph : nullptr;
}

class Maps : public testing::TestWithParam<const char *>
{};

TEST_P(Maps, AreSolvedNearTheLowerBound)
{
    const auto graph = mapOrNothing(GetParam());
    if (!graph)
        GTEST_SKIP() << "no map " << GetParam() << " in " << MRPP_SHARED_DATA;
    const auto instance = std::make_shared<const Instance>(randomInstance(graph, 500, 7));
    for (const char *name : {"push_and_rotate", "push_and_swap"})
    {
        const auto planner = catalog().planners.create(name);
        const PlanningFigures figures = measurePlanning(*planner, instance, 120);
        EXPECT_EQ(figures.complaint, "") << name;
        EXPECT_LE(figures.ratio, 1.02) << name;
        if (!kSanitized)
        {
            EXPECT_LE(figures.searches, 2000) << name;
        }
    }
}

TEST_P(Maps, HavePathsWithinTheirWeights)
{
    const auto graph = mapOrNothing(GetParam());
    if (!graph)
        GTEST_SKIP() << "no map " << GetParam() << " in " << MRPP_SHARED_DATA;
    const Instance instance = randomInstance(graph, 60, 7);
    const PathFigures learnt = measurePaths(instance, 0);
    EXPECT_EQ(learnt.broken, 0U);
    EXPECT_LE(static_cast<double>(learnt.length), 1.1 * static_cast<double>(learnt.distance));
    PathFigures before = measurePaths(instance, 1);
    EXPECT_EQ(before.length, before.distance);
    for (const double weight : {1.25, 1.5, 2.0})
    {
        const PathFigures figures = measurePaths(instance, weight);
        EXPECT_EQ(figures.broken, 0U) << weight;
        EXPECT_LE(figures.visits, before.visits) << weight;
        before = figures;
    }
}

INSTANTIATE_TEST_SUITE_P(Sample, Maps,
                         testing::Values("bg-original/AR0700SR.map", "mapf/Paris_1_256.map",
                                         "mapf/w_woundedcoast.map", "mapf/maze-128-128-10.map"),
                         [](const auto &test) { return "map_" + std::to_string(test.index); });

/// The grid's cells, and isolated ones between them.
std::shared_ptr<const Graph> gridWithIsolatedCells(std::size_t side, std::size_t isolated)
{
    // A wall with isolated cells in every other place of every other row below the grid.
    std::string cells(side * side, '.');
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < side; ++column)
        {
            const bool open = row % 2 == 1 && column % 2 == 1 && isolated > 0;
            isolated -= open ? 1 : 0;
            cells.push_back(open ? '.' : '@');
        }
    return makeGridMap(side, side + 4, std::move(cells)).graph;
}

TEST(IsolatedCells, ChangeNoMove)
{
    constexpr std::size_t kSide = 40;
    for (const std::size_t robots : {60, 1400})
        for (const char *name : {"push_and_rotate", "push_and_swap", "push_and_spin"})
        {
            std::size_t moves = 0;
            for (const std::size_t isolated : {0, 1, 15})
            {
                const auto instance = std::make_shared<const Instance>(
                    randomInstance(gridWithIsolatedCells(kSide, isolated), robots, 3));
                const auto planner = catalog().planners.create(name);
                const PlanningFigures figures = measurePlanning(*planner, instance, 60);
                EXPECT_EQ(figures.complaint, "") << name;
                if (isolated == 0)
                    moves = figures.moves;
                EXPECT_EQ(figures.moves, moves) << name << ", " << robots << " robots, " << isolated;
            }
        }
}

} // namespace
} // namespace mrpp::test
