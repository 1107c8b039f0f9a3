#pragma once
/// \file
/// Numbers as tables and axes write them: no exponents, and times in a unit that keeps them short.

#include <string>
#include <vector>

namespace mrpp
{

struct TimeUnit
{
    const char *name = "s"; ///< "µs", "ms" or "s"
    double seconds = 1;     ///< how long one unit is
};

/// The unit in which a time of so many seconds is at least one; µs for shorter ones.
[[nodiscard]] TimeUnit timeUnit(double seconds);

/// The unit for a column: that of the geometric middle between the shortest and the longest positive time.
[[nodiscard]] TimeUnit timeUnit(const std::vector<double> &seconds);

/// At least three significant digits, digits before the point always in full: "0.0123", "1.20", "12345".
[[nodiscard]] std::string threeDigits(double value);

/// With `decimals` digits behind the point; those before it in groups of three from 10 000 on.
[[nodiscard]] std::string groupedNumber(double value, int decimals);

} // namespace mrpp
