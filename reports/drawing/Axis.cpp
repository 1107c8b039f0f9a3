#include "reports/drawing/Axis.h"

#include "framework/support/Config.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mrpp
{

namespace
{

constexpr double kTwoDecades = 100;

bool spansDecades(double least, double most)
{
    return least > 0 && most / least > kTwoDecades;
}

/// A named tic at each power of ten within the range and small ones between; over many decades fewer names.
std::vector<Tic> decadeTics(double least, double most)
{
    constexpr int kNamed = 8;
    const int first = static_cast<int>(std::floor(std::log10(least)));
    const int last = static_cast<int>(std::ceil(std::log10(most)));
    const int stride = (last - first) / kNamed + 1;
    std::vector<Tic> tics;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit)
        {
            const double at = digit * std::pow(10.0, exponent);
            if (at < least || at > most || (digit > 1 && stride > 1))
                continue;
            const bool named = digit == 1 && (exponent - first) % stride == 0;
            tics.push_back({at, named ? powerOfTen(exponent) : std::string()});
        }
    return tics;
}

} // namespace

std::string powerOfTen(int exponent)
{
    if (exponent >= -3 && exponent <= 3)
        return formatNumber(std::pow(10.0, exponent));
    constexpr std::array<const char *, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += kRaised[static_cast<std::size_t>(digit - '0')];
    return text;
}

Axis measureAxis(const std::vector<double> &values)
{
    if (values.empty())
        return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (spansDecades(*least, *most))
    {
        constexpr double kRoom = 1.4;
        const double from = *least / kRoom;
        const double to = *most * kRoom;
        return {true, from, to, decadeTics(from, to)};
    }
    constexpr double kRoom = 1.06;
    return {false, std::min(0.0, *least), *most > 0 ? *most * kRoom : 1.0, {}};
}

Axis sweepAxis(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const double least = values.front();
    const double most = values.back();
    const bool logarithmic = spansDecades(least, most);
    const auto scaled = [logarithmic](double value) { return logarithmic ? std::log10(value) : value; };
    const double range = scaled(most) - scaled(least);
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values.size(); ++i)
        gap = std::min(gap, scaled(values[i]) - scaled(values[i - 1]));

    Axis axis{logarithmic, least, most, {}};
    constexpr double kRoom = 0.03;
    if (logarithmic)
    {
        const double factor = std::pow(10.0, range * kRoom);
        axis.least /= factor;
        axis.most *= factor;
    }
    else
    {
        const double room = range > 0 ? range * kRoom : std::max(1.0, std::abs(least) / 2);
        axis.least -= room;
        axis.most += room;
    }
    constexpr double kTicsAtMost = 12;
    if (gap * kTicsAtMost >= range)
        for (const double value : values)
            axis.tics.push_back({value, formatNumber(value)});
    else if (logarithmic)
        axis.tics = decadeTics(axis.least, axis.most);
    return axis;
}

} // namespace mrpp
