#include "framework/statistics/Friedman.h"

#include "framework/statistics/SignedRank.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace mrpp
{

double nemenyiQuantile(std::size_t k, double level)
{
    const boost::math::normal normal;
    const auto others = static_cast<double>(k) - 1;
    // P(range ≤ q) = k ∫ φ(z) (Φ(z) − Φ(z − q))^(k−1) dz
    const auto excess = [&](double q)
    {
        const auto density = [&](double z)
        {
            return boost::math::pdf(normal, z) *
                   std::pow(boost::math::cdf(normal, z) - boost::math::cdf(normal, z - q), others);
        };
        constexpr double kFar = 9;
        return (others + 1) * boost::math::quadrature::gauss_kronrod<double, 61>::integrate(density, -kFar,
                                                                                            kFar, 10, 1e-12) -
               (1 - level);
    };
    constexpr double kMost = 20;
    std::uintmax_t iterations = 100;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, 1e-6, kMost, boost::math::tools::eps_tolerance<double>(40), iterations);
    return (low + high) / 2 / std::sqrt(2.0);
}

FriedmanTest friedmanTest(const std::vector<std::vector<double>> &costs)
{
    FriedmanTest test;
    test.problems = costs.size();
    const std::size_t planners = costs.empty() ? 0 : costs.front().size();
    const auto n = static_cast<double>(costs.size());
    const auto k = static_cast<double>(planners);
    test.meanRanks.assign(planners, 0);
    double tied = 0; // Σ t³ − t over the ties of every row
    for (const std::vector<double> &row : costs)
    {
        const std::vector<double> rank = ranks(row);
        std::map<double, double> sizes;
        for (std::size_t i = 0; i < planners; ++i)
        {
            test.meanRanks[i] += rank[i];
            ++sizes[rank[i]];
        }
        for (const auto &[value, size] : sizes)
            tied += size * size * size - size;
    }
    for (double &rank : test.meanRanks)
        rank /= n;
    if (planners < 3 || test.problems < kLeastForFriedman)
    {
        test.refusal = planners < 3 ? "it compares three planners or more"
                                    : "only " + std::to_string(test.problems) +
                                          " points had an answer of any planner; it needs " +
                                          std::to_string(kLeastForFriedman);
        return test;
    }
    double spread = 0;
    for (const double rank : test.meanRanks)
        spread += (rank - (k + 1) / 2) * (rank - (k + 1) / 2);
    const double variance = k * (k + 1) - tied / (n * (k - 1));
    test.chiSquared = variance > 0 ? 12 * n * spread / variance : 0;
    test.chiSquaredP =
        boost::math::cdf(boost::math::complement(boost::math::chi_squared(k - 1), test.chiSquared));
    const double rest = n * (k - 1) - test.chiSquared;
    constexpr double kRounding = 1e-9;
    test.f = rest > kRounding ? (n - 1) * test.chiSquared / rest : std::numeric_limits<double>::infinity();
    test.p = rest > kRounding ? boost::math::cdf(boost::math::complement(
                                    boost::math::fisher_f(k - 1, (k - 1) * (n - 1)), test.f))
                              : 0;
    test.criticalDifference = nemenyiQuantile(planners) * std::sqrt(k * (k + 1) / (6 * n));
    return test;
}

std::vector<std::pair<std::size_t, std::size_t>> indistinguishable(std::vector<double> meanRanks,
                                                                   double criticalDifference)
{
    std::sort(meanRanks.begin(), meanRanks.end());
    std::vector<std::pair<std::size_t, std::size_t>> groups;
    for (std::size_t first = 0; first < meanRanks.size(); ++first)
    {
        std::size_t last = first;
        while (last + 1 < meanRanks.size() && meanRanks[last + 1] - meanRanks[first] < criticalDifference)
            ++last;
        if (last > first && (groups.empty() || groups.back().second < last))
            groups.emplace_back(first, last);
    }
    return groups;
}

} // namespace mrpp
