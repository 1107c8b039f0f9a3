/// Long solutions: near-linear time and little memory. Times are this process's own, so that a busy machine
/// matters little.

#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Condense.h"
#include "framework/evaluation/Metrics.h"
#include "framework/evaluation/Validator.h"
#include "framework/system/Memory.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

namespace mrpp
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr std::size_t kMoves = 200'000;
constexpr bool kMeasure = false;
#else
constexpr std::size_t kMoves = 10'000'000;
constexpr bool kMeasure = true;
#endif

/// Robots that drive round and round in columns of their own: many can move at once, a robot's moves lie far
/// apart in the solution where `together`, or all behind one another where not.
test::SolvedCase longCase(bool together)
{
    constexpr std::size_t kWidth = 400;
    constexpr std::size_t kHeight = 100;
    constexpr std::size_t kRobots = kWidth / 2;
    test::SolvedCase test{{test::gridGraph(kWidth, kHeight), {}, {}}, {}};
    for (Vertex robot = 0; robot < kRobots; ++robot)
        test.instance.starts.push_back(2 * robot);
    test.instance.goals = test.instance.starts;
    constexpr std::size_t kLap = 2 * kHeight;
    const auto step = [&](Robot robot, std::size_t time)
    {
        const auto at = [&](std::size_t t)
        {
            const std::size_t around = t % kLap;
            const std::size_t x = 2 * robot + (around < kHeight ? 0 : 1);
            const std::size_t y = around < kHeight ? around : kLap - 1 - around;
            return static_cast<Vertex>(y * kWidth + x);
        };
        test.solution.append({robot, at(time), at(time + 1)});
    };
    const std::size_t steps = kMoves / kRobots / kLap * kLap;
    test.solution.reserve(steps * kRobots);
    if (together)
    {
        for (std::size_t time = 0; time < steps; ++time)
            for (Robot robot = kRobots; robot-- > 0;)
                step(robot, time);
    }
    else
    {
        for (Robot robot = kRobots; robot-- > 0;)
            for (std::size_t time = 0; time < steps; ++time)
                step(robot, time);
    }
    return test;
}

template <class Action>
double secondsOf(Action &&action)
{
    const std::clock_t begin = std::clock();
    action();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

class EvaluationScale : public ::testing::TestWithParam<bool>
{};

TEST_P(EvaluationScale, CondensesTenMillionMovesInTwoSecondsAndFiftyBytesAMove)
{
    const double idle = resetPeakMemory() ? peakMemory() : 0;
    const test::SolvedCase test = longCase(GetParam());
    for (const MotionRule rule : {MotionRule::pebble, MotionRule::parallel, MotionRule::following})
    {
        Schedule schedule;
        const bool known = resetPeakMemory();
        const double seconds = secondsOf([&] { schedule = condense(test.instance, test.solution, rule); });
        const double bytes = (peakMemory() - idle) * 1e6 / static_cast<double>(test.solution.pathLength());
        EXPECT_EQ(schedule.pathLength(), test.solution.pathLength());
        const std::size_t sideBySide = test.solution.pathLength() / test.instance.robotCount();
        EXPECT_EQ(schedule.makespan(), rule == MotionRule::pebble ? test.solution.pathLength() : sideBySide);
        if (!kMeasure)
            continue;
        EXPECT_LT(seconds, 2) << toString(rule);
        if (known)
        {
            EXPECT_LT(bytes, 50) << toString(rule);
        }
        RecordProperty(std::string(toString(rule)) + "_ms", static_cast<int>(seconds * 1000));
        RecordProperty(std::string(toString(rule)) + "_bytes_a_move", static_cast<int>(bytes));
    }
}

TEST_P(EvaluationScale, ValidatesAndMeasuresTenMillionMoves)
{
    const test::SolvedCase test = longCase(GetParam());
    Verdict verdict;
    const double validating =
        secondsOf([&] { verdict = validate(test.instance, test.solution, MotionRule::pebble); });
    EXPECT_EQ(verdict.violation, "");
    SolutionMetrics metrics;
    const double measuring =
        secondsOf([&] { metrics = measure(test.instance, test.solution, MotionRule::following); });
    EXPECT_EQ(metrics.makespan, test.solution.pathLength() / test.instance.robotCount());
    EXPECT_EQ(metrics.sumOfCosts, test.solution.pathLength());
    if (kMeasure)
    {
        EXPECT_LT(validating, 2);
        EXPECT_LT(measuring, 1);
        RecordProperty("validate_ms", static_cast<int>(validating * 1000));
        RecordProperty("measure_ms", static_cast<int>(measuring * 1000));
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, EvaluationScale, ::testing::Values(true, false),
                         [](const auto &order) { return order.param ? "RobotsTogether" : "RobotByRobot"; });

TEST(LowerBoundsScale, TwoThousandRobotsOnALargeGridTakeASecond)
{
    const auto graph = test::gridGraph(240, 240);
    Random random(1);
    std::vector<Vertex> vertices(graph->vertexCount());
    for (Vertex v = 0; v < vertices.size(); ++v)
        vertices[v] = v;
    random.shuffle(std::span(vertices));
    const std::vector<Vertex> starts(vertices.begin(), vertices.begin() + 2000);
    random.shuffle(std::span(vertices));
    const std::vector<Vertex> goals(vertices.begin(), vertices.begin() + 2000);
    std::uint64_t expected = 0;
    for (std::size_t robot = 0; robot < 2000; ++robot)
    {
        const auto apart = [](Vertex a, Vertex b) { return a > b ? a - b : b - a; };
        expected +=
            apart(starts[robot] / 240, goals[robot] / 240) + apart(starts[robot] % 240, goals[robot] % 240);
    }
    std::optional<LowerBounds> bounds;
    const double seconds = secondsOf([&] { bounds = lowerBounds({graph, starts, goals}); });
    ASSERT_TRUE(bounds);
    EXPECT_EQ(bounds->pathLength, expected);
    if (kMeasure)
    {
        EXPECT_LT(seconds, 2);
    }
    RecordProperty("ms", static_cast<int>(seconds * 1000));
}

} // namespace
} // namespace mrpp
