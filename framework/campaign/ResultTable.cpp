#include "framework/campaign/ResultTable.h"

#include "framework/support/Error.h"

#include <map>
#include <tuple>
#include <unordered_map>

namespace mrpp
{

namespace
{

/// Where input files are gone there are no keys; then the case, its seeds and the planner's name tell runs
/// apart.
auto questionOf(const RunRecord &record)
{
    return std::tuple(record.caseId, record.planner, record.graphSeed, record.instanceSeed,
                      record.plannerSeed);
}

/// The plan's names win over those under which the run was made: a run keeps its key when its problem or
/// planner is renamed.
void takeNames(RunRecord &record, const RunRecord &blank)
{
    record.caseId = blank.caseId;
    record.model = blank.model;
    record.problem = blank.problem;
    record.sweepVariable = blank.sweepVariable;
    record.sweepValue = blank.sweepValue;
    record.repetition = blank.repetition;
    record.planner = blank.planner;
}

} // namespace

ResultTable::ResultTable(BenchmarkPlan plan, std::vector<RunRecord> records, SolutionLoader loadSolution)
    : plan_(std::move(plan)), specs_(expand(plan_, MissingInput::tolerate)),
      loadSolution_(std::move(loadSolution))
{
    std::unordered_map<std::string, std::size_t> byKey;
    std::map<decltype(questionOf(RunRecord())), std::size_t> byQuestion;
    for (std::size_t i = 0; i < records.size(); ++i)
    {
        byKey[records[i].runKey] = i;
        byQuestion[questionOf(records[i])] = i;
    }
    const auto find = [](const auto &index, const auto &key) -> std::optional<std::size_t>
    {
        const auto found = index.find(key);
        return found == index.end() ? std::nullopt : std::optional(found->second);
    };
    for (const RunSpec &spec : specs_)
    {
        const RunRecord blank = blankRecord(plan_, spec);
        const auto found =
            spec.runKey.empty() ? find(byQuestion, questionOf(blank)) : find(byKey, spec.runKey);
        if (!found)
            continue;
        records_.push_back(records[*found]);
        takeNames(records_.back(), blank);
    }
}

std::optional<Instance> ResultTable::instance(const RunRecord &record) const
{
    for (const RunSpec &spec : specs_)
    {
        if (spec.caseId != record.caseId)
            continue;
        const Problem &problem = *plan_.points[spec.point].problem;
        try
        {
            auto graph = problem.makeGraph(spec.graphSeed);
            const std::size_t robots = problem.robotCount(*graph);
            return problem.makeInstance(std::move(graph), robots, spec.instanceSeed);
        }
        catch (const InputError &)
        {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

std::optional<Solution> ResultTable::solution(const RunRecord &record) const
{
    return loadSolution_ ? loadSolution_(record.runKey) : std::nullopt;
}

} // namespace mrpp
