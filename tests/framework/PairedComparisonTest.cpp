#include "framework/statistics/PairedComparison.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>

namespace mrpp
{
namespace
{

using Values = std::vector<double>;
using Direction = PairedComparison::Direction;

TEST(OrderOfRatios, RatiosThatAreEqualAreTies)
{
    // 2/1, 4/2 and 1/2 are one size, 3/1 is larger, and 1/1 is none.
    EXPECT_EQ(orderOfRatios(Values{2, 4, 1, 3, 1}, Values{1, 2, 2, 1, 1}), (Values{1, 1, -1, 2, 0}));
    // As times: whole nanoseconds, whatever their sum of powers of two.
    EXPECT_EQ(orderOfRatios(Values{0.1, 0.2, 0.003}, Values{0.3, 0.6, 0.001}), (Values{-1, -1, 1}));
    // Halves come from medians of two copies; above 4·10⁹ whole numbers are left.
    EXPECT_EQ(orderOfRatios(Values{1.5, 3, 5e15}, Values{0.5, 1, 1e15}), (Values{1, 1, 2}));
    // What is over nothing is largest, and as large as anything else over nothing.
    EXPECT_EQ(orderOfRatios(Values{0, 7, 1000}, Values{3, 0, 1}), (Values{-2, 2, 1}));
}

TEST(OrderOfRatios, LargeNumbersThatDifferByOneAreNoTie)
{
    EXPECT_EQ(orderOfRatios(Values{3999999999, 3999999998}, Values{3999999998, 3999999997}), (Values{1, 2}));
}

TEST(ComparePairs, IsExactWhereLogarithmsAreNot)
{
    // Of 2¹⁰ signs 58 are as extreme; with the ties lost to rounding it was 0.0488.
    const auto comparison = comparePairs(Values{180, 48, 114, 30, 100, 6, 114, 75, 20, 112},
                                         Values{60, 16, 57, 15, 50, 12, 57, 25, 40, 56});
    EXPECT_NEAR(*comparison.test.p, 58.0 / 1024, 1e-15);
    EXPECT_EQ(comparison.firstLess, 2U);
    EXPECT_EQ(comparison.secondLess, 8U);
    EXPECT_EQ(comparison.medianRatio, 2);
    EXPECT_EQ(comparison.direction(), Direction::second);
}

TEST(ComparePairs, TakesTheDirectionFromTheStatistic)
{
    // On 52 of 100 cases 4 % less, on 48 twice as much: the median ratio is below 1, the ranks say more.
    Values first;
    Values second;
    for (int i = 0; i < 100; ++i)
    {
        second.push_back(100);
        first.push_back(i < 52 ? 96 : 200);
    }
    const auto comparison = comparePairs(first, second);
    EXPECT_LT(comparison.medianRatio, 1);
    EXPECT_LT(comparison.rankBiserial(), 0);
    EXPECT_LT(*comparison.test.p, 0.01);
    EXPECT_EQ(comparison.direction(), Direction::unclear);
    EXPECT_EQ(comparePairs(second, first).direction(), Direction::unclear);
}

TEST(ComparePairs, AgreesWithTheNumberOfCasesWon)
{
    // Most are equal, so that the median ratio is 1: three less by much, five more by little.
    const auto comparison =
        comparePairs(Values{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 10, 10, 10, 101, 101, 101, 101, 101},
                     Values{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 90, 90, 90, 100, 100, 100, 100, 100});
    EXPECT_EQ(comparison.medianRatio, 1);
    EXPECT_GT(comparison.rankBiserial(), 0);
    EXPECT_EQ(comparison.direction(), Direction::unclear);
}

TEST(ComparePairs, EqualsHaveNoDirection)
{
    const auto comparison = comparePairs(Values{1, 2, 0}, Values{1, 2, 0});
    EXPECT_EQ(comparison.direction(), Direction::none);
    EXPECT_EQ(comparison.medianRatio, 1);
    EXPECT_EQ(comparison.rankBiserial(), 0);
    EXPECT_EQ(comparePairs({}, {}).direction(), Direction::none);
}

TEST(ComparePairs, NothingAgainstSomethingIsInfinite)
{
    EXPECT_EQ(comparePairs(Values{5, 5, 5}, Values{0, 0, 0}).medianRatio,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(comparePairs(Values{0, 0, 0}, Values{5, 5, 5}).medianRatio, 0);
    EXPECT_EQ(comparePairs(Values{0, 0, 0}, Values{0, 0, 0}).medianRatio, 1);
}

RC_GTEST_PROP(ComparePairs, TurnsRoundWithItsSides,
              (std::vector<std::pair<std::uint8_t, std::uint8_t>> pairs))
{
    Values first;
    Values second;
    for (const auto &[a, b] : pairs)
    {
        first.push_back(a % 12);
        second.push_back(b % 12);
    }
    const auto there = comparePairs(first, second);
    const auto back = comparePairs(second, first);
    RC_ASSERT(there.test.p == back.test.p);
    RC_ASSERT(there.firstLess == back.secondLess);
    RC_ASSERT(std::abs(there.rankBiserial() + back.rankBiserial()) < 1e-12);
}

} // namespace
} // namespace mrpp
