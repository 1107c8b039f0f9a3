#include "framework/statistics/Quantiles.h"
#include "framework/support/Random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace mrpp
{
namespace
{

constexpr double kFailed = std::numeric_limits<double>::infinity();

TEST(Quartiles, InterpolateLinearlyBetweenOrderStatistics)
{
    EXPECT_EQ(quartiles({}), std::nullopt);
    EXPECT_EQ(quartiles({7}), (Quartiles{7, 7, 7, 1}));
    EXPECT_EQ(quartiles({4, 2}), (Quartiles{2.5, 3, 3.5, 2}));
    EXPECT_EQ(quartiles({10, 1, 3, 2}), (Quartiles{1.75, 2.5, 4.75, 4}));
    EXPECT_EQ(quartiles({5, 1, 4, 2, 3}), (Quartiles{2, 3, 4, 5}));
}

TEST(Quartiles, MedianIsTheSecond)
{
    for (const std::vector<double> &values :
         {std::vector<double>{3}, {5, 1}, {9, 1, 4}, {4, 4, 1, 8}, {1, kFailed, 2}, {2, 1, kFailed, kFailed}})
        EXPECT_EQ(median(values), quartiles(values)->median);
}

TEST(Quartiles, OfFailuresHaveAMedianWhileMoreThanHalfSolve)
{
    EXPECT_EQ(censoredQuartiles({3, 1, 2, kFailed, kFailed}), (Quartiles{2, 3, kFailed, 5}));
    EXPECT_EQ(censoredQuartiles({1, 2, kFailed, kFailed}), std::nullopt);
    EXPECT_EQ(censoredQuartiles({1, 2, 3, kFailed}), (Quartiles{1.75, 2.5, kFailed, 4}));
    EXPECT_EQ(censoredQuartiles({1, 2, 3, 4, kFailed}), (Quartiles{2, 3, 4, 5}));
    EXPECT_EQ(censoredQuartiles({kFailed}), std::nullopt);
    EXPECT_EQ(censoredQuartiles({}), std::nullopt);
}

TEST(Quartiles, MakeABandFromFiveValuesOn)
{
    EXPECT_FALSE((Quartiles{1, 2, 3, 2}).hasBand());
    EXPECT_FALSE((Quartiles{1, 2, 3, 4}).hasBand());
    EXPECT_TRUE((Quartiles{1, 2, 3, 5}).hasBand());
    EXPECT_FALSE((Quartiles{1, 2, kFailed, 9}).hasBand());
}

/// The numbers 1 … n.
std::vector<double> upTo(int n)
{
    std::vector<double> values;
    for (int i = n; i > 0; --i)
        values.push_back(i);
    return values;
}

TEST(MedianInterval, IsBetweenTheOrderStatisticsOfTables)
{
    // The ranks that tables of the sign test give for 95 % (W. J. Conover, 1999, table A3; also qbinom(0.025,
    // n, 0.5) and its mirror in R).
    EXPECT_EQ(medianInterval(upTo(5)), std::nullopt);
    EXPECT_EQ(medianInterval(upTo(6)), (Interval{1, 6}));
    EXPECT_EQ(medianInterval(upTo(8)), (Interval{1, 8}));
    EXPECT_EQ(medianInterval(upTo(9)), (Interval{2, 8}));
    EXPECT_EQ(medianInterval(upTo(10)), (Interval{2, 9}));
    EXPECT_EQ(medianInterval(upTo(16)), (Interval{4, 13}));
    EXPECT_EQ(medianInterval(upTo(20)), (Interval{6, 15}));
    EXPECT_EQ(medianInterval(upTo(50)), (Interval{18, 33}));
    EXPECT_EQ(medianInterval(upTo(100)), (Interval{40, 61}));
    EXPECT_EQ(medianInterval(upTo(10), 0.9), (Interval{2, 9}));
    EXPECT_EQ(medianInterval(upTo(13), 0.9), (Interval{4, 10}));
    EXPECT_EQ(medianInterval(std::vector<double>(10, 3.5)), (Interval{3.5, 3.5}));
}

TEST(MedianInterval, IsTheNarrowestThatKeepsItsLevel)
{
    // Against the sum of binomial coefficients itself.
    for (int n = 6; n <= 60; ++n)
    {
        const auto interval = medianInterval(upTo(n));
        ASSERT_TRUE(interval) << n;
        const auto shareBelow = [n](int k) // of sequences of n fair coins with fewer than k heads
        {
            double coefficient = std::pow(0.5, n);
            double sum = 0;
            for (int heads = 0; heads < k;
                 coefficient *= static_cast<double>(n - heads) / (heads + 1), ++heads)
                sum += coefficient;
            return sum;
        };
        const auto k = static_cast<int>(interval->low);
        EXPECT_EQ(interval->high, n + 1 - k);
        EXPECT_LE(shareBelow(k), 0.025) << n;
        EXPECT_GT(shareBelow(k + 1), 0.025) << n;
    }
}

} // namespace
} // namespace mrpp
