/// Intervals hold what they promise, by simulation. MRPP_COVERAGE=50 takes fifty times as many samples.

#include "framework/statistics/PairedComparison.h"
#include "framework/statistics/Proportion.h"
#include "framework/statistics/Quantiles.h"
#include "framework/support/Random.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace mrpp
{
namespace
{

std::size_t samples(std::size_t fast)
{
    const char *factor = std::getenv("MRPP_COVERAGE");
    return fast * (factor == nullptr ? 1 : std::max<std::size_t>(1, std::strtoul(factor, nullptr, 10)));
}

struct Distribution
{
    const char *name;
    double median;
    double (*draw)(Random &);
};

double logistic(Random &random)
{
    const double u = random.uniform();
    return std::log((u + 1e-300) / (1 - u));
}

const std::vector<Distribution> kDistributions = {
    {"uniform", 0.5, [](Random &random) { return random.uniform(); }},
    {"exponential", std::log(2.0), [](Random &random) { return -std::log(1 - random.uniform()); }},
    {"log-logistic, heavy tailed", 1, [](Random &random) { return std::exp(2 * logistic(random)); }},
    {"whole numbers, many ties", 3, [](Random &random) { return static_cast<double>(random.below(5)) + 1; }},
};

class Coverage : public ::testing::TestWithParam<std::size_t>
{};

TEST_P(Coverage, OfMediansIsTheirLevel)
{
    const std::size_t size = GetParam();
    Random random(size);
    for (const Distribution &distribution : kDistributions)
    {
        const std::size_t count = samples(4000);
        std::size_t covered = 0;
        for (std::size_t i = 0; i < count; ++i)
        {
            std::vector<double> sample(size);
            for (double &value : sample)
                value = distribution.draw(random);
            covered += medianInterval(std::move(sample)).value().contains(distribution.median) ? 1 : 0;
        }
        const double share = static_cast<double>(covered) / static_cast<double>(count);
        RecordProperty(distribution.name, std::to_string(share));
        EXPECT_GE(share, 0.925) << distribution.name << ", n = " << size; // the level less 2.5 %
    }
}

TEST_P(Coverage, OfMedianRatiosIsTheirLevel)
{
    const std::size_t size = GetParam();
    Random random(size + 1);
    const std::size_t count = samples(2000);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        std::vector<double> first(size);
        std::vector<double> second(size);
        for (std::size_t j = 0; j < size; ++j)
        {
            second[j] = 10 - 100 * std::log(1 - random.uniform());
            first[j] = second[j] * 0.8 * std::exp(0.3 * logistic(random)); // the median ratio is 0.8
        }
        covered += comparePairs(first, second).ratioInterval.value().contains(0.8) ? 1 : 0;
    }
    EXPECT_GE(static_cast<double>(covered) / static_cast<double>(count), 0.925) << size;
}

TEST_P(Coverage, OfProportionsIsTheirLevelOnAverage)
{
    const std::size_t size = GetParam();
    Random random(size + 2);
    const std::size_t count = samples(40000);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double p = random.uniform();
        std::size_t successes = 0;
        for (std::size_t trial = 0; trial < size; ++trial)
            successes += random.uniform() < p ? 1 : 0;
        covered += wilsonInterval(successes, size).contains(p) ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(covered) / static_cast<double>(count), 0.95, 0.02) << size;
}

TEST_P(Coverage, SignedRankTestFindsChanceInOneOfTwentyAtMost)
{
    const std::size_t size = GetParam();
    Random random(size + 3);
    const std::size_t count = samples(4000);
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        std::vector<double> first(size);
        std::vector<double> second(size);
        for (std::size_t j = 0; j < size; ++j) // ratios of small whole numbers: many ties
        {
            first[j] = static_cast<double>(random.below(4) + 1) * 6;
            second[j] = static_cast<double>(random.below(4) + 1) * 6;
        }
        found += comparePairs(first, second).test.p.value_or(1) <= 0.05 ? 1 : 0;
    }
    EXPECT_LE(static_cast<double>(found) / static_cast<double>(count), 0.06) << size;
}

INSTANTIATE_TEST_SUITE_P(Sizes, Coverage, ::testing::Values(8, 20, 50));

} // namespace
} // namespace mrpp
