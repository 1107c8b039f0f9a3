#include "reports/Aggregate.h"

#include "framework/evaluation/Metrics.h"
#include "framework/support/Profiles.h"

#include <algorithm>
#include <tuple>

namespace mrpp
{

std::size_t RunGroup::solved() const
{
    return count(PlannerStatus::solved);
}

std::size_t RunGroup::count(PlannerStatus status) const
{
    return static_cast<std::size_t>(std::count_if(
        runs.begin(), runs.end(), [status](const RunRecord *run) { return run->status == status; }));
}

std::size_t RunGroup::solvable() const
{
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const RunRecord *run) { return !run->unsolvable(); }));
}

double RunGroup::successRate() const
{
    return runs.empty() ? 0 : static_cast<double>(solved()) / static_cast<double>(runs.size());
}

std::optional<Quartiles> RunGroup::overSolved(std::string_view column) const
{
    std::vector<double> values;
    for (const RunRecord *run : runs)
        if (run->solved())
            if (const auto value = numericValue(*run, column))
                values.push_back(*value);
    return quartiles(std::move(values));
}

std::optional<Quartiles> RunGroup::ratio(std::string_view cost, std::string_view bound) const
{
    std::vector<double> values;
    for (const RunRecord *run : runs)
    {
        const auto above = numericValue(*run, cost);
        const auto below = numericValue(*run, bound);
        if (run->solved() && above && below && *below > 0)
            values.push_back(*above / *below);
    }
    return quartiles(std::move(values));
}

double RunGroup::penalizedTime(double limit, double factor) const
{
    std::vector<std::optional<double>> times;
    for (const RunRecord *run : runs)
        times.push_back(run->solved() ? run->time : std::nullopt);
    return penalizedAverage(times, limit, factor).value_or(0);
}

std::vector<RunGroup> groupRuns(std::span<const RunRecord> records)
{
    using Key = std::tuple<std::string, std::string, std::string, std::optional<double>, std::string>;
    std::map<Key, std::size_t> positions;
    std::vector<RunGroup> groups;
    for (const RunRecord &run : records)
    {
        const auto [position, isNew] = positions.try_emplace(
            Key{run.model, run.problem, run.sweepVariable, run.sweepValue, run.planner}, groups.size());
        if (isNew)
            groups.push_back({run.model, run.problem, run.sweepVariable, run.sweepValue, run.planner, {}});
        groups[position->second].runs.push_back(&run);
    }
    return groups;
}

std::vector<ProblemSummary> summarizeProblems(std::span<const RunRecord> records)
{
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> positions;
    std::vector<ProblemSummary> problems;
    for (RunGroup &group : groupRuns(records))
    {
        const auto [position, isNew] =
            positions.try_emplace({group.model, group.problem, group.sweepVariable}, problems.size());
        if (isNew)
            problems.push_back({group.model, group.problem, group.sweepVariable, {}});
        problems[position->second].groups.push_back(std::move(group));
    }
    for (ProblemSummary &problem : problems)
        std::stable_sort(problem.groups.begin(), problem.groups.end(),
                         [](const RunGroup &a, const RunGroup &b) { return a.sweepValue < b.sweepValue; });
    return problems;
}

std::string metricTitle(std::string_view column)
{
    const Metric *metric = findMetric(column);
    if (metric == nullptr)
        return std::string(column);
    std::string title(metric->title);
    if (!metric->unit.empty())
        title += " (" + std::string(metric->unit) + ")";
    return title;
}

} // namespace mrpp
