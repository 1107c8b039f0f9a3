#include "framework/support/Random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

std::vector<int> digits()
{
    std::vector<int> list(10);
    std::iota(list.begin(), list.end(), 0);
    return list;
}

// The literals of this file were computed outside this program, from the published algorithms.

TEST(Random, HasTheSameBitsOnEveryMachine)
{
    Random zero(0);
    EXPECT_EQ(zero.bits(), 0x99ec5f36cb75f2b4U);
    EXPECT_EQ(zero.bits(), 0xbf6e1f784956452aU);
    EXPECT_EQ(zero.bits(), 0x1a5f849d4933e6e0U);
    EXPECT_EQ(zero.bits(), 0x6aa594f1262d2d2cU);
    Random other(2016);
    EXPECT_EQ(other.bits(), 0x2783899f312ca7a0U);
    EXPECT_EQ(other.bits(), 0x0624859da8fd69e2U);
}

TEST(Random, HasTheSameBoundedNumbersOnEveryMachine)
{
    Random random(7);
    std::vector<std::uint64_t> drawn;
    for (int i = 0; i < 12; ++i)
        drawn.push_back(random.below(10));
    EXPECT_THAT(drawn, ElementsAre(7, 2, 8, 9, 9, 8, 0, 1, 4, 1, 5, 7));
    Random again(7);
    EXPECT_EQ(again.uniform(), 0.7005764821796896);
    EXPECT_EQ(again.uniform(), 0.2787512294737843);
}

TEST(Random, BelowStaysBelowAndFavoursNone)
{
    Random random(1);
    std::vector<int> count(6, 0);
    for (int i = 0; i < 60000; ++i)
        ++count.at(random.below(6));
    // Chi squared with 5 degrees of freedom exceeds 20.5 once in a thousand.
    double chiSquared = 0;
    for (const int c : count)
        chiSquared += (c - 10000.0) * (c - 10000.0) / 10000.0;
    EXPECT_LT(chiSquared, 20.5);
    EXPECT_EQ(random.below(1), 0U);
}

TEST(Random, BelowIsUnbiasedForBoundsNearTheWholeRange)
{
    // With a plain multiplication the numbers would hit each third as often as the words do: 2 : 1 : 1.
    constexpr std::uint64_t kBound = 3ULL << 62;
    Random random(1);
    std::vector<int> third(3, 0);
    for (int i = 0; i < 30000; ++i)
        ++third.at(random.below(kBound) / (kBound / 3));
    for (const int c : third)
        EXPECT_NEAR(c, 10000, 400);
}

TEST(Random, UniformLiesInTheUnitInterval)
{
    Random random(3);
    double sum = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const double x = random.uniform();
        ASSERT_GE(x, 0);
        ASSERT_LT(x, 1);
        sum += x;
    }
    EXPECT_NEAR(sum / 10000, 0.5, 0.02);
}

TEST(Random, ShufflesTheSameOnEveryMachine)
{
    auto list = digits();
    Random(7).shuffle(std::span(list));
    EXPECT_THAT(list, ElementsAre(7, 3, 8, 9, 1, 4, 6, 0, 2, 5));
}

TEST(Random, ASmallerSampleIsThePrefixOfALarger)
{
    auto all = digits();
    Random(7).shuffle(std::span(all));
    for (std::size_t count = 0; count <= 10; ++count)
    {
        auto some = digits();
        Random(7).shuffleFront(std::span(some), count);
        EXPECT_TRUE(std::equal(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count), all.begin()));
        std::sort(some.begin(), some.end());
        EXPECT_EQ(some, digits());
    }
}

TEST(Random, ShufflesShortLists)
{
    std::vector<int> none;
    Random(1).shuffle(std::span(none));
    std::vector<int> one = {5};
    Random(1).shuffleFront(std::span(one), 9);
    EXPECT_THAT(one, ElementsAre(5));
}

TEST(Random, ACopyForksTheSequence)
{
    Random random(5);
    random.bits();
    Random copy = random;
    EXPECT_EQ(copy.bits(), random.bits());
}

TEST(DeriveSeed, IsTheSameOnEveryMachine)
{
    EXPECT_EQ(deriveSeed(2016), 1303291524370260070U);
    EXPECT_EQ(deriveSeed(2016, "graph", 3), 4241615069540941422U);
    EXPECT_EQ(deriveSeed(1, "a", "b"), 857911107449834153U);
    EXPECT_EQ(deriveSeed(1, "ab"), 6581062439499257875U);
    EXPECT_EQ(deriveSeed(1, -1), 2544798951797162733U);
}

TEST(DeriveSeed, DependsOnEveryPart)
{
    const Seed seed = deriveSeed(1, "graph", 2);
    EXPECT_EQ(deriveSeed(1, std::string("graph"), 2U), seed);
    EXPECT_NE(deriveSeed(2, "graph", 2), seed);
    EXPECT_NE(deriveSeed(1, "grape", 2), seed);
    EXPECT_NE(deriveSeed(1, "graph", 3), seed);
    EXPECT_NE(deriveSeed(1, 2, "graph"), seed);
    EXPECT_LT(seed, Seed{1} << 63) << "databases know signed numbers only";
}

} // namespace
} // namespace mrpp
