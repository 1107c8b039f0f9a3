/// \file
/// Pictures of the largest public maps with hundreds of routes: how long they take and how large they are.

#include "algorithms/PushAndSwap.h"
#include "framework/Problem.h"
#include "problems/formats/MovingAiMap.h"
#include "reports/layouts/FramesPicture.h"
#include "reports/layouts/LayoutPicture.h"
#include "tests/support/CpuClock.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr bool kMeasure = false;
#else
constexpr bool kMeasure = true;
#endif

constexpr double kSeconds = 3; // of processor time, all formats together
constexpr std::size_t kBytes = 5'000'000;

template <class Draw>
void expectQuickAndSmall(const Draw &draw)
{
    const double start = test::cpuSeconds();
    const Picture picture = draw();
    const double seconds = test::cpuSeconds() - start;
    if (kMeasure)
    {
        EXPECT_LE(seconds, kSeconds);
    }
    ::testing::Test::RecordProperty("seconds", std::to_string(seconds));
    for (const std::string *file : {&picture.pdf, &picture.svg, &picture.png})
        EXPECT_LE(file->size(), kBytes);
}

class MapScale : public ::testing::TestWithParam<std::pair<const char *, std::size_t>>
{};

TEST_P(MapScale, IsDrawnInThreeSecondsAndFiveMegabytes)
{
    const auto [name, vertices] = GetParam();
    const auto file = std::filesystem::path(MRPP_SHARED_DATA) / name;
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no map " << file;
    const auto graph = readMovingAiMap(file).graph;
    ASSERT_EQ(graph->vertexCount(), vertices);
    const auto instance = std::make_shared<const Instance>(randomInstance(graph, 600, 1));
    PushAndSwap planner;
    planner.setInstance(instance);
    planner.setup();
    ASSERT_EQ(planner.solve({}), PlannerStatus::solved) << planner.reason();
    const Solution solution = planner.takeSolution();

    expectQuickAndSmall([&] { return drawInstance(*instance, &solution, placeGraph(*graph), "600 routes"); });
    expectQuickAndSmall([&] { return drawFrames(*instance, solution, placeGraph(*graph), "600 robots"); });
}

INSTANTIATE_TEST_SUITE_P(Maps, MapScale,
                         ::testing::Values(std::pair("movingai/bg512/AR0603SR.map", 57372U),
                                           std::pair("movingai/mapf/orz900d.map", 96603U)));

} // namespace
} // namespace mrpp
