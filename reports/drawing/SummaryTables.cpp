#include "reports/drawing/SummaryTables.h"

#include "framework/support/Config.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <tuple>

namespace mrpp
{

namespace
{

using Emphasis = PdfTableCell::Emphasis;

/// A measure's column of a summary table.
struct Measure
{
    const char *title;
    std::optional<Quartiles> (*summarize)(const RunGroup &);
    std::string (*format)(double);
    double share;
};

std::string wholeNumber(double value)
{
    return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.1f}", value);
}
std::string threeDigits(double value)
{
    return fmt::format("{:.3g}", value);
}
std::string twoDecimals(double value)
{
    return fmt::format("{:.2f}", value);
}

constexpr std::array<Measure, 6> kMeasures = {{
    {"Path length", [](const RunGroup &g) { return g.overSolved("path_length"); }, wholeNumber, 1.15},
    {"Path length, optimized", [](const RunGroup &g) { return g.overSolved("optimized_path_length"); },
     wholeNumber, 1.25},
    {"Path length / bound",
     [](const RunGroup &g) { return g.ratio("path_length", "path_length_lower_bound"); }, twoDecimals, 1.15},
    {"Makespan", [](const RunGroup &g) { return g.overSolved("makespan"); }, wholeNumber, 1.25},
    {"Makespan, optimized", [](const RunGroup &g) { return g.overSolved("optimized_makespan"); }, wholeNumber,
     1.3},
    {"Time (s)", [](const RunGroup &g) { return g.overSolved("time"); }, threeDigits, 1.15},
}};

std::string solvedOf(const RunGroup &group)
{
    return fmt::format("{}/{}", group.solved(), group.runs.size());
}

/// The rows of one sweep point or problem. \param place first cell of each row
void addRows(SummaryTable &table, const std::string &place, std::span<const RunGroup> groups)
{
    std::size_t mostSolved = 0;
    for (const RunGroup &group : groups)
        mostSolved = std::max(mostSolved, group.solved());
    std::vector<std::array<std::optional<Quartiles>, kMeasures.size()>> values;
    std::array<double, kMeasures.size()> best{};
    best.fill(std::numeric_limits<double>::infinity());
    for (const RunGroup &group : groups)
    {
        values.emplace_back();
        for (std::size_t m = 0; m < kMeasures.size(); ++m)
        {
            values.back()[m] = kMeasures[m].summarize(group);
            if (values.back()[m] && group.solved() == mostSolved)
                best[m] = std::min(best[m], values.back()[m]->median);
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
        const bool failed = groups[i].solved() == 0;
        std::vector<PdfTableCell> row = {
            {place}, {groups[i].planner}, {solvedOf(groups[i]), failed ? Emphasis::warning : Emphasis::none}};
        for (std::size_t m = 0; m < kMeasures.size(); ++m)
        {
            if (!values[i][m])
            {
                row.push_back({"–"});
                continue;
            }
            const double median = values[i][m]->median;
            const bool isBest = groups.size() > 1 && groups[i].solved() == mostSolved && median == best[m];
            row.push_back({kMeasures[m].format(median), isBest ? Emphasis::best : Emphasis::none});
        }
        table.rows.push_back(std::move(row));
    }
}

SummaryTable emptyTable(std::string title, std::string place, double placeShare)
{
    SummaryTable table;
    table.title = std::move(title);
    table.columns = {{std::move(place), placeShare}, {"Planner", 2.6}, {"Solved / runs", 1.0, true}};
    for (const Measure &measure : kMeasures)
        table.columns.push_back({measure.title, measure.share, true});
    return table;
}

} // namespace

std::vector<SummaryTable> summaryTables(std::span<const RunRecord> records)
{
    std::vector<SummaryTable> tables;
    std::map<std::string, std::size_t> unswept; // by family
    for (const ProblemSummary &problem : summarizeProblems(records))
    {
        const std::span<const RunGroup> groups(problem.groups);
        if (!problem.swept())
        {
            const auto [position, isNew] = unswept.try_emplace(problem.model, tables.size());
            if (isNew)
                tables.push_back(emptyTable(spaced(problem.model), "Problem", 2.55));
            addRows(tables[position->second], problem.problem, groups);
            continue;
        }
        tables.push_back(emptyTable(fmt::format("{} ({}) against {}", problem.problem, spaced(problem.model),
                                                spaced(problem.sweepVariable)),
                                    spaced(problem.sweepVariable), 1.2));
        for (std::size_t first = 0, last = 0; first < groups.size(); first = last)
        {
            while (last < groups.size() && groups[last].sweepValue == groups[first].sweepValue)
                ++last;
            addRows(tables.back(), formatNumber(groups[first].sweepValue.value_or(0)),
                    groups.subspan(first, last - first));
        }
    }
    return tables;
}

SummaryTable plannerTable(std::span<const RunRecord> records)
{
    std::vector<std::string> planners;
    std::map<std::string, std::map<PlannerStatus, std::size_t>> statuses;
    for (const RunRecord &record : records)
    {
        if (!statuses.contains(record.planner))
            planners.push_back(record.planner);
        ++statuses[record.planner][record.status];
    }
    SummaryTable table;
    table.title = "Planners";
    table.columns = {{"Planner", 2.5},
                     {"Runs", 0.6, true},
                     {"Solved", 0.6, true},
                     {"Solved (%)", 0.8, true},
                     {"Other ends", 3}};
    for (const std::string &planner : planners)
    {
        std::size_t runs = 0;
        std::string others;
        for (const auto &[status, count] : statuses[planner])
        {
            runs += count;
            if (status != PlannerStatus::solved)
                others += fmt::format("{}{} {}", others.empty() ? "" : ", ", count, spaced(toString(status)));
        }
        const std::size_t solved = statuses[planner][PlannerStatus::solved];
        const bool isInvalid = statuses[planner].contains(PlannerStatus::invalid);
        table.rows.push_back(
            {{planner},
             {std::to_string(runs)},
             {std::to_string(solved)},
             {fmt::format("{:.1f}", 100 * static_cast<double>(solved) / static_cast<double>(runs))},
             {others, isInvalid ? Emphasis::warning : Emphasis::none}});
    }
    return table;
}

SummaryTable failureTable(std::span<const RunRecord> records, std::size_t limit)
{
    struct Failure
    {
        const RunRecord *first = nullptr;
        std::size_t count = 0;
    };
    std::map<std::tuple<std::string, PlannerStatus, std::string>, std::size_t> positions;
    std::vector<Failure> failures;
    for (const RunRecord &record : records)
    {
        if (record.solved())
            continue;
        const auto [position, isNew] =
            positions.try_emplace({record.planner, record.status, record.reason}, failures.size());
        if (isNew)
            failures.push_back({&record, 0});
        ++failures[position->second].count;
    }
    std::stable_sort(failures.begin(), failures.end(),
                     [](const Failure &a, const Failure &b) {
                         return std::tie(a.first->planner, a.first->status) <
                                std::tie(b.first->planner, b.first->status);
                     });

    SummaryTable table;
    table.title = "Runs without a solution";
    table.columns = {
        {"Planner", 2}, {"Status", 1.1}, {"Runs", 0.6, true}, {"Reason", 4}, {"First case", 2.3}};
    for (const Failure &failure : failures)
    {
        if (table.rows.size() == limit)
        {
            table.rows.push_back({{"…"},
                                  {""},
                                  {""},
                                  {counted(failures.size() - limit, "kind") + " more, see results.csv"},
                                  {""}});
            break;
        }
        const bool isInvalid = failure.first->status == PlannerStatus::invalid;
        table.rows.push_back(
            {{failure.first->planner},
             {spaced(toString(failure.first->status)), isInvalid ? Emphasis::warning : Emphasis::none},
             {std::to_string(failure.count)},
             {failure.first->reason},
             {failure.first->caseId}});
    }
    return table;
}

} // namespace mrpp
