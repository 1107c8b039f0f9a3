#include "reports/summary/Aggregate.h"

#include "framework/evaluation/Metrics.h"
#include "framework/statistics/Profiles.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace mrpp
{

namespace
{

/// Fills in which instances of a place are compared: those that every planner there has finished, unless all
/// of them know that there is no solution.
class Comparable
{
public:
    void add(std::size_t instance, const Answer &answer)
    {
        Seen &seen = instances_[instance];
        ++seen.planners;
        seen.isHopeless = seen.isHopeless && answer.unsolvable();
    }
    void endGroup() { ++planners_; }
    [[nodiscard]] bool contains(std::size_t instance) const
    {
        const Seen &seen = instances_.at(instance);
        return seen.planners == planners_ && !seen.isHopeless;
    }

private:
    struct Seen
    {
        std::size_t planners = 0;
        bool isHopeless = true;
    };
    std::unordered_map<std::size_t, Seen> instances_;
    std::size_t planners_ = 0;
};

} // namespace

std::size_t RunGroup::count(Outcome outcome) const
{
    return static_cast<std::size_t>(std::count_if(
        answers.begin(), answers.end(), [=](const Answer &answer) { return answer.outcome() == outcome; }));
}

std::size_t RunGroup::count(PlannerStatus status) const
{
    return static_cast<std::size_t>(std::count_if(
        answers.begin(), answers.end(), [=](const Answer &answer) { return answer.status() == status; }));
}

std::size_t RunGroup::counted() const
{
    return static_cast<std::size_t>(
        std::count_if(answers.begin(), answers.end(), [](const Answer &answer) { return answer.counts(); }));
}

std::optional<double> RunGroup::successRate() const
{
    const std::size_t all = counted();
    return all == 0 ? std::nullopt : std::optional(static_cast<double>(solved()) / static_cast<double>(all));
}

std::vector<double> RunGroup::costs(std::string_view column) const
{
    const bool countsFailures = isCost(column);
    std::vector<double> values;
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        if (isCompared[i] == 0)
            continue;
        if (const auto value = answers[i].cost(column))
            values.push_back(*value);
        else if (!answers[i].solved() && countsFailures)
            values.push_back(kNoAnswer);
    }
    return values;
}

std::optional<Quartiles> RunGroup::cost(std::string_view column) const
{
    return censoredQuartiles(costs(column));
}

std::optional<Quartiles> RunGroup::ratio(std::string_view cost, std::string_view bound) const
{
    std::vector<double> values;
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        const auto below = numericValue(answers[i].first(), bound);
        if (isCompared[i] == 0 || !below || *below <= 0)
            continue;
        if (!answers[i].solved())
            values.push_back(kNoAnswer);
        else if (const auto above = answers[i].cost(cost))
            values.push_back(*above / *below);
    }
    return censoredQuartiles(std::move(values));
}

std::optional<double> RunGroup::penalizedTime(double limit, double factor) const
{
    std::vector<std::optional<double>> times;
    for (const Answer &answer : answers)
        if (answer.counts())
            times.push_back(answer.cost("time"));
    return penalizedAverage(times, limit, factor);
}

bool isCost(std::string_view column)
{
    const Metric *metric = findMetric(column);
    return metric != nullptr && metric->better == Metric::Better::lower && !column.ends_with("lower_bound");
}

std::vector<RunGroup> groupRuns(std::span<const RunRecord> records)
{
    return groupRuns(records,
                     [](const RunRecord &run) {
                         return RunPlace{run.model, run.problem, run.sweepVariable, run.sweepValue};
                     });
}

std::vector<RunGroup> groupRuns(std::span<const RunRecord> records,
                                const std::function<std::optional<RunPlace>(const RunRecord &)> &placeOf)
{
    std::map<std::pair<RunPlace, std::string>, std::size_t> positions; // by place and planner
    std::vector<RunGroup> groups;
    std::vector<std::map<std::size_t, std::size_t>> answers; // of each group, by instance
    InstanceNumbers instances(records);
    for (const RunRecord &run : records)
    {
        std::optional<RunPlace> place = placeOf(run);
        if (!place)
            continue;
        const auto [position, isNew] = positions.try_emplace({*place, run.planner}, groups.size());
        if (isNew)
        {
            groups.push_back({std::move(*place), run.planner, run.rule, {}, {}, {}});
            answers.emplace_back();
        }
        RunGroup &group = groups[position->second];
        group.runs.push_back(&run);
        const auto [answer, isFirst] =
            answers[position->second].try_emplace(instances.of(run), group.answers.size());
        if (isFirst)
            group.answers.emplace_back();
        group.answers[answer->second].add(run);
    }
    std::map<RunPlace, Comparable> places;
    for (const auto &[key, position] : positions)
    {
        Comparable &place = places[key.first];
        for (const auto &[instance, answer] : answers[position])
            place.add(instance, groups[position].answers[answer]);
        place.endGroup();
    }
    for (const auto &[key, position] : positions)
    {
        RunGroup &group = groups[position];
        const Comparable &place = places.at(key.first);
        group.isCompared.resize(group.answers.size());
        for (const auto &[instance, answer] : answers[position])
            group.isCompared[answer] = place.contains(instance) ? 1 : 0;
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

std::string withRule(std::string_view planner, std::string_view rule)
{
    std::string text(planner);
    return rule.empty() ? text : text.append(" (").append(rule).append(")");
}

} // namespace mrpp
