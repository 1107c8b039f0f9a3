#include "framework/statistics/Friedman.h"

#include <cmath>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

TEST(Friedman, AgreesWithR)
{
    // The example of R's friedman.test, ways of rounding first base: chi-squared = 11.143, p-value =
    // 0.003805.
    const FriedmanTest test = friedmanTest(
        {{5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40}, {5.90, 5.85, 5.70},
         {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35}, {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70},
         {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45}, {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40},
         {5.45, 5.55, 5.50}, {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
         {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}});
    EXPECT_NEAR(test.chiSquared, 11.142857, 5e-7);
    EXPECT_NEAR(test.chiSquaredP, 0.003805041, 5e-10);
    EXPECT_NEAR(test.f, 7.121739, 5e-7);
    EXPECT_NEAR(test.p.value(), 0.0021712984, 5e-11);
}

TEST(Friedman, AgreesWithDemsar)
{
    // J. Demšar, JMLR 7, 2006, table 6 (areas under curves, larger is better): mean
    // ranks 3.143, 2.000, 2.893, 1.964. The paper ranks the two 0.975 of one row apart.
    std::vector<std::vector<double>> costs = {
        {0.763, 0.768, 0.771, 0.798},   {0.599, 0.591, 0.590, 0.569}, {0.954, 0.971, 0.968, 0.967},
        {0.628, 0.661, 0.654, 0.657},   {0.882, 0.888, 0.886, 0.898}, {0.936, 0.931, 0.916, 0.931},
        {0.661, 0.668, 0.609, 0.685},   {0.583, 0.583, 0.563, 0.625}, {0.775, 0.838, 0.866, 0.875},
        {1.000, 1.000, 1.000, 1.000},   {0.940, 0.962, 0.965, 0.962}, {0.619, 0.666, 0.614, 0.669},
        {0.972, 0.981, 0.97501, 0.975}, {0.957, 0.978, 0.946, 0.970}};
    for (auto &row : costs)
        for (double &value : row)
            value = -value;
    const FriedmanTest test = friedmanTest(costs);
    EXPECT_NEAR(test.meanRanks[0], 44.0 / 14, 1e-12);
    EXPECT_NEAR(test.meanRanks[1], 28.0 / 14, 1e-12);
    EXPECT_NEAR(test.meanRanks[2], 40.5 / 14, 1e-12);
    EXPECT_NEAR(test.meanRanks[3], 27.5 / 14, 1e-12);
    EXPECT_NEAR(test.criticalDifference, 2.569032 * std::sqrt(20.0 / 84), 1e-6); // 1.25 in the paper
}

TEST(Friedman, NemenyiQuantilesAreThoseOfTables)
{
    // qtukey(0.95, k, Inf) / sqrt(2) and qtukey(0.9, k, Inf) / sqrt(2), as R prints them.
    const std::vector<double> at5 = {1.959964, 2.343701, 2.569032, 2.727774, 2.849705,
                                     2.948320, 3.030879, 3.101730, 3.163684};
    const std::vector<double> at10 = {1.644854, 2.052293, 2.291341, 2.459516, 2.588521,
                                      2.692732, 2.779884, 2.854606, 2.919889};
    for (std::size_t i = 0; i < at5.size(); ++i)
    {
        EXPECT_NEAR(nemenyiQuantile(i + 2), at5[i], 1e-6) << i + 2;
        EXPECT_NEAR(nemenyiQuantile(i + 2, 0.1), at10[i], 1e-6) << i + 2;
    }
}

TEST(Friedman, RefusesAndSaysWhy)
{
    const FriedmanTest few = friedmanTest(std::vector<std::vector<double>>(9, {1, 2, 3}));
    EXPECT_FALSE(few.p);
    EXPECT_EQ(few.refusal, "only 9 points had an answer of any planner; it needs 10");
    EXPECT_EQ(friedmanTest(std::vector<std::vector<double>>(20, {1, 2})).refusal,
              "it compares three planners or more");
    EXPECT_EQ(friedmanTest(std::vector<std::vector<double>>(20, {1, 2, 3})).p, 0);
    EXPECT_EQ(friedmanTest(std::vector<std::vector<double>>(20, {1, 1, 1})).p, 1);
}

TEST(Friedman, GroupsWhoCannotBeToldApart)
{
    using Groups = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(indistinguishable({3.143, 2.000, 2.893, 1.964}, 1.25), (Groups{{0, 3}}));
    EXPECT_EQ(indistinguishable({1, 1.5, 2.2, 4}, 1), (Groups{{0, 1}, {1, 2}}));
    EXPECT_EQ(indistinguishable({1, 2, 3}, 0.5), Groups());
}

} // namespace
} // namespace mrpp
