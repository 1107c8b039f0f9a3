#include "framework/support/Quantiles.h"

#include <algorithm>
#include <numeric>

namespace mrpp
{

double quantile(std::span<const double> sorted, double share)
{
    const double position = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::optional<Quartiles> quartiles(std::vector<double> values)
{
    if (values.empty())
        return std::nullopt;
    std::sort(values.begin(), values.end());
    return Quartiles{quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75), values.size()};
}

double median(std::vector<double> values)
{
    const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), upper, values.end());
    if (values.size() % 2 == 1)
        return *upper;
    return std::midpoint(*std::max_element(values.begin(), upper), *upper);
}

} // namespace mrpp
