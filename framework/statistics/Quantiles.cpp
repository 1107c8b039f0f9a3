#include "framework/statistics/Quantiles.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numeric>

namespace mrpp
{

bool Quartiles::hasBand() const
{
    return count >= kLeastForBand && std::isfinite(q3);
}

double quantile(std::span<const double> sorted, double share)
{
    const double position = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double part = position - static_cast<double>(below);
    if (part == 0 || sorted[above] == sorted[below]) // ∞ − ∞ and 0 · ∞ are no numbers
        return sorted[below];
    return sorted[below] + part * (sorted[above] - sorted[below]);
}

std::optional<Quartiles> quartiles(std::vector<double> values)
{
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    return Quartiles{quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75), values.size()};
}

std::optional<Quartiles> censoredQuartiles(std::vector<double> values)
{
    const std::optional<Quartiles> summary = quartiles(std::move(values));
    return summary && std::isfinite(summary->median) ? summary : std::nullopt;
}

double median(std::vector<double> values)
{
    const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), upper, values.end());
    if (values.size() % 2 == 1)
        return *upper;
    return std::midpoint(*std::max_element(values.begin(), upper), *upper);
}

std::optional<Interval> medianInterval(std::vector<double> values, double confidence)
{
    if (values.empty())
        return std::nullopt;
    const boost::math::binomial coins(static_cast<double>(values.size()), 0.5);
    const double tail = (1 - confidence) / 2;
    const auto isCovered = [&](std::size_t k)
    { return boost::math::cdf(coins, static_cast<double>(k - 1)) <= tail; };
    if (!isCovered(1))
        return std::nullopt;
    const double guess =
        static_cast<double>(values.size()) / 2 - std::sqrt(static_cast<double>(values.size()));
    auto k = static_cast<std::size_t>(std::max(1.0, guess)); // two deviations below the middle
    while (k > 1 && !isCovered(k))
        --k;
    while (k + 1 <= values.size() / 2 && isCovered(k + 1))
        ++k;
    std::sort(values.begin(), values.end());
    return Interval{values[k - 1], values[values.size() - k]};
}

} // namespace mrpp
