#include "reports/CsvReport.h"

#include "framework/support/Config.h"
#include "framework/support/File.h"
#include "reports/Aggregate.h"
#include "reports/drawing/Csv.h"

#include <array>
#include <set>

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

std::string summaryCsv(const std::vector<RunRecord> &records)
{
    CsvTable table;
    for (const char *name :
         {"model", "problem", "sweep_variable", "sweep_value", "planner", "runs", "solved", "success_rate"})
        table.cell(name);
    for (std::string_view metric : kSummarized)
        for (const char *suffix : {"_median", "_q1", "_q3", "_n"})
            table.cell(std::string(metric) + suffix);
    for (PlannerStatus status : kFailures)
        table.cell(toString(status));
    table.cell("solvable");
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
        table.endRow();
    }
    return table.text();
}

std::vector<std::filesystem::path> CsvReport::write(const ResultTable &results, const Provenance &,
                                                    const std::filesystem::path &folder) const
{
    writeFile(folder / "results.csv", resultsCsv(results.records()));
    writeFile(folder / "summary.csv", summaryCsv(results.records()));
    return {folder / "results.csv", folder / "summary.csv"};
}

} // namespace mrpp
