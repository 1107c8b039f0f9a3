#include "framework/statistics/Profiles.h"

#include <algorithm>

namespace mrpp
{

std::optional<double> penalizedAverage(std::span<const std::optional<double>> times, double limit,
                                       double factor)
{
    if (times.empty())
        return std::nullopt;
    double sum = 0;
    for (const std::optional<double> &time : times)
        sum += time.value_or(factor * limit);
    return sum / static_cast<double>(times.size());
}

std::vector<StepPoint> ecdf(std::vector<double> values, std::size_t runs)
{
    std::sort(values.begin(), values.end());
    std::vector<StepPoint> steps;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i + 1 == values.size() || values[i + 1] != values[i])
            steps.push_back({values[i], static_cast<double>(i + 1) / static_cast<double>(runs)});
    return steps;
}

std::vector<StepPoint> cactus(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    std::vector<StepPoint> steps;
    for (const double time : times)
        steps.push_back({static_cast<double>(steps.size() + 1), time});
    return steps;
}

std::vector<std::vector<StepPoint>>
performanceProfiles(const std::vector<std::vector<std::optional<double>>> &costs, const Alike &alike)
{
    const std::size_t planners = costs.empty() ? 0 : costs.front().size();
    std::vector<std::vector<double>> ratios(planners);
    for (const std::vector<std::optional<double>> &row : costs)
    {
        std::optional<double> best;
        for (const std::optional<double> &cost : row)
            if (cost && (!best || *cost < *best))
                best = cost;
        for (std::size_t i = 0; i < planners; ++i)
            if (row[i] && alike(*best, *row[i]))
                ratios[i].push_back(1);
            else if (row[i] && *best > 0)
                ratios[i].push_back(*row[i] / *best);
    }
    std::vector<std::vector<StepPoint>> profiles;
    for (std::vector<double> &own : ratios)
    {
        profiles.push_back(ecdf(std::move(own), costs.size()));
        if (profiles.back().empty() || profiles.back().front().x > 1)
            profiles.back().insert(profiles.back().begin(), {1, 0});
    }
    return profiles;
}

} // namespace mrpp
