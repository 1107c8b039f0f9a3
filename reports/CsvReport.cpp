#include "reports/CsvReport.h"

#include "framework/statistics/Proportion.h"
#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "reports/document/Csv.h"
#include "reports/summary/Aggregate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <unordered_map>

namespace mrpp
{

namespace
{

constexpr std::array<std::string_view, 8> kSummarized = {
    "time",         "path_length", "optimized_path_length", "makespan", "optimized_makespan", "actions",
    "sum_of_costs", "memory"};

constexpr std::array<PlannerStatus, 10> kOtherEnds = {PlannerStatus::timeout,    PlannerStatus::memory_limit,
                                                      PlannerStatus::crash,      PlannerStatus::invalid,
                                                      PlannerStatus::gave_up,    PlannerStatus::partial,
                                                      PlannerStatus::infeasible, PlannerStatus::unsupported,
                                                      PlannerStatus::aborted,    PlannerStatus::unknown};

constexpr std::array<std::string_view, 3> kCompared = {"time", "path_length", "makespan"};

/// The least cost of any planner on each instance.
class BestCosts
{
public:
    BestCosts(const std::vector<RunGroup> &groups, InstanceNumbers &instances, std::string_view column)
        : instances_(instances), column_(column)
    {
        for (const RunGroup &group : groups)
            for (const Answer &answer : group.answers)
                if (const auto cost = answer.cost(column))
                {
                    const auto [best, isNew] = bests_.try_emplace(instances_.of(answer.first()), *cost);
                    best->second = std::min(best->second, *cost);
                }
    }

    /// Of the group's costs to the least ones, where these are above 0; over the instances that
    /// RunGroup::cost() is over.
    [[nodiscard]] std::optional<Quartiles> ratios(const RunGroup &group) const
    {
        std::vector<double> values;
        for (std::size_t i = 0; i < group.answers.size(); ++i)
        {
            const Answer &answer = group.answers[i];
            const auto best = bests_.find(instances_.of(answer.first()));
            if (group.isCompared[i] == 0 || best == bests_.end() || best->second <= 0)
                continue;
            if (!answer.solved())
                values.push_back(kNoAnswer);
            else if (const auto cost = answer.cost(column_))
                values.push_back(*cost / best->second);
        }
        return censoredQuartiles(std::move(values));
    }

private:
    InstanceNumbers &instances_;
    std::string_view column_;
    std::unordered_map<std::size_t, double> bests_; // by instance
};

/// A cell for a number; empty where there is none.
std::string cell(std::optional<double> value)
{
    return value && std::isfinite(*value) ? formatNumber(*value) : std::string();
}

} // namespace

std::string resultsCsv(const std::vector<RunRecord> &records)
{
    std::set<std::string> extraColumns;
    for (const RunRecord &record : records)
        for (const auto &[name, value] : record.extra)
            extraColumns.insert(name);

    CsvTable table;
    for (const RunColumn &column : runColumns())
        table.cell(column.name);
    for (const std::string &name : extraColumns)
        table.cell(name);
    table.endRow();
    for (const RunRecord &record : records)
    {
        for (const RunColumn &column : runColumns())
            table.cell(toText(column.get(record)));
        for (const std::string &name : extraColumns)
        {
            const auto extra = record.extra.find(name);
            table.cell(extra == record.extra.end() ? std::string() : toText(extra->second));
        }
        table.endRow();
    }
    return table.text();
}

std::string summaryCsv(const std::vector<RunRecord> &records, double timeLimit)
{
    const std::vector<RunGroup> groups = groupRuns(records);
    InstanceNumbers instances(records);
    std::vector<BestCosts> bests;
    for (const std::string_view metric : kCompared)
        bests.emplace_back(groups, instances, metric);
    CsvTable table;
    for (const char *name : {"model", "problem", "sweep_variable", "sweep_value", "planner", "rule", "runs",
                             "instances", "solved", "proved", "does_not_apply", "failed", "solvable",
                             "success_rate", "success_low", "success_high"})
        table.cell(name);
    for (std::string_view metric : kSummarized)
        for (const char *suffix : {"_median", "_q1", "_q3", "_n"})
            table.cell(std::string(metric) + suffix);
    for (PlannerStatus status : kOtherEnds)
        table.cell(toString(status));
    for (const char *name : {"time_par2", "time_par10"})
        table.cell(name);
    for (const std::string_view metric : kCompared)
        table.cell(std::string(metric) + "_to_best");
    table.endRow();

    for (const RunGroup &group : groups)
    {
        table.cell(group.model);
        table.cell(group.problem);
        table.cell(group.sweepVariable);
        table.cell(cell(group.sweepValue));
        table.cell(group.planner);
        table.cell(group.rule);
        table.cell(std::to_string(group.runs.size()));
        table.cell(std::to_string(group.answers.size()));
        for (const Outcome outcome :
             {Outcome::solved, Outcome::proved, Outcome::doesNotApply, Outcome::failed})
            table.cell(std::to_string(group.count(outcome)));
        table.cell(std::to_string(group.counted()));
        const auto rate = group.successRate();
        const Interval interval = wilsonInterval(group.solved(), group.counted());
        table.cell(cell(rate));
        table.cell(rate ? formatNumber(interval.low) : std::string());
        table.cell(rate ? formatNumber(interval.high) : std::string());
        for (std::string_view metric : kSummarized)
        {
            const auto summary = group.cost(metric);
            table.cell(summary ? cell(summary->median) : std::string());
            table.cell(summary ? cell(summary->q1) : std::string());
            table.cell(summary ? cell(summary->q3) : std::string());
            table.cell(std::to_string(group.costs(metric).size()));
        }
        for (PlannerStatus status : kOtherEnds)
            table.cell(std::to_string(group.count(status)));
        for (const double factor : {2, 10})
            table.cell(cell(group.penalizedTime(timeLimit, factor)));
        for (const BestCosts &best : bests)
        {
            const auto ratios = best.ratios(group);
            table.cell(ratios ? cell(ratios->median) : std::string());
        }
        table.endRow();
    }
    return table.text();
}

std::vector<std::filesystem::path> CsvReport::write(const ResultTable &results, const Provenance &,
                                                    const std::filesystem::path &folder) const
{
    writeFile(folder / "results.csv", resultsCsv(results.records()));
    writeFile(folder / "summary.csv", summaryCsv(results.records(), results.plan().limits.time));
    return {folder / "results.csv", folder / "summary.csv"};
}

} // namespace mrpp
