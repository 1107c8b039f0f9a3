#pragma once
/// \file
/// A confidence interval.

namespace mrpp
{

struct Interval
{
    double low = 0;
    double high = 0;

    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
    friend bool operator==(const Interval &, const Interval &) = default;
};

} // namespace mrpp
