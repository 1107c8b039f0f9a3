#include "framework/statistics/ScalingFit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace mrpp
{
namespace
{

/// Seven values around the law, the law itself their median.
std::vector<ScalingPoint> observe(const std::vector<double> &sizes, double (*law)(double))
{
    std::vector<ScalingPoint> points;
    for (const double size : sizes)
    {
        points.push_back({size, {}});
        for (const double noise : {0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3})
            points.back().values.push_back(law(size) * noise);
    }
    return points;
}

const std::vector<double> kSizes = {4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

TEST(ScalingFit, IsLeastSquaresOfLogarithms)
{
    // F. Anscombe's first quartet as logarithms: the first eight are fitted by 2.5582143 + 0.5610714 x.
    const std::vector<double> x = {4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
    const std::vector<double> y = {4.26, 5.68, 7.24, 4.82, 6.95, 8.81, 8.04, 8.33, 10.84, 7.58, 9.96};
    std::vector<ScalingPoint> exponential;
    std::vector<ScalingPoint> power;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        exponential.push_back({x[i], {std::exp(y[i])}});
        power.push_back({std::exp(x[i]), {std::exp(y[i])}});
    }
    const ScalingModel byExponential = fitScaling(exponential).exponential;
    EXPECT_NEAR(std::log(byExponential.scale), 2.558214286, 5e-10);
    EXPECT_NEAR(std::log(byExponential.rate), 0.561071429, 5e-10);
    const ScalingModel byPower = fitScaling(power).power;
    EXPECT_NEAR(byPower.rate, 0.561071429, 5e-10);
    EXPECT_NEAR(byPower.fitError, 0.903489021 / std::log(10.0), 5e-10);
    EXPECT_NEAR(byPower.heldOutError, 1.609059360 / std::log(10.0), 5e-10);
}

TEST(ScalingFit, TellsThePowerLawFromTheExponentialOne)
{
    const ScalingFit power = fitScaling(observe(kSizes, [](double n) { return 0.01 * std::pow(n, 2.5); }));
    EXPECT_EQ(power.refusal, "");
    EXPECT_EQ(power.fitted, 7U);
    EXPECT_EQ(power.heldOut, 3U);
    EXPECT_EQ(power.better().law, ScalingLaw::power);
    EXPECT_NEAR(power.power.rate, 2.5, 1e-9);
    EXPECT_TRUE(power.power.rateInterval().contains(2.5));
    EXPECT_EQ(power.power.heldOutWithin, 3U);
    EXPECT_EQ(power.exponential.heldOutWithin, 0U);

    const ScalingFit exponential =
        fitScaling(observe(kSizes, [](double n) { return 0.01 * std::pow(1.3, n); }));
    EXPECT_EQ(exponential.better().law, ScalingLaw::exponential);
    EXPECT_NEAR(exponential.exponential.rate, 1.3, 1e-9);
    EXPECT_EQ(exponential.exponential.heldOutWithin, 3U);
    EXPECT_NEAR(exponential.exponential.at(40), 0.01 * std::pow(1.3, 40), 1e-6);
}

TEST(ScalingFit, BandsWidenBeyondWhatWasSeen)
{
    const ScalingModel model = fitScaling(observe(kSizes, [](double n) { return n; })).power;
    const auto width = [&](double size) { return std::log(model.band(size).high / model.band(size).low); };
    EXPECT_GT(width(400), width(40));
    EXPECT_GT(width(40), width(12));
}

TEST(ScalingFit, CountsFailuresAsAboveTheLimit)
{
    // The law is n², and the limit 900: what is above it failed. Without the failures the largest sizes bend
    // down.
    constexpr double kFailed = std::numeric_limits<double>::infinity();
    std::vector<ScalingPoint> points = observe(kSizes, [](double n) { return n * n; });
    for (ScalingPoint &point : points)
        for (double &value : point.values)
            value = value > 900 ? kFailed : value;
    const ScalingFit fit = fitScaling(points);
    EXPECT_EQ(fit.refusal, "");
    EXPECT_EQ(fit.leftOut, 3U); // 32, 36 and 40; of 28 four of seven are below
    EXPECT_EQ(fit.fitted, 5U);
    EXPECT_EQ(fit.heldOut, 2U);
    EXPECT_NEAR(fit.splitAt, std::sqrt(20.0 * 24), 1e-12);
    EXPECT_NEAR(fit.power.rate, 2, 1e-9);
    EXPECT_NEAR(fit.power.heldOutError, 0, 1e-9);
    EXPECT_EQ(fit.power.heldOutWithin, 2U);
    EXPECT_TRUE(std::isfinite(fit.power.band(40).high));
}

TEST(ScalingFit, LeavesASizeOutOfAResampleThatFailed)
{
    constexpr double kFailed = std::numeric_limits<double>::infinity();
    std::vector<ScalingPoint> points = observe(kSizes, [](double n) { return n; });
    for (ScalingPoint &point : points)
        point.values = {point.size * 0.9, point.size, point.size * 1.1, kFailed, kFailed};
    const ScalingFit fit = fitScaling(points);
    EXPECT_EQ(fit.leftOut, 0U);
    EXPECT_TRUE(std::isfinite(fit.power.rateInterval().low) && std::isfinite(fit.power.rateInterval().high));
    EXPECT_GT(fit.power.resampled.size(), 900U);
}

TEST(ScalingFit, RefusesAndSaysWhy)
{
    const auto same = [](double n) { return n; };
    EXPECT_EQ(fitScaling(observe({1, 2, 3, 4}, same)).refusal,
              "only 4 sizes had more than half of their instances solved; a fit needs 5");
    EXPECT_EQ(fitScaling(observe({10, 11, 12, 13, 14}, same)).refusal,
              "the sizes do not even double, so that any law fits");
}

} // namespace
} // namespace mrpp
