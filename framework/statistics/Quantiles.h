#pragma once
/// \file
/// Order statistics of a sample: quantiles, the middle half, and how sure its median is.
///
/// Values may be infinite: that is where a cost stands which is only known to be above all others.

#include "framework/statistics/Interval.h"

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

    /// Whether a band or a bar may be drawn: of fewer values quartiles say nothing about others to come.
    [[nodiscard]] bool hasBand() const;
    friend bool operator==(const Quartiles &, const Quartiles &) = default;
};

inline constexpr std::size_t kLeastForBand = 5;

/// Quantile p of x₀ ≤ … ≤ xₙ₋₁ by linear interpolation at position p(n−1) (definition 7 of R. Hyndman and Y.
/// Fan, "Sample quantiles in statistical packages", The American Statistician 50(4), 1996; the default of R,
/// NumPy and spreadsheets). \pre sorted, not empty, 0 ≤ share ≤ 1. O(1).
[[nodiscard]] double quantile(std::span<const double> sorted, double share);

/// Quantiles ¼, ½ and ¾; nothing for an empty sample. O(n log n).
[[nodiscard]] std::optional<Quartiles> quartiles(std::vector<double> values);

/// The same where an infinite value is a failure: nothing unless more than half of the values are finite, as
/// the median is above all that is known then; q3 may be infinite. O(n log n).
[[nodiscard]] std::optional<Quartiles> censoredQuartiles(std::vector<double> values);

/// The quantile ½. \pre not empty. O(n).
[[nodiscard]] double median(std::vector<double> values);

/// With fewer values not even the range from the least to the greatest covers a median 19 times in 20.
inline constexpr std::size_t kLeastForMedianInterval = 6;

/// Interval of the median between two order statistics, the narrowest whose level is kept whatever the
/// distribution: from the k-th value to the k-th from above, with the largest k for which at most (1 −
/// confidence)/2 of fair coin sequences have fewer than k heads (W. J. Conover, "Practical Nonparametric
/// Statistics", 3rd ed., 1999, section 3.2; DescTools::MedianCI(method = "exact") of R). Nothing of fewer
/// than kLeastForMedianInterval values, at 0.95. O(n log n).
[[nodiscard]] std::optional<Interval> medianInterval(std::vector<double> values, double confidence = 0.95);

} // namespace mrpp
