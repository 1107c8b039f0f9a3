#include "framework/statistics/SignedRank.h"
#include "framework/statistics/Proportion.h"

#include <gtest/gtest.h>
#include <vector>

namespace mrpp
{
namespace
{

using Values = std::vector<double>;

SignedRankTest signedRankTest(const Values &first, const Values &second)
{
    Values differences;
    for (std::size_t i = 0; i < first.size(); ++i)
        differences.push_back(first[i] - second[i]);
    return mrpp::signedRankTest(differences);
}

TEST(SignedRankTest, AgreesWithR)
{
    // The example of R's wilcox.test (Hollander and Wolfe's depression scales): V = 40, one-sided p =
    // 0.01953.
    const auto depression = signedRankTest(Values{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30},
                                           Values{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29});
    EXPECT_EQ(depression.statistic, 40);
    EXPECT_TRUE(depression.exact);
    EXPECT_NEAR(*depression.p, 0.0390625, 1e-12);

    // Poplar clones (J. McDonald, "Handbook of Biological Statistics"): R gives V = 16, p = 0.03979.
    const auto poplars =
        signedRankTest(Values{8.1, 10.0, 16.5, 13.6, 9.5, 8.3, 18.3, 13.3, 7.9, 8.1, 8.9, 12.6, 13.4},
                       Values{11.2, 16.3, 15.3, 15.6, 10.5, 15.5, 12.7, 11.1, 19.9, 20.4, 14.2, 12.7, 36.8});
    EXPECT_EQ(poplars.statistic, 16);
    EXPECT_NEAR(*poplars.p, 0.03979, 5e-6);

    // Darwin's maize, two ranks shared: 1352 of the 2^15 signs are as extreme.
    const Values maize = {49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
    const auto tied = signedRankTest(maize, Values(maize.size(), 0));
    EXPECT_EQ(tied.statistic, 96);
    EXPECT_NEAR(*tied.p, 1352.0 / 32768, 1e-12);
}

TEST(SignedRankTest, CountsTiesAndLeavesZerosOut)
{
    const Values differences = {3, -1, 4, 1, -5, 9, 2, 6, -5, 3, 5, 0};
    const auto test = signedRankTest(differences, Values(differences.size(), 0));
    EXPECT_EQ(test.pairs, 11U);
    EXPECT_EQ(test.ties, 1U);
    EXPECT_EQ(test.statistic, 48.5);
    EXPECT_NEAR(*test.p, 376.0 / 2048, 1e-12); // by counting all signs
}

TEST(SignedRankTest, IsNormalBeyondFiftyPairs)
{
    Values differences;
    for (int i = 0; i < 60; ++i)
    {
        const int value = (i * 37) % 61 - 25;
        differences.push_back(value == 0 ? 7 : value);
    }
    const auto test = signedRankTest(differences, Values(differences.size(), 0));
    EXPECT_FALSE(test.exact);
    EXPECT_EQ(test.statistic, 1199.5);
    EXPECT_NEAR(*test.p, 0.036538242, 1e-9);
}

TEST(SignedRankTest, RefusesFewPairsAndSaysWhy)
{
    const auto test = signedRankTest(Values{1, 2, 3, 4, 5, 6, 7}, Values{2, 3, 4, 5, 6, 6, 7});
    EXPECT_FALSE(test.p);
    EXPECT_EQ(test.refusal, "only 5 of 7 pairs differ; a test needs 6");
}

TEST(Holm, AdjustsAsR)
{
    // p.adjust(c(0.01, 0.04, 0.03, 0.005, 0.5), "holm")
    const auto adjusted = holmAdjusted(Values{0.01, 0.04, 0.03, 0.005, 0.5});
    const Values expected = {0.04, 0.09, 0.09, 0.025, 0.5};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(adjusted[i], expected[i], 1e-12);
    EXPECT_EQ(holmAdjusted(Values{0.6, 0.7}), (Values{1, 1}));
}

TEST(RankBiserial, IsTheShareOfTheRankSumsApart)
{
    // Kerby 2014: favourable minus unfavourable. Ranks 1 … 6, of which 2 is negative: (19 − 2) / 21.
    EXPECT_NEAR(mrpp::signedRankTest(Values{1, -2, 3, 4, 5, 6}).rankBiserial(), 17.0 / 21, 1e-15);
    EXPECT_EQ(mrpp::signedRankTest(Values{1, 2, 3}).rankBiserial(), 1);
    EXPECT_EQ(mrpp::signedRankTest(Values{-1, -2, 0}).rankBiserial(), -1);
    EXPECT_EQ(mrpp::signedRankTest(Values{0, 0}).rankBiserial(), 0);
}

TEST(Wilson, AgreesWithNewcombe)
{
    // R. Newcombe, Statistics in Medicine 17, 1998, table I, prints the first four digits.
    const auto expectInterval = [](std::size_t successes, std::size_t trials, double low, double high)
    {
        const Interval interval = wilsonInterval(successes, trials);
        EXPECT_NEAR(interval.low, low, 5e-8);
        EXPECT_NEAR(interval.high, high, 5e-8);
    };
    expectInterval(81, 263, 0.2552885, 0.3662096);
    expectInterval(15, 148, 0.0623864, 0.1604872);
    expectInterval(0, 20, 0, 0.1611252);
    expectInterval(1, 29, 0.0061132, 0.1717552);
    expectInterval(10, 10, 0.7224672, 1);
    EXPECT_EQ(wilsonInterval(0, 0), (Interval{0, 1}));
}

TEST(SignTest, CountsBothTailsOfAFairCoin)
{
    EXPECT_NEAR(signTest(9, 1), 22.0 / 1024, 1e-12);
    EXPECT_NEAR(signTest(0, 6), 2.0 / 64, 1e-12);
    EXPECT_EQ(signTest(3, 3), 1);
    EXPECT_EQ(signTest(0, 0), 1);
}

} // namespace
} // namespace mrpp
