#include "framework/statistics/Proportion.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace mrpp
{

Interval wilsonInterval(std::size_t successes, std::size_t trials, double confidence)
{
    if (trials == 0)
        return {0, 1};
    const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
    const auto n = static_cast<double>(trials);
    const double share = static_cast<double>(successes) / n;
    const double centre = share + z * z / (2 * n);
    const double spread = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    const double scale = 1 + z * z / n;
    return {successes == 0 ? 0 : (centre - spread) / scale,
            successes == trials ? 1 : (centre + spread) / scale};
}

double signTest(std::size_t wins, std::size_t losses)
{
    const std::size_t trials = wins + losses;
    if (trials == 0)
        return 1;
    const boost::math::binomial coin(static_cast<double>(trials), 0.5);
    return std::min(1.0, 2 * boost::math::cdf(coin, static_cast<double>(std::min(wins, losses))));
}

} // namespace mrpp
