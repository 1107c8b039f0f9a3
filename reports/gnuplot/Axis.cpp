#include "reports/gnuplot/Axis.h"

#include "framework/support/Config.h"
#include "reports/picture/Numbers.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
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

/// Whole numbers in full, others with three significant digits.
std::string shortNumber(double value)
{
    return value == std::round(value) ? formatNumber(value) : fmt::format("{:.3g}", value);
}

/// A named tic at each power of ten within the range and small ones between; over many decades fewer names,
/// over few also at 2 and 5.
std::vector<Tic> decadeTics(double least, double most)
{
    constexpr int kNamed = 8;
    const int first = static_cast<int>(std::floor(std::log10(least)));
    const int last = static_cast<int>(std::ceil(std::log10(most)));
    const int stride = (last - first) / kNamed + 1;
    const auto isWithin = [&](double at) { return at >= least && at <= most; };
    int powers = 0;
    bool isPlain = true;
    for (int exponent = first; exponent <= last; ++exponent)
        if (isWithin(std::pow(10.0, exponent)))
        {
            ++powers;
            constexpr int kLeastPlain = -3;
            constexpr int kMostPlain = 6;
            isPlain = isPlain && exponent >= kLeastPlain && exponent <= kMostPlain;
        }
    constexpr int kFew = 3;
    std::vector<Tic> tics;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit)
        {
            const double at = digit * std::pow(10.0, exponent);
            if (!isWithin(at) || (digit > 1 && stride > 1))
                continue;
            const bool named =
                digit == 1 ? (exponent - first) % stride == 0 : powers < kFew && (digit == 2 || digit == 5);
            std::string label;
            if (named && isPlain)
                label = groupedNumber(at, std::max(0, -exponent));
            else if (named)
                label = (digit == 1 ? "" : std::to_string(digit) + "·") + powerOfTen(exponent);
            tics.push_back({at, std::move(label)});
        }
    return tics;
}

/// Four to eleven tics at multiples of 1, 2 or 5 times a power of ten, all named in one style.
std::vector<Tic> evenTics(double least, double most)
{
    constexpr double kStepsAtLeast = 4;
    const double room = (most - least) / kStepsAtLeast;
    int exponent = static_cast<int>(std::floor(std::log10(room)));
    const double digits = room / std::pow(10.0, exponent);
    const double digit = digits >= 5 ? 5 : digits >= 2 ? 2 : 1;
    const double step = digit * std::pow(10.0, exponent);
    constexpr double kMostPlain = 1e7;
    constexpr int kLeastPlain = -4;
    const bool isPlain = std::max(std::abs(least), std::abs(most)) < kMostPlain && exponent >= kLeastPlain;
    std::vector<Tic> tics;
    for (double i = std::ceil(least / step); i * step <= most; ++i)
    {
        std::string label = "0";
        if (isPlain)
            label = groupedNumber(i * step, std::max(0, -exponent));
        else if (i != 0)
            label = groupedNumber(i * digit, 0) + "·" + powerOfTen(exponent);
        tics.push_back({i == 0 ? 0 : i * step, i == 0 ? "0" : std::move(label)});
    }
    return tics;
}

} // namespace

std::string powerOfTen(int exponent)
{
    constexpr std::array<const char *, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += kRaised[static_cast<std::size_t>(digit - '0')];
    return text;
}

Axis thinned(Axis axis, double centimetres)
{
    constexpr double kDigit = 0.2;
    constexpr double kGap = 0.3;
    const auto scaled = [&axis](double at) { return axis.logarithmic ? std::log10(at) : at; };
    const double unit = centimetres / (scaled(axis.most) - scaled(axis.least));
    const auto touches = [&](const Tic &left, const Tic &right)
    {
        const auto characters = static_cast<double>(characterCount(left.label) + characterCount(right.label));
        return unit * (scaled(right.at) - scaled(left.at)) < kGap + kDigit * characters / 2;
    };
    for (;;)
    {
        std::vector<Tic *> named;
        for (Tic &tic : axis.tics)
            if (!tic.label.empty())
                named.push_back(&tic);
        const auto crowded = std::adjacent_find(named.begin(), named.end(),
                                                [&](const Tic *a, const Tic *b) { return touches(*a, *b); });
        if (crowded == named.end() || named.size() <= 2)
            return axis;
        for (std::size_t i = 1; i < named.size(); i += 2)
            named[i]->label.clear();
    }
}

Axis measureAxis(const std::vector<double> &values, std::optional<bool> logarithmic)
{
    if (values.empty())
        return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (*least > 0 && logarithmic.value_or(spansDecades(*least, *most)))
    {
        constexpr double kRoom = 1.4;
        const double from = *least / kRoom;
        const double to = *most * kRoom;
        return {true, from, to, decadeTics(from, to)};
    }
    constexpr double kRoom = 1.06;
    const double from = std::min(0.0, *least);
    const double to = *most > 0 ? *most * kRoom : 1.0;
    return evenAxis(from, to);
}

Axis evenAxis(double least, double most)
{
    return {false, least, most, evenTics(least, most)};
}

Axis sweepAxis(std::vector<double> values, std::optional<bool> wish)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const double least = values.front();
    const double most = values.back();
    const bool logarithmic = least > 0 && wish.value_or(spansDecades(least, most));
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
            axis.tics.push_back({value, shortNumber(value)});
    else if (logarithmic)
        axis.tics = decadeTics(axis.least, axis.most);
    else
        axis.tics = evenTics(axis.least, axis.most);
    return axis;
}

} // namespace mrpp
