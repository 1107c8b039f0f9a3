#pragma once
/// \file
/// The range and tics of an axis, chosen so that nothing is hidden and everything can be read.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct Tic
{
    double at = 0;
    std::string label; ///< empty for a small tic
};

struct Axis
{
    bool logarithmic = false;
    double least = 0;
    double most = 1;
    std::vector<Tic> tics; ///< empty where there are no values
};

/// For measures: logarithmic where all values are positive and span more than two decades, or where that is
/// asked for and they are positive; else from zero.
[[nodiscard]] Axis measureAxis(const std::vector<double> &values,
                               std::optional<bool> logarithmic = std::nullopt);

/// A linear axis of just that range. \pre least < most
[[nodiscard]] Axis evenAxis(double least, double most);

/// For swept variables: from the first to the last value with a little room, a tic at each value where they
/// lie far enough apart, logarithmic where they span more than two decades or that is asked for.
[[nodiscard]] Axis sweepAxis(std::vector<double> values, std::optional<bool> logarithmic = std::nullopt);

/// The axis for a panel so many centimetres wide: where the names of its tics would touch, only every second,
/// fourth, … keeps its name.
[[nodiscard]] Axis thinned(Axis axis, double centimetres);

/// "10⁴", for axes whose tics would be too long as plain numbers.
[[nodiscard]] std::string powerOfTen(int exponent);

} // namespace mrpp
