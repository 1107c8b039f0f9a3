#pragma once
/// \file
/// How a cost grows with size: a power law or an exponential one, fitted to the smaller sizes and checked on
/// the larger ones.
///
/// After H. Hoos and T. Stützle's way to study empirical scaling (T. Stützle, Y. Mu, H. Hoos et al.,
/// "Empirical scaling analyser", 2014–2020): medians, bootstrap bands, extrapolation. Fits are least squares
/// of log cost.

#include "framework/statistics/Interval.h"
#include "framework/support/Random.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// What was measured at one size.
struct ScalingPoint
{
    double size = 0;            ///< > 0
    std::vector<double> values; ///< > 0, at least one; infinite of what failed, which is above all others
};

enum class ScalingLaw
{
    power,       ///< cost = scale · size^rate
    exponential, ///< cost = scale · rate^size
};

struct ScalingModel
{
    ScalingLaw law = ScalingLaw::power;
    double scale = 0;
    double rate = 0;
    double fitError = 0;           ///< root mean square of log₁₀(median / model) at the fitted sizes
    double heldOutError = 0;       ///< the same at the held-out sizes
    std::size_t heldOutWithin = 0; ///< held-out medians within the band
    std::vector<std::pair<double, double>> resampled; ///< scale and rate of each bootstrap sample

    [[nodiscard]] double at(double size) const;
    /// 95 % bootstrap band of the model there. O(resamples log resamples).
    [[nodiscard]] Interval band(double size) const;
    /// 95 % bootstrap interval of the rate.
    [[nodiscard]] Interval rateInterval() const;
};

struct ScalingFit
{
    ScalingModel power;
    ScalingModel exponential;
    std::size_t fitted = 0;  ///< the smaller sizes
    std::size_t heldOut = 0; ///< the larger sizes, which no fit has seen
    std::size_t leftOut = 0; ///< sizes without a median: half or more of their values are infinite
    double splitAt = 0;      ///< between the largest fitted and the least held-out size, their geometric mean
    std::string refusal;     ///< why there is no fit; empty where there is one

    /// The law that foretells the held-out sizes better.
    [[nodiscard]] const ScalingModel &better() const;
};

inline constexpr std::size_t kLeastSizesForScaling = 5;

/// Fits both laws to the medians of the smaller two thirds of the sizes that have one. Refuses fewer than
/// kLeastSizesForScaling such sizes, and sizes that do not even double. Bands come from resampling the values
/// at each size; a resample in which a size's median is infinite leaves that size out. O(resamples · number
/// of values). \pre sizes are distinct and ascending
[[nodiscard]] ScalingFit fitScaling(const std::vector<ScalingPoint> &points, std::size_t resamples = 1000,
                                    Seed seed = 1);

} // namespace mrpp
