#include "reports/CaseTable.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace mrpp
{

const RunRecord &Case::any() const
{
    return **std::find_if(runs.begin(), runs.end(), [](const RunRecord *run) { return run != nullptr; });
}

bool Case::isFinished() const
{
    return std::find(runs.begin(), runs.end(), nullptr) == runs.end();
}

std::vector<CaseTable> CaseTable::byPoint() const
{
    std::map<std::tuple<std::string, std::string, std::string, std::optional<double>>, std::size_t> positions;
    std::vector<CaseTable> points;
    for (const Case &one : cases)
    {
        const RunRecord &run = one.any();
        const auto [position, isNew] =
            positions.try_emplace({run.model, run.problem, run.sweepVariable, run.sweepValue}, points.size());
        if (isNew)
            points.push_back({planners, {}});
        points[position->second].cases.push_back(one);
    }
    return points;
}

CaseTable CaseTable::finished() const
{
    CaseTable table{planners, cases};
    std::erase_if(table.cases, [](const Case &one) { return !one.isFinished(); });
    return table;
}

CaseTable caseTable(const ResultTable &results)
{
    CaseTable table;
    std::unordered_map<std::string, std::size_t> columns;
    for (const Configured &planner : results.plan().planners)
    {
        columns.emplace(planner.name, table.planners.size());
        table.planners.push_back(planner.name);
    }
    std::unordered_map<std::string, std::size_t> rows;
    for (const RunRecord &run : results.records())
    {
        const auto [row, isNew] = rows.try_emplace(run.caseId, table.cases.size());
        if (isNew)
            table.cases.push_back({std::vector<const RunRecord *>(table.planners.size())});
        table.cases[row->second].runs[columns.at(run.planner)] = &run;
    }
    return table;
}

std::optional<double> costOf(const RunRecord *run, std::string_view column)
{
    return run != nullptr && run->solved() ? numericValue(*run, column) : std::nullopt;
}

} // namespace mrpp
