#include "algorithms/optimizers/RedundancyRemoval.h"

#include "framework/evaluation/Validator.h"
#include "framework/system/Memory.h"
#include "tests/support/CpuClock.h"
#include "tests/support/RandomCases.h"

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

Solution improve(const Instance &instance, const Solution &solution)
{
    return RedundancyRemoval().improve(instance, solution, {});
}

/// Whether some robot leaves a vertex and comes back to it, outside rotations, while nobody else enters it.
bool hasRedundantWalk(const Instance &instance, const Solution &solution)
{
    std::vector<char> rotated(solution.pathLength(), 0);
    for (const auto &rotation : solution.rotations())
        std::fill_n(rotated.begin() + static_cast<std::ptrdiff_t>(rotation.first), rotation.size, 1);
    std::vector<Move> arrivals;
    for (Robot r = 0; r < instance.robotCount(); ++r)
        arrivals.push_back({r, kNoVertex, instance.starts[r]});
    const std::size_t robots = arrivals.size();
    arrivals.insert(arrivals.end(), solution.moves().begin(), solution.moves().end());
    for (std::size_t i = 0; i < arrivals.size(); ++i)
    {
        for (std::size_t j = i + 1; j < arrivals.size(); ++j)
        {
            if (arrivals[j].robot == arrivals[i].robot && rotated[j - robots] != 0)
                break;
            if (arrivals[j].to != arrivals[i].to)
                continue;
            if (arrivals[j].robot == arrivals[i].robot)
                return true;
            break;
        }
    }
    return false;
}

TEST(RedundancyRemoval, DeletesAWalkThatComesBack)
{
    const auto graph = Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}});
    const Instance instance{graph, {0}, {1}};
    const Solution solution({{0, 0, 1}, {0, 1, 2}, {0, 2, 3}, {0, 3, 2}, {0, 2, 1}});
    EXPECT_EQ(improve(instance, solution), Solution({{0, 0, 1}}));
}

TEST(RedundancyRemoval, KeepsAWalkWhileAnotherRobotPassed)
{
    // Robot 0 steps aside so that robot 1 can pass over vertex 1.
    const auto graph = Graph::fromEdges(4, {{0, 1}, {1, 2}, {1, 3}});
    const Instance instance{graph, {1, 0}, {1, 2}};
    const Solution solution({{0, 1, 3}, {1, 0, 1}, {1, 1, 2}, {0, 3, 1}});
    EXPECT_EQ(improve(instance, solution), solution);
}

TEST(RedundancyRemoval, SeesWhatBecomesRedundantLater)
{
    // Robot 0 left vertex 1 only for a visit of robot 1 that is redundant itself.
    const auto graph = Graph::fromEdges(4, {{0, 1}, {1, 2}, {1, 3}});
    const Instance instance{graph, {1, 0}, {1, 0}};
    const Solution solution({{0, 1, 3}, {1, 0, 1}, {1, 1, 0}, {0, 3, 1}});
    EXPECT_TRUE(improve(instance, solution).empty());
}

TEST(RedundancyRemoval, LeavesNothingRedundantAndNothingBroken)
{
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        const auto vertices = 4 + random.below(14);
        const auto graph = test::randomConnectedGraph(vertices, random.below(8), seed);
        const auto robots = 1 + random.below(vertices - 1);
        for (const bool rotations : {false, true})
        {
            const auto solved = rotations ? test::randomSolvedCaseWithRotations(graph, robots, 200, seed)
                                          : test::randomSolvedCase(graph, robots, 200, seed);
            const Solution shorter = improve(solved.instance, solved.solution);
            const Verdict verdict = validate(solved.instance, shorter, MotionRule::rotation);
            ASSERT_TRUE(verdict.valid()) << "seed " << seed << ": " << verdict.violation;
            ASSERT_LE(shorter.pathLength(), solved.solution.pathLength());
            ASSERT_FALSE(hasRedundantWalk(solved.instance, shorter)) << "seed " << seed;
            ASSERT_EQ(shorter.rotations().size(), solved.solution.rotations().size());
            ASSERT_EQ(improve(solved.instance, shorter), shorter);
        }
    }
}

TEST(RedundancyRemoval, ReturnsALegalSolutionWhenStopped)
{
    const auto solved = test::randomSolvedCase(test::gridGraph(10, 10), 60, 50'000, 1);
    const Solution kept =
        RedundancyRemoval().improve(solved.instance, solved.solution, TerminationCondition::after(0));
    EXPECT_TRUE(validate(solved.instance, kept, MotionRule::pebble).valid());
    EXPECT_LE(kept.pathLength(), solved.solution.pathLength());
}

TEST(RedundancyRemoval, HandlesTenMillionMovesWithinTwoSecondsAndFiftyBytesAMove)
{
    if (kSanitized)
        GTEST_SKIP() << "sanitizers change time and memory";
    constexpr std::size_t kMoves = 10'000'000;
    auto solved = test::randomWalks(test::gridGraph(300, 300), 45'000, kMoves, 1);
    const std::size_t moves = solved.solution.pathLength();
    ASSERT_EQ(moves, kMoves);
    const bool measured = resetPeakMemory();
    const double start = test::cpuSeconds();
    const Solution shorter = RedundancyRemoval().improve(solved.instance, std::move(solved.solution), {});
    const double seconds = test::cpuSeconds() - start;
    const double bytes = peakMemory() * 1e6 / static_cast<double>(moves);
    EXPECT_LT(seconds, 2.0);
    if (measured)
    {
        EXPECT_LT(bytes, 50.0);
    }
    EXPECT_LT(shorter.pathLength(), moves);
}

} // namespace
} // namespace mrpp
