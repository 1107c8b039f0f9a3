/// \file
/// Push and Swap on the cases on which published programs were measured. Times are multiples of one
/// breadth-first search over the same map, taken in the same run, so that they compare across machines.

#include "algorithms/PushAndSwap.h"
#include "algorithms/optimizers/RedundancyRemoval.h"
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

struct PeerCase
{
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
    PushAndSwap planner;
    planner.setInstance(instance);
    planner.setup();
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
        ASSERT_EQ(planner.solve(TerminationCondition::after(120)), PlannerStatus::solved) << planner.reason();
        fastestPlan = std::min(fastestPlan, test::cpuSeconds() - start);
    }
    const Solution solution = planner.takeSolution();
    const Verdict verdict = validate(*instance, solution, MotionRule::pebble);
    EXPECT_TRUE(verdict.valid()) << verdict.violation;
    const Solution optimized = RedundancyRemoval().improve(*instance, solution, {});
    EXPECT_TRUE(validate(*instance, optimized, MotionRule::pebble).valid());

    const auto bounds = lowerBounds(*instance);
    ASSERT_TRUE(bounds);
    EXPECT_LE(static_cast<double>(optimized.pathLength()),
              GetParam().ratio * static_cast<double>(bounds->pathLength));
    if (!kSanitized)
    {
        EXPECT_LE(fastestPlan / fastestSearch, GetParam().searches);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Maps, PeerCases,
    testing::Values(
        PeerCase{"AR0603SR_600", "movingai/bg512/AR0603SR.map", "AR0603SR.scen", 600, 400, 1.01},
        PeerCase{"AR0603SR_2000", "movingai/bg512/AR0603SR.map", "AR0603SR.scen", 2000, 3000, 1.01},
        PeerCase{"random_400", "movingai/mapf/random-64-64-20.map", "random-64-64-20.scen", 400, 5000, 1.06},
        PeerCase{"random_2000", "movingai/mapf/random-64-64-20.map", "random-64-64-20.scen", 2000, 20000,
                 1.9},
        PeerCase{"warehouse_400", "movingai/mapf/warehouse-10-20-10-2-1.map", "warehouse-10-20-10-2-1.scen",
                 400, 5000, 1.06},
        PeerCase{"warehouse_2000", "movingai/mapf/warehouse-10-20-10-2-1.map", "warehouse-10-20-10-2-1.scen",
                 2000, 20000, 1.5},
        PeerCase{"grid10_two_free", "peer-cases/grid10.map", "grid10-b2-s1.scen", 98, 20000, 8}),
    [](const auto &test) { return std::string(test.param.name); });

} // namespace
} // namespace mrpp
