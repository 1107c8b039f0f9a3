#include "reports/picture/Numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace mrpp
{

TimeUnit timeUnit(double seconds)
{
    if (seconds >= 1)
        return {"s", 1};
    return seconds >= 1e-3 ? TimeUnit{"ms", 1e-3} : TimeUnit{"µs", 1e-6};
}

TimeUnit timeUnit(const std::vector<double> &seconds)
{
    double least = 0;
    double most = 0;
    for (const double value : seconds)
    {
        if (value > 0 && (least == 0 || value < least))
            least = value;
        most = std::max(most, value);
    }
    return least > 0 ? timeUnit(std::sqrt(least) * std::sqrt(most)) : TimeUnit{};
}

std::string threeDigits(double value)
{
    if (value == 0 || !std::isfinite(value))
        return fmt::format("{:.0f}", value);
    const std::string rounded = fmt::format("{:.2e}", value); // 9.999 becomes 1.00e+01
    const int exponent = std::atoi(rounded.c_str() + rounded.find('e') + 1);
    return fmt::format("{:.{}f}", value, std::max(0, 2 - exponent));
}

std::string groupedNumber(double value, int decimals)
{
    std::string text = fmt::format("{:.{}f}", value, decimals);
    const std::size_t begin = text.front() == '-' ? 1 : 0;
    const std::size_t end = std::min(text.find('.'), text.size());
    constexpr std::size_t kUngrouped = 4;
    if (end - begin > kUngrouped)
        for (std::size_t at = end; at > begin + 3;)
        {
            at -= 3;
            text.insert(at, "\u202F"); // a narrow blank at which no line breaks
        }
    return text;
}

} // namespace mrpp
