/// Answers exact_ranks.py. A line of the input is `pairs a1 b1 a2 b2 …`, answered by the signed-rank
/// statistic of the ratios, p and the order of the ratios' sizes with their signs; or `ranks K r c11 … c1r
/// c21 …`, costs of K planners on points of r repetitions each (-1: failed), answered by the planners' mean
/// ranks.

#include "framework/statistics/Friedman.h"
#include "framework/statistics/PairedComparison.h"
#include "framework/statistics/Quantiles.h"

#include <cstdio>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

void answerPairs(std::istringstream &line)
{
    std::vector<double> first;
    std::vector<double> second;
    for (double a = 0, b = 0; line >> a >> b;)
    {
        first.push_back(a);
        second.push_back(b);
    }
    const mrpp::PairedComparison comparison = mrpp::comparePairs(first, second);
    std::printf("%.1f %.17g", comparison.test.statistic, comparison.test.p.value_or(-1));
    for (const double number : mrpp::orderOfRatios(first, second))
        std::printf(" %.0f", number);
    std::printf("\n");
}

void answerRanks(std::istringstream &line)
{
    std::size_t planners = 0;
    std::size_t repetitions = 0;
    line >> planners >> repetitions;
    std::vector<std::vector<double>> costs;
    std::vector<double> values;
    for (double cost = 0; line >> cost;)
    {
        values.push_back(cost < 0 ? std::numeric_limits<double>::infinity() : cost);
        if (values.size() < repetitions)
            continue;
        if (costs.empty() || costs.back().size() == planners)
            costs.emplace_back();
        costs.back().push_back(mrpp::median(values));
        values.clear();
    }
    for (const double rank : mrpp::friedmanTest(costs).meanRanks)
        std::printf("%.17g ", rank);
    std::printf("\n");
}

} // namespace

int main()
{
    for (std::string text; std::getline(std::cin, text);)
    {
        std::istringstream line(text);
        std::string kind;
        line >> kind;
        if (kind == "pairs")
            answerPairs(line);
        else
            answerRanks(line);
    }
    return 0;
}
