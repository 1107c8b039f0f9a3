#include "framework/statistics/SignedRank.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

namespace mrpp
{

namespace
{

std::vector<std::size_t> ascending(std::span<const double> values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    return order;
}

/// Probability that ranks with random signs give a sum as far from its mean as `statistic`, or farther.
/// Ties make half ranks, so twice the ranks are counted.
double exactP(const std::vector<double> &rank, double statistic)
{
    std::vector<double> ways = {1}; // by twice the sum, as shares of all signs
    for (const double r : rank)
    {
        const auto twice = static_cast<std::size_t>(std::lround(2 * r));
        std::vector<double> next(ways.size() + twice);
        for (std::size_t sum = 0; sum < ways.size(); ++sum)
        {
            next[sum] += ways[sum] / 2;
            next[sum + twice] += ways[sum] / 2;
        }
        ways = std::move(next);
    }
    const std::size_t most = ways.size() - 1;
    auto least = static_cast<std::size_t>(std::lround(2 * statistic));
    least = std::min(least, most - least);
    const double tail =
        std::accumulate(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(least) + 1, 0.0);
    return std::min(1.0, 2 * tail);
}

double normalP(const std::vector<double> &rank, double statistic)
{
    const auto n = static_cast<double>(rank.size());
    double variance = n * (n + 1) * (2 * n + 1) / 24;
    std::vector<double> sorted = rank;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t first = 0, last = 0; first < sorted.size(); first = last)
    {
        while (last < sorted.size() && sorted[last] == sorted[first])
            ++last;
        const auto tied = static_cast<double>(last - first);
        variance -= (tied * tied * tied - tied) / 48;
    }
    const double distance = std::max(0.0, std::abs(statistic - n * (n + 1) / 4) - 0.5);
    return 2 *
           boost::math::cdf(boost::math::complement(boost::math::normal(), distance / std::sqrt(variance)));
}

} // namespace

std::vector<double> ranks(std::span<const double> values)
{
    const std::vector<std::size_t> order = ascending(values);
    std::vector<double> result(values.size());
    for (std::size_t first = 0, last = 0; first < order.size(); first = last)
    {
        while (last < order.size() && values[order[last]] == values[order[first]])
            ++last;
        for (std::size_t i = first; i < last; ++i)
            result[order[i]] = static_cast<double>(first + last + 1) / 2;
    }
    return result;
}

double SignedRankTest::rankBiserial() const
{
    const auto n = static_cast<double>(pairs);
    const double all = n * (n + 1) / 2;
    return pairs == 0 ? 0 : (2 * statistic - all) / all;
}

SignedRankTest signedRankTest(std::span<const double> differences)
{
    constexpr std::size_t kMostExact = 50;
    SignedRankTest test;
    std::vector<double> sizes;
    std::vector<bool> isPositive;
    for (const double difference : differences)
    {
        if (difference == 0)
            continue;
        sizes.push_back(std::abs(difference));
        isPositive.push_back(difference > 0);
    }
    test.pairs = sizes.size();
    test.ties = differences.size() - sizes.size();
    const std::vector<double> rank = ranks(sizes);
    for (std::size_t i = 0; i < rank.size(); ++i)
        test.statistic += isPositive[i] ? rank[i] : 0;
    if (test.pairs < kLeastForSignedRank)
    {
        test.refusal = "only " + std::to_string(test.pairs) + " of " + std::to_string(differences.size()) +
                       " pairs differ; a test needs " + std::to_string(kLeastForSignedRank);
        return test;
    }
    test.exact = test.pairs <= kMostExact;
    test.p = test.exact ? exactP(rank, test.statistic) : normalP(rank, test.statistic);
    return test;
}

std::vector<double> holmAdjusted(std::span<const double> p)
{
    std::vector<double> adjusted(p.size());
    double least = 0;
    std::size_t left = p.size();
    for (const std::size_t i : ascending(p))
    {
        least = std::min(1.0, std::max(least, p[i] * static_cast<double>(left)));
        adjusted[i] = least;
        --left;
    }
    return adjusted;
}

} // namespace mrpp
