#include "reports/CsvReport.h"

#include "framework/support/Config.h"
#include "framework/support/File.h"
#include "reports/Aggregate.h"
#include "reports/CaseTable.h"
#include "reports/drawing/Csv.h"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>

namespace mrpp
{

namespace
{

constexpr std::array<std::string_view, 8> kSummarized = {
    "time",         "path_length", "optimized_path_length", "makespan", "optimized_makespan", "actions",
    "sum_of_costs", "memory"};

constexpr std::array<PlannerStatus, 10> kFailures = {PlannerStatus::timeout,    PlannerStatus::memory_limit,
                                                     PlannerStatus::crash,      PlannerStatus::invalid,
                                                     PlannerStatus::gave_up,    PlannerStatus::partial,
                                                     PlannerStatus::infeasible, PlannerStatus::unsupported,
                                                     PlannerStatus::aborted,    PlannerStatus::unknown};

constexpr std::array<std::string_view, 3> kCompared = {"time", "path_length", "makespan"};

/// The least cost of any planner on each case.
class BestCosts
{
public:
    BestCosts(const std::vector<RunRecord> &records, std::string_view column) : column_(column)
    {
        for (const RunRecord &run : records)
            if (const auto cost = costOf(&run, column))
            {
                const auto [best, isNew] = bests_.try_emplace(run.caseId, *cost);
                best->second = std::min(best->second, *cost);
            }
    }

    /// Of the solved runs' costs to the least ones, where these are above 0.
    [[nodiscard]] std::optional<Quartiles> ratios(const RunGroup &group) const
    {
        std::vector<double> values;
        for (const RunRecord *run : group.runs)
            if (const auto cost = costOf(run, column_))
                if (const double best = bests_.at(run->caseId); best > 0)
                    values.push_back(*cost / best);
        return quartiles(std::move(values));
    }

private:
    std::string_view column_;
    std::unordered_map<std::string_view, double> bests_;
};

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
    std::vector<BestCosts> bests;
    for (const std::string_view metric : kCompared)
        bests.emplace_back(records, metric);
    CsvTable table;
    for (const char *name :
         {"model", "problem", "sweep_variable", "sweep_value", "planner", "runs", "solved", "success_rate"})
        table.cell(name);
    for (std::string_view metric : kSummarized)
        for (const char *suffix : {"_median", "_q1", "_q3", "_n"})
            table.cell(std::string(metric) + suffix);
    for (PlannerStatus status : kFailures)
        table.cell(toString(status));
    for (const char *name : {"solvable", "time_par2", "time_par10"})
        table.cell(name);
    for (const std::string_view metric : kCompared)
        table.cell(std::string(metric) + "_to_best");
    table.endRow();

    for (const RunGroup &group : groupRuns(records))
    {
        table.cell(group.model);
        table.cell(group.problem);
        table.cell(group.sweepVariable);
        table.cell(group.sweepValue ? formatNumber(*group.sweepValue) : std::string());
        table.cell(group.planner);
        table.cell(std::to_string(group.runs.size()));
        table.cell(std::to_string(group.solved()));
        table.cell(formatNumber(group.successRate()));
        for (std::string_view metric : kSummarized)
        {
            const auto summary = group.overSolved(metric);
            table.cell(summary ? formatNumber(summary->median) : std::string());
            table.cell(summary ? formatNumber(summary->q1) : std::string());
            table.cell(summary ? formatNumber(summary->q3) : std::string());
            table.cell(std::to_string(summary ? summary->count : 0));
        }
        for (PlannerStatus status : kFailures)
            table.cell(std::to_string(group.count(status)));
        table.cell(std::to_string(group.solvable()));
        for (const double factor : {2, 10})
            table.cell(formatNumber(group.penalizedTime(timeLimit, factor)));
        for (const BestCosts &best : bests)
        {
            const auto ratios = best.ratios(group);
            table.cell(ratios ? formatNumber(ratios->median) : std::string());
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
