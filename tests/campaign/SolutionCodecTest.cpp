#include "framework/store/SolutionCodec.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace mrpp
{
namespace
{

TEST(SolutionCodec, PacksAWalkIntoThreeBytesAMove)
{
    Solution walk;
    for (Vertex v = 0; v < 1000; ++v)
        walk.append({5, v, v + 1});
    const auto bytes = packSolution(walk);
    EXPECT_LE(bytes.size(), 3010U);
    EXPECT_EQ(unpackSolution(bytes), walk);
}

TEST(SolutionCodec, KeepsTheEmptySolution)
{
    EXPECT_EQ(packSolution(Solution()), (std::vector<std::uint8_t>{1, 0, 0}));
    EXPECT_EQ(unpackSolution(packSolution(Solution())), Solution());
}

TEST(SolutionCodec, KeepsTheFormatOfOlderStores)
{
    const Solution solution({{1, 2, 3}, {0, 300, 299}});
    EXPECT_EQ(packSolution(solution), (std::vector<std::uint8_t>{1, 2, 0, 2, 4, 2, 1, 0xd8, 4, 1}));
}

TEST(SolutionCodec, RefusesNumbersThatPromiseMoreThanThereIs)
{
    EXPECT_EQ(unpackSolution({}), std::nullopt);
    const std::vector<std::uint8_t> huge = {1, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1, 0};
    EXPECT_EQ(unpackSolution(huge), std::nullopt);
    const std::vector<std::uint8_t> otherFormat = {2, 0, 0};
    EXPECT_EQ(unpackSolution(otherFormat), std::nullopt);
}

Solution anySolution()
{
    Solution solution;
    const auto actions = *rc::gen::inRange(0, 40);
    const auto anyMove = [] {
        return Move{*rc::gen::arbitrary<Robot>(), *rc::gen::arbitrary<Vertex>(),
                    *rc::gen::arbitrary<Vertex>()};
    };
    for (int i = 0; i < actions; ++i)
    {
        const auto size = *rc::gen::inRange(1, 5);
        std::vector<Move> moves;
        for (int k = 0; k < size; ++k)
            moves.push_back(anyMove());
        if (size == 1)
            solution.append(moves.front());
        else
            solution.appendRotation(moves);
    }
    return solution;
}

RC_GTEST_PROP(SolutionCodec, GivesEverySolutionBack, ())
{
    const Solution solution = anySolution();
    RC_ASSERT(unpackSolution(packSolution(solution)) == solution);
}

RC_GTEST_PROP(SolutionCodec, NoticesThatBytesAreMissing, ())
{
    auto bytes = packSolution(anySolution());
    bytes.resize(static_cast<std::size_t>(*rc::gen::inRange(std::size_t{0}, bytes.size())));
    RC_ASSERT(unpackSolution(bytes) == std::nullopt);
}

RC_GTEST_PROP(SolutionCodec, SurvivesAnyBytes, (std::vector<std::uint8_t> bytes))
{
    bytes.insert(bytes.begin(), 1);
    const auto solution = unpackSolution(bytes);
    if (solution)
        RC_ASSERT(solution->pathLength() * 3 < bytes.size());
}

} // namespace
} // namespace mrpp
