#include "framework/statistics/Profiles.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using Steps = std::vector<StepPoint>;

TEST(Profiles, FailuresCountInPenalizedAverages)
{
    const std::vector<std::optional<double>> times = {1, 3, std::nullopt, 8};
    EXPECT_EQ(penalizedAverage(times, 10, 2), 8);   // (1 + 3 + 20 + 8) / 4
    EXPECT_EQ(penalizedAverage(times, 10, 10), 28); // (1 + 3 + 100 + 8) / 4
    EXPECT_EQ(penalizedAverage({}, 10, 2), std::nullopt);
}

TEST(Profiles, EcdfEndsAtTheShareThatWasSolved)
{
    EXPECT_EQ(ecdf({3, 1, 3}, 4), (Steps{{1, 0.25}, {3, 0.75}}));
    EXPECT_EQ(ecdf({}, 4), Steps());
}

TEST(Profiles, CactusSortsByTime)
{
    EXPECT_EQ(cactus({5, 1, 2}), (Steps{{1, 1}, {2, 2}, {3, 5}}));
}

TEST(Profiles, AreThoseOfDolanAndMore)
{
    // Ratios to the best: first 1, 1, 2, −; second 2, −, 1, −. One case was solved by nobody.
    const auto profiles =
        performanceProfiles({{2, 4}, {3, std::nullopt}, {10, 5}, {std::nullopt, std::nullopt}});
    ASSERT_EQ(profiles.size(), 2U);
    EXPECT_EQ(profiles[0], (Steps{{1, 0.5}, {2, 0.75}}));
    EXPECT_EQ(profiles[1], (Steps{{1, 0.25}, {2, 0.5}}));
}

TEST(Profiles, ABestOfNothingIsMatchedByNothingAlone)
{
    const auto profiles = performanceProfiles({{0, 3}, {0, 0}, {1, 2}});
    EXPECT_EQ(profiles[0], (Steps{{1, 1}}));
    EXPECT_EQ(profiles[1], (Steps{{1, 1.0 / 3}, {2, 2.0 / 3}}));
    EXPECT_EQ(performanceProfiles({{1, std::nullopt}})[1], (Steps{{1, 0}}));
}

TEST(Profiles, TimesThatHardlyDifferAreBothTheBest)
{
    // 3 and 4 µs; 1 and 1.09 ms, in which 0.09 ms are nothing; 1 and 1.05 s, less than a tenth; 1 and 1.2 s.
    const std::vector<std::vector<std::optional<double>>> times = {
        {3e-6, 4e-6}, {1e-3, 1.09e-3}, {1, 1.05}, {1, 1.2}};
    const auto profiles = performanceProfiles(times, kAlikeTimes);
    EXPECT_EQ(profiles[0], (Steps{{1, 1}}));
    EXPECT_EQ(profiles[1], (Steps{{1, 0.75}, {1.2, 1}}));
    EXPECT_EQ(performanceProfiles(times)[1].front(), (StepPoint{1, 0}));
}

} // namespace
} // namespace mrpp
