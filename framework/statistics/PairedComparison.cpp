#include "framework/statistics/PairedComparison.h"

#include "framework/statistics/Quantiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace mrpp
{

namespace
{

/// How many times larger one cost of a pair is than the other.
struct Factor
{
    std::uint64_t larger = 1;
    std::uint64_t smaller = 1;
};

__extension__ using Product = unsigned __int128;

/// Without rounding: each cost has 63 bits.
bool isLess(const Factor &a, const Factor &b)
{
    return Product{a.larger} * b.smaller < Product{b.larger} * a.smaller;
}

double ratioOf(double first, double second)
{
    if (first == second)
        return 1;
    return second > 0 ? first / second : std::numeric_limits<double>::infinity();
}

} // namespace

std::vector<double> orderOfRatios(std::span<const double> first, std::span<const double> second)
{
    constexpr double kFinest = 2e9; // units of a second's halved nanoseconds: times are whole nanoseconds
    constexpr double kMost = 4e9;   // beyond, 63 bits do not hold that
    double unit = kFinest;
    for (const std::span<const double> costs : {first, second})
        for (const double cost : costs)
            unit = cost > kMost ? 2 : unit;
    const auto whole = [unit](double cost) { return static_cast<std::uint64_t>(std::llround(cost * unit)); };
    std::vector<Factor> factors;
    std::vector<int> signs;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        const std::uint64_t a = whole(first[i]);
        const std::uint64_t b = whole(second[i]);
        factors.push_back({std::max(a, b), std::min(a, b)});
        signs.push_back(a > b ? 1 : a < b ? -1 : 0);
    }
    std::vector<std::size_t> order(factors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return signs[i] == 0; });
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return isLess(factors[a], factors[b]); });
    std::vector<double> numbers(factors.size());
    double number = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        if (i == 0 || isLess(factors[order[i - 1]], factors[order[i]]))
            ++number;
        numbers[order[i]] = signs[order[i]] * number;
    }
    return numbers;
}

PairedComparison::Direction PairedComparison::direction() const
{
    const double towardsFirst = rankBiserial();
    if (towardsFirst == 0)
        return Direction::none;
    const bool isFirst = towardsFirst > 0;
    const bool ratioSaysOtherwise = isFirst ? medianRatio > 1 : medianRatio < 1;
    const bool winsSayOtherwise = isFirst ? firstLess < secondLess : secondLess < firstLess;
    if (ratioSaysOtherwise || winsSayOtherwise)
        return Direction::unclear;
    return isFirst ? Direction::first : Direction::second;
}

double PairedComparison::rankBiserial() const
{
    return -test.rankBiserial();
}

PairedComparison comparePairs(std::span<const double> first, std::span<const double> second)
{
    PairedComparison result;
    result.pairs = first.size();
    std::vector<double> ratios;
    for (std::size_t i = 0; i < first.size(); ++i)
        ratios.push_back(ratioOf(first[i], second[i]));
    const std::vector<double> order = orderOfRatios(first, second);
    for (const double number : order)
    {
        result.firstLess += number < 0 ? 1 : 0;
        result.secondLess += number > 0 ? 1 : 0;
    }
    if (!ratios.empty())
        result.medianRatio = median(ratios);
    result.ratioInterval = medianInterval(std::move(ratios));
    result.test = signedRankTest(order);
    return result;
}

} // namespace mrpp
