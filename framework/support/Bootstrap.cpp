#include "framework/support/Bootstrap.h"

#include "framework/support/Quantiles.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <vector>

namespace mrpp
{

double jackknifeAcceleration(std::span<const double> sample, const Statistic &statistic)
{
    std::vector<double> rest(sample.begin() + 1, sample.end()); // without the i-th
    std::vector<double> values;
    for (std::size_t i = 0; i < sample.size(); ++i)
    {
        values.push_back(statistic(rest));
        if (i < rest.size())
            rest[i] = sample[i];
    }
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double squares = 0;
    double cubes = 0;
    for (const double value : values)
    {
        const double difference = mean - value;
        squares += difference * difference;
        cubes += difference * difference * difference;
    }
    return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

std::optional<Interval> bootstrapInterval(std::span<const double> sample, const Statistic &statistic,
                                          const BootstrapOptions &options)
{
    if (sample.size() < kLeastForBootstrap)
        return std::nullopt;
    const double observed = statistic(sample);
    Random random(options.seed);
    std::vector<double> drawn(sample.size());
    std::vector<double> values;
    values.reserve(options.resamples);
    for (std::size_t i = 0; i < options.resamples; ++i)
    {
        for (double &value : drawn)
            value = sample[random.below(sample.size())];
        values.push_back(statistic(drawn));
    }
    std::sort(values.begin(), values.end());
    if (values.front() == values.back())
        return Interval{values.front(), values.back()};

    const boost::math::normal normal;
    // Of values equal to the observed one half count as below: medians of small samples have many.
    const auto below = std::lower_bound(values.begin(), values.end(), observed) - values.begin();
    const auto upTo = std::upper_bound(values.begin(), values.end(), observed) - values.begin();
    const auto resamples = static_cast<double>(values.size());
    const double share = std::clamp((static_cast<double>(below) + static_cast<double>(upTo)) / 2 / resamples,
                                    0.5 / resamples, 1 - 0.5 / resamples);
    const double bias = boost::math::quantile(normal, share);
    const double acceleration = jackknifeAcceleration(sample, statistic);
    const auto end = [&](double probability)
    {
        const double z = bias + boost::math::quantile(normal, probability);
        const double adjusted = boost::math::cdf(normal, bias + z / (1 - acceleration * z));
        return quantile(values, std::clamp(adjusted, 0.0, 1.0));
    };
    const double tail = (1 - options.confidence) / 2;
    return Interval{end(tail), end(1 - tail)};
}

std::optional<Interval> medianInterval(std::span<const double> sample, const BootstrapOptions &options)
{
    return bootstrapInterval(
        sample,
        [](std::span<const double> values) {
            return median({values.begin(), values.end()});
        },
        options);
}

} // namespace mrpp
