#include "framework/support/PairedComparison.h"

#include "framework/support/Bootstrap.h"
#include "framework/support/Quantiles.h"

#include <cmath>
#include <limits>
#include <vector>

namespace mrpp
{

PairedComparison comparePairs(std::span<const double> first, std::span<const double> second)
{
    PairedComparison result;
    result.pairs = first.size();
    double least = std::numeric_limits<double>::infinity();
    for (const std::span<const double> costs : {first, second})
        for (const double cost : costs)
            if (cost > 0)
                least = std::min(least, cost);
    const auto logarithm = [least](double cost) { return std::log(cost > 0 ? cost : least / 2); };
    std::vector<double> ratios;
    std::vector<double> logFirst;
    std::vector<double> logSecond;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        result.firstLess += first[i] < second[i] ? 1 : 0;
        result.secondLess += second[i] < first[i] ? 1 : 0;
        if (first[i] > 0 && second[i] > 0)
            ratios.push_back(first[i] / second[i]);
        const bool isEqual = first[i] == second[i];
        logFirst.push_back(isEqual ? 0 : logarithm(first[i]));
        logSecond.push_back(isEqual ? 0 : logarithm(second[i]));
    }
    if (!ratios.empty())
        result.medianRatio = median(ratios);
    result.ratioInterval = medianInterval(ratios);
    result.test = signedRankTest(logFirst, logSecond);
    result.a12 = effectSizeA12(first, second);
    return result;
}

} // namespace mrpp
