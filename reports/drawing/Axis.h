#pragma once
/// \file
/// The range and tics of an axis, chosen so that nothing is hidden and everything can be read.

#include <cstddef>
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

/// For measures: logarithmic where all values are positive and span more than two decades, else from zero.
[[nodiscard]] Axis measureAxis(const std::vector<double> &values);

/// For swept variables: from the first to the last value with a little room, a tic at each value where they
/// lie far enough apart, logarithmic where they span more than two decades.
[[nodiscard]] Axis sweepAxis(std::vector<double> values);

/// "10⁴", for axes whose tics would be too long as plain numbers.
[[nodiscard]] std::string powerOfTen(int exponent);

} // namespace mrpp
