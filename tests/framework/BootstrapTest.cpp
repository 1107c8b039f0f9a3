#include "framework/support/Bootstrap.h"
#include "framework/support/Quantiles.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace mrpp
{
namespace
{

double variance(std::span<const double> values)
{
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return squares / n;
}

/// Spatial test data, test A: B. Efron and R. Tibshirani, "An Introduction to the Bootstrap", 1993,
/// table 14.1.
const std::vector<double> kSpatial = {48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6,
                                      0,  33, 28, 34, 4,  32, 24, 47, 41, 24, 26, 30, 41};

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
         {std::vector<double>{3}, {5, 1}, {9, 1, 4}, {4, 4, 1, 8}, kSpatial})
        EXPECT_EQ(median(values), quartiles(values)->median);
}

TEST(Bootstrap, AccelerationIsThePublishedOne)
{
    EXPECT_NEAR(variance(kSpatial), 171.534024, 5e-7);
    EXPECT_NEAR(jackknifeAcceleration(kSpatial, variance), 0.06124012, 5e-9); // the book rounds to 0.061
}

TEST(Bootstrap, IntervalIsThePublishedOne)
{
    // Table 14.2: (115.8, 259.6) from 2000 resamples; with many the ends vary by less than two.
    const auto interval = bootstrapInterval(kSpatial, variance, {0.9, 50000, 7});
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, 115.8, 2);
    EXPECT_NEAR(interval->high, 259.6, 2);
}

TEST(Bootstrap, RefusesSmallSamplesAndKeepsToItsSeed)
{
    const std::vector<double> few = {1, 2, 3, 4, 5, 6, 7};
    EXPECT_FALSE(medianInterval(few));
    EXPECT_EQ(medianInterval(kSpatial), medianInterval(kSpatial));
    EXPECT_NE(medianInterval(kSpatial, {0.95, 200, 1}), medianInterval(kSpatial, {0.95, 200, 2}));
    const std::vector<double> equal(10, 3.5);
    EXPECT_EQ(medianInterval(equal), (Interval{3.5, 3.5}));
}

/// Share of samples of a skewed distribution whose interval holds the true value.
double coverage(std::size_t size, const Statistic &statistic, double truth)
{
    constexpr std::size_t kSamples = 1500;
    Random random(size);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < kSamples; ++i)
    {
        std::vector<double> sample(size);
        for (double &value : sample)
            value = -std::log(1 - random.uniform()); // exponential: median ln 2, mean 1
        const auto interval = bootstrapInterval(sample, statistic, {0.95, 800, i});
        covered += interval && interval->contains(truth) ? 1 : 0;
    }
    return static_cast<double>(covered) / static_cast<double>(kSamples);
}

TEST(Bootstrap, IntervalsCoverWhatTheyPromise)
{
    const Statistic ofMedian = [](std::span<const double> v) { return median({v.begin(), v.end()}); };
    const Statistic ofMean = [](std::span<const double> v)
    { return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size()); };
    // Simulation error is 0.6 %; bootstrap intervals of means of few skewed values are known to be short.
    EXPECT_NEAR(coverage(10, ofMedian, std::log(2.0)), 0.95, 0.04);
    EXPECT_NEAR(coverage(30, ofMedian, std::log(2.0)), 0.95, 0.03);
    EXPECT_NEAR(coverage(60, ofMean, 1), 0.95, 0.03);
    EXPECT_GT(coverage(20, ofMean, 1), 0.88);
}

} // namespace
} // namespace mrpp
