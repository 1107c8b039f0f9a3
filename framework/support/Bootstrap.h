#pragma once
/// \file
/// Confidence intervals of any statistic of a sample, without assumptions about its distribution.
///
/// \code
/// const auto interval = bootstrapInterval(ratios, [](std::span<const double> s) { return median({s.begin(),
/// s.end()}); }); \endcode

#include "framework/support/Interval.h"
#include "framework/support/Random.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace mrpp
{

using Statistic = std::function<double(std::span<const double>)>;

struct BootstrapOptions
{
    double confidence = 0.95;
    std::size_t resamples = 2000;
    Seed seed = 1; ///< the same seed gives the same interval
};

/// Samples smaller than this get no interval: even the range from their least to their greatest value would
/// not cover a median often enough.
inline constexpr std::size_t kLeastForBootstrap = 8;

/// Bias-corrected and accelerated (BCa) interval: B. Efron, "Better bootstrap confidence intervals", JASA
/// 82(397), 1987; the acceleration by the jackknife, quantiles as in quantile(). Nothing where the sample is
/// smaller than kLeastForBootstrap. O((resamples + n) · cost of the statistic).
[[nodiscard]] std::optional<Interval> bootstrapInterval(std::span<const double> sample,
                                                        const Statistic &statistic,
                                                        const BootstrapOptions &options = {});

/// Of the median.
[[nodiscard]] std::optional<Interval> medianInterval(std::span<const double> sample,
                                                     const BootstrapOptions &options = {});

/// Jackknife estimate of the acceleration: Σd³ / 6(Σd²)^1.5 over the differences d between the mean of the
/// leave-one-out values and each of them; 0 where they are all equal.
[[nodiscard]] double jackknifeAcceleration(std::span<const double> sample, const Statistic &statistic);

} // namespace mrpp
