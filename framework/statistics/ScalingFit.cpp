#include "framework/statistics/ScalingFit.h"

#include "framework/statistics/Quantiles.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace mrpp
{

namespace
{

constexpr double kTail = 0.025;

Interval middle(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return {quantile(values, kTail), quantile(values, 1 - kTail)};
}

double evaluate(ScalingLaw law, double scale, double rate, double size)
{
    return scale * (law == ScalingLaw::power ? std::pow(size, rate) : std::pow(rate, size));
}

/// Least squares of log cost over log size, or over size.
std::pair<double, double> fit(ScalingLaw law, std::span<const ScalingPoint> points,
                              std::span<const double> medians)
{
    double n = 0;
    double sumX = 0;
    double sumY = 0;
    double sumXX = 0;
    double sumXY = 0;
    const auto abscissa = [law](double size) { return law == ScalingLaw::power ? std::log(size) : size; };
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (!std::isfinite(medians[i]))
            continue;
        ++n;
        sumX += abscissa(points[i].size);
        sumY += std::log(medians[i]);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (!std::isfinite(medians[i]))
            continue;
        const double x = abscissa(points[i].size) - sumX / n;
        sumXX += x * x;
        sumXY += x * (std::log(medians[i]) - sumY / n);
    }
    const double slope = sumXY / sumXX;
    const double scale = std::exp((sumY - slope * sumX) / n);
    return {scale, law == ScalingLaw::power ? slope : std::exp(slope)};
}

double logError(const ScalingModel &model, std::span<const ScalingPoint> points,
                std::span<const double> medians)
{
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double error = std::log10(medians[i] / model.at(points[i].size));
        squares += error * error;
    }
    return std::sqrt(squares / static_cast<double>(points.size()));
}

std::vector<double> mediansOf(std::span<const ScalingPoint> points)
{
    std::vector<double> medians;
    for (const ScalingPoint &point : points)
        medians.push_back(median(point.values));
    return medians;
}

ScalingModel fitLaw(ScalingLaw law, const std::vector<ScalingPoint> &points, std::size_t fitted,
                    std::size_t resamples, Seed seed)
{
    const std::span<const ScalingPoint> small(points.data(), fitted);
    const std::span<const ScalingPoint> large(points.data() + fitted, points.size() - fitted);
    const std::vector<double> medians = mediansOf(points);
    ScalingModel model;
    model.law = law;
    std::tie(model.scale, model.rate) = fit(law, small, medians);
    Random random(seed);
    std::vector<double> drawnMedians(fitted);
    for (std::size_t sample = 0; sample < resamples; ++sample)
    {
        for (std::size_t i = 0; i < fitted; ++i)
        {
            std::vector<double> drawn(small[i].values.size());
            for (double &value : drawn)
                value = small[i].values[random.below(drawn.size())];
            drawnMedians[i] = median(std::move(drawn));
        }
        constexpr std::ptrdiff_t kLeastForLine = 2;
        const auto known = std::count_if(drawnMedians.begin(), drawnMedians.end(),
                                         [](double value) { return std::isfinite(value); });
        if (known >= kLeastForLine)
            model.resampled.push_back(fit(law, small, drawnMedians));
    }
    model.fitError = logError(model, small, medians);
    model.heldOutError = logError(model, large, std::span(medians).subspan(fitted));
    for (std::size_t i = fitted; i < points.size(); ++i)
        model.heldOutWithin += model.band(points[i].size).contains(medians[i]) ? 1 : 0;
    return model;
}

} // namespace

double ScalingModel::at(double size) const
{
    return evaluate(law, scale, rate, size);
}

Interval ScalingModel::band(double size) const
{
    std::vector<double> values;
    values.reserve(resampled.size());
    for (const auto &[ownScale, ownRate] : resampled)
        values.push_back(evaluate(law, ownScale, ownRate, size));
    return middle(std::move(values));
}

Interval ScalingModel::rateInterval() const
{
    std::vector<double> values;
    values.reserve(resampled.size());
    for (const auto &[ownScale, ownRate] : resampled)
        values.push_back(ownRate);
    return middle(std::move(values));
}

const ScalingModel &ScalingFit::better() const
{
    return power.heldOutError <= exponential.heldOutError ? power : exponential;
}

ScalingFit fitScaling(const std::vector<ScalingPoint> &all, std::size_t resamples, Seed seed)
{
    ScalingFit result;
    std::vector<ScalingPoint> points = all;
    std::erase_if(points, [](const ScalingPoint &point) { return !std::isfinite(median(point.values)); });
    result.leftOut = all.size() - points.size();
    if (points.size() < kLeastSizesForScaling)
    {
        result.refusal = "only " + std::to_string(points.size()) +
                         " sizes had more than half of their instances solved; a fit needs " +
                         std::to_string(kLeastSizesForScaling);
        return result;
    }
    if (points.back().size < 2 * points.front().size)
    {
        result.refusal = "the sizes do not even double, so that any law fits";
        return result;
    }
    result.heldOut = std::max<std::size_t>(2, points.size() / 3);
    result.fitted = points.size() - result.heldOut;
    result.splitAt = std::sqrt(points[result.fitted - 1].size * points[result.fitted].size);
    result.power = fitLaw(ScalingLaw::power, points, result.fitted, resamples, seed);
    result.exponential = fitLaw(ScalingLaw::exponential, points, result.fitted, resamples, seed);
    return result;
}

} // namespace mrpp
