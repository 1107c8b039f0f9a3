#pragma once
/// \file
/// Order statistics of a sample: quantiles and the middle half.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

/// The middle half of a sample.
struct Quartiles
{
    double q1 = 0;
    double median = 0;
    double q3 = 0;
    std::size_t count = 0; ///< sample size

    friend bool operator==(const Quartiles &, const Quartiles &) = default;
};

/// Quantile p of x₀ ≤ … ≤ xₙ₋₁ by linear interpolation at position p(n−1) (definition 7 of R. Hyndman and Y.
/// Fan, "Sample quantiles in statistical packages", The American Statistician 50(4), 1996; the default of R,
/// NumPy and spreadsheets). \pre sorted, not empty, 0 ≤ share ≤ 1. O(1).
[[nodiscard]] double quantile(std::span<const double> sorted, double share);

/// Quantiles ¼, ½ and ¾; nothing for an empty sample. O(n log n).
[[nodiscard]] std::optional<Quartiles> quartiles(std::vector<double> values);

/// The quantile ½. \pre not empty. O(n).
[[nodiscard]] double median(std::vector<double> values);

} // namespace mrpp
