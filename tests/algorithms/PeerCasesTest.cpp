/// \file
/// Planners on the cases on which published programs were measured. Times are multiples of one breadth-first
/// search over the same map, taken in the same run, so that they compare across machines.

#include "algorithms/Algorithms.h"
#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Catalog.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Validator.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/MovingAiScenario.h"
#include "tests/support/CpuClock.h"

#include <algorithm>
#include <gtest/gtest.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

namespace mrpp
{
namespace
{

std::unique_ptr<Planner> plannerOf(const std::string &name)
{
    Catalog catalog;
    registerAlgorithms(catalog);
    return catalog.planners.create(name);
}

struct PeerCase
{
    const char *planner;
    const char *name;
    const char *map;
    const char *scenario;
    std::size_t robots;
    double searches; ///< most time, in breadth-first searches
    double ratio;    ///< most moves after optimizing, over the lower bound
};

class PeerCases : public testing::TestWithParam<PeerCase>
{};

TEST_P(PeerCases, AreSolvedFastAndShort)
{
    const std::filesystem::path data = MRPP_SHARED_DATA;
    if (!std::filesystem::exists(data / "peer-cases"))
        GTEST_SKIP() << "no peers' cases in " << data;
    const GridMap map = readMovingAiMap(data / GetParam().map);
    const Scenario scenario = readMovingAiScenario(data / "peer-cases" / GetParam().scenario);
    const auto instance = std::make_shared<Instance>(scenarioInstance(scenario, map, GetParam().robots));

    // The best of a few tries on either side: other work on the machine only ever makes them slower.
    double fastestSearch = 1e9;
    double fastestPlan = 1e9;
    const auto planner = plannerOf(GetParam().planner);
    planner->setInstance(instance);
    planner->setup();
    BreadthFirstSearch search(*instance->graph);
    for (int i = 0; i < (kSanitized ? 1 : 5); ++i)
    {
        for (int j = 0; j < 5; ++j)
        {
            const double start = test::cpuSeconds();
            search.run(instance->starts[static_cast<std::size_t>(j)]);
            fastestSearch = std::min(fastestSearch, test::cpuSeconds() - start);
        }
        const double start = test::cpuSeconds();
        ASSERT_EQ(planner->solve(TerminationCondition::after(120)), PlannerStatus::solved)
            << planner->reason();
        fastestPlan = std::min(fastestPlan, test::cpuSeconds() - start);
    }
    const Solution solution = planner->takeSolution();
    const Verdict verdict = validate(*instance, solution, planner->specs().motion);
    EXPECT_TRUE(verdict.valid()) << verdict.violation;
    const Solution optimized = RedundancyRemoval().improve(*instance, solution, {});
    EXPECT_TRUE(validate(*instance, optimized, planner->specs().motion).valid());

    const auto bounds = lowerBounds(*instance);
    ASSERT_TRUE(bounds);
    EXPECT_LE(static_cast<double>(optimized.pathLength()),
              GetParam().ratio * static_cast<double>(bounds->pathLength));
    if (!kSanitized)
    {
        EXPECT_LE(fastestPlan / fastestSearch, GetParam().searches);
    }
}

const char *const kGameMap = "movingai/bg512/AR0603SR.map";
const char *const kRandomMap = "movingai/mapf/random-64-64-20.map";
const char *const kWarehouse = "movingai/mapf/warehouse-10-20-10-2-1.map";

INSTANTIATE_TEST_SUITE_P(
    PushAndSwap, PeerCases,
    testing::Values(
        PeerCase{"push_and_swap", "AR0603SR_600", kGameMap, "AR0603SR.scen", 600, 200, 1.001},
        PeerCase{"push_and_swap", "AR0603SR_2000", kGameMap, "AR0603SR.scen", 2000, 900, 1.01},
        PeerCase{"push_and_swap", "random_400", kRandomMap, "random-64-64-20.scen", 400, 5000, 1.06},
        PeerCase{"push_and_swap", "random_2000", kRandomMap, "random-64-64-20.scen", 2000, 20000, 1.9},
        PeerCase{"push_and_swap", "warehouse_400", kWarehouse, "warehouse-10-20-10-2-1.scen", 400, 5000,
                 1.06},
        PeerCase{"push_and_swap", "warehouse_2000", kWarehouse, "warehouse-10-20-10-2-1.scen", 2000, 20000,
                 1.5},
        PeerCase{"push_and_swap", "grid10_two_free", "peer-cases/grid10.map", "grid10-b2-s1.scen", 98, 20000,
                 8}),
    [](const auto &test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    PushAndRotate, PeerCases,
    testing::Values(
        PeerCase{"push_and_rotate", "AR0603SR_600", kGameMap, "AR0603SR.scen", 600, 600, 1.001},
        PeerCase{"push_and_rotate", "AR0603SR_2000", kGameMap, "AR0603SR.scen", 2000, 4000, 1.01},
        PeerCase{"push_and_rotate", "random_400", kRandomMap, "random-64-64-20.scen", 400, 2000, 1.06},
        PeerCase{"push_and_rotate", "random_1000", kRandomMap, "random-64-64-20.scen", 1000, 5000, 1.25},
        PeerCase{"push_and_rotate", "random_2000", kRandomMap, "random-64-64-20.scen", 2000, 20000, 1.9},
        PeerCase{"push_and_rotate", "warehouse_1000", kWarehouse, "warehouse-10-20-10-2-1.scen", 1000, 10000,
                 1.2},
        PeerCase{"push_and_rotate", "warehouse_2000", kWarehouse, "warehouse-10-20-10-2-1.scen", 2000, 20000,
                 1.5}),
    [](const auto &test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    PushAndSpin, PeerCases,
    testing::Values(
        PeerCase{"push_and_spin", "AR0603SR_600", kGameMap, "AR0603SR.scen", 600, 600, 1.001},
        PeerCase{"push_and_spin", "AR0603SR_2000", kGameMap, "AR0603SR.scen", 2000, 4000, 1.01},
        PeerCase{"push_and_spin", "random_1000", kRandomMap, "random-64-64-20.scen", 1000, 5000, 1.25},
        PeerCase{"push_and_spin", "random_2000", kRandomMap, "random-64-64-20.scen", 2000, 40000, 1.9},
        PeerCase{"push_and_spin", "warehouse_1000", kWarehouse, "warehouse-10-20-10-2-1.scen", 1000, 10000,
                 1.2},
        PeerCase{"push_and_spin", "warehouse_2000", kWarehouse, "warehouse-10-20-10-2-1.scen", 2000, 40000,
                 1.5}),
    [](const auto &test) { return std::string(test.param.name); });

struct FullGrid
{
    int side;
    std::size_t moves;   ///< after optimizing, mean of three cases: what a published program needs
    double milliseconds; ///< processor time
};

class GridsWithTwoFreeVertices : public testing::TestWithParam<FullGrid>
{};

TEST_P(GridsWithTwoFreeVertices, AreSolvedWithFewerMovesThanPublished)
{
    const std::filesystem::path data = std::filesystem::path(MRPP_SHARED_DATA) / "peer-cases";
    if (!std::filesystem::exists(data))
        GTEST_SKIP() << "no peers' cases in " << data;
    const std::string grid = "grid" + std::to_string(GetParam().side);
    const GridMap map = readMovingAiMap(data / (grid + ".map"));
    const auto robots = static_cast<std::size_t>(GetParam().side * GetParam().side - 2);
    std::size_t moves = 0;
    double seconds = 0;
    for (const char *number : {"1", "2", "3"})
    {
        const Scenario scenario = readMovingAiScenario(data / (grid + "-b2-s" + number + ".scen"));
        const auto instance = std::make_shared<Instance>(scenarioInstance(scenario, map, robots));
        const auto planner = plannerOf("push_and_rotate");
        planner->setInstance(instance);
        planner->setup();
        double fastest = 1e9;
        for (int i = 0; i < 5; ++i)
        {
            const double start = test::cpuSeconds();
            ASSERT_EQ(planner->solve({}), PlannerStatus::solved) << planner->reason();
            fastest = std::min(fastest, test::cpuSeconds() - start);
        }
        seconds += fastest / 3;
        const Solution optimized = RedundancyRemoval().improve(*instance, planner->solution(), {});
        EXPECT_TRUE(validate(*instance, optimized, MotionRule::pebble).valid());
        moves += optimized.pathLength();
    }
    EXPECT_LE(moves, 3 * GetParam().moves);
    if (!kSanitized)
    {
        EXPECT_LE(1e3 * seconds, GetParam().milliseconds);
    }
}

INSTANTIATE_TEST_SUITE_P(Published, GridsWithTwoFreeVertices,
                         testing::Values(FullGrid{4, 189, 1}, FullGrid{6, 910, 5}, FullGrid{8, 2604, 20},
                                         FullGrid{10, 5229, 60}),
                         [](const auto &test) { return "side_" + std::to_string(test.param.side); });

} // namespace
} // namespace mrpp
