#include "reports/summary/CaseTable.h"

#include "reports/summary/Aggregate.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace mrpp
{

namespace
{

/// Those that all of the planners answered.
std::vector<const Case *> answeredByAll(const CaseTable &table, const std::vector<std::vector<char>> &has,
                                        const std::vector<std::size_t> &planners)
{
    std::vector<const Case *> cases;
    for (std::size_t i = 0; i < table.cases.size(); ++i)
        if (std::all_of(planners.begin(), planners.end(), [&](std::size_t p) { return has[p][i] != 0; }))
            cases.push_back(&table.cases[i]);
    return cases;
}

} // namespace

const RunRecord &Case::any() const
{
    return std::find_if(answers.begin(), answers.end(), [](const Answer &one) { return one.isFinished(); })
        ->first();
}

bool Case::isFinished() const
{
    return std::all_of(answers.begin(), answers.end(), [](const Answer &one) { return one.isFinished(); });
}

bool Case::isHopeless() const
{
    return std::all_of(answers.begin(), answers.end(),
                       [](const Answer &one) { return !one.isFinished() || one.unsolvable(); });
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
            points.push_back({planners, rules, {}});
        points[position->second].cases.push_back(one);
    }
    return points;
}

CaseTable CaseTable::finished() const
{
    CaseTable table = *this;
    std::erase_if(table.cases, [](const Case &one) { return !one.isFinished(); });
    return table;
}

CaseTable CaseTable::solvable() const
{
    CaseTable table = *this;
    std::erase_if(table.cases, [](const Case &one) { return one.isHopeless(); });
    return table;
}

std::string CaseTable::name(std::size_t planner) const
{
    return withRule(planners[planner], rules[planner]);
}

CaseTable caseTable(const ResultTable &results)
{
    CaseTable table;
    std::unordered_map<std::string, std::size_t> columns;
    for (const Configured &planner : results.plan().planners)
    {
        columns.emplace(planner.name, table.planners.size());
        table.planners.push_back(planner.name);
        table.rules.emplace_back(toString(planner.motion));
    }
    InstanceNumbers instances(results.records());
    std::unordered_map<std::size_t, std::size_t> rows; // by instance
    for (const RunRecord &run : results.records())
    {
        const auto [row, isNew] = rows.try_emplace(instances.of(run), table.cases.size());
        if (isNew)
            table.cases.push_back({std::vector<Answer>(table.planners.size())});
        table.cases[row->second].answers[columns.at(run.planner)].add(run);
    }
    return table;
}

CommonCases commonCases(const CaseTable &table, std::string_view column, std::string_view bound)
{
    std::vector<std::vector<char>> has(table.planners.size()); // of each planner: the cases that it answered
    std::vector<std::size_t> solved(table.planners.size());
    for (std::size_t p = 0; p < table.planners.size(); ++p)
        for (const Case &one : table.cases)
        {
            const auto least = bound.empty() ? 1 : one.answers[p].cost(bound).value_or(0);
            has[p].push_back(least > 0 && one.answers[p].cost(column) ? 1 : 0);
            solved[p] += static_cast<std::size_t>(has[p].back());
        }
    CommonCases common;
    const std::size_t most = solved.empty() ? 0 : *std::max_element(solved.begin(), solved.end());
    for (std::size_t p = 0; p < table.planners.size(); ++p)
        (solved[p] > 0 && 2 * solved[p] >= most ? common.planners : common.leftOut).push_back(p);
    common.cases = answeredByAll(table, has, common.planners);
    while (common.planners.size() > 1 && common.cases.size() < kLeastInCommon)
    {
        std::size_t worst = 0;
        std::vector<const Case *> best;
        for (std::size_t i = 0; i < common.planners.size(); ++i)
        {
            std::vector<std::size_t> others = common.planners;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            std::vector<const Case *> cases = answeredByAll(table, has, others);
            if (cases.size() < best.size() || (cases.size() == best.size() && i > 0 &&
                                               solved[common.planners[i]] > solved[common.planners[worst]]))
                continue;
            worst = i;
            best = std::move(cases);
        }
        common.leftOut.push_back(common.planners[worst]);
        common.planners.erase(common.planners.begin() + static_cast<std::ptrdiff_t>(worst));
        common.cases = std::move(best);
    }
    if (common.planners.size() == 1 && table.planners.size() > 1) // nobody to be compared with
    {
        common.leftOut.push_back(common.planners.front());
        common.planners.clear();
    }
    if (common.planners.empty())
        common.cases.clear();
    std::sort(common.leftOut.begin(), common.leftOut.end());
    return common;
}

} // namespace mrpp
