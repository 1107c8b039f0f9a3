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

} // namespace

ResultTable::ResultTable(BenchmarkPlan plan, std::vector<RunRecord> records, SolutionLoader loadSolution,
                         ProgressLoader loadProgress, SolutionOptimizer optimize)
    : plan_(std::move(plan)), specs_(expand(plan_, MissingInput::tolerate)),
      loadSolution_(std::move(loadSolution)), loadProgress_(std::move(loadProgress)),
      optimize_(std::move(optimize))
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
        RunRecord wanted;
        fillIdentity(wanted, plan_, spec);
        const auto found =
            spec.runKey.empty() ? find(byQuestion, questionOf(wanted)) : find(byKey, spec.runKey);
        if (!found)
            continue;
        records_.push_back(records[*found]);
        RunRecord &record = records_.back();
        // A run keeps its key when its problem or planner is renamed: the plan's names win.
        const std::string key = record.runKey;
        fillIdentity(record, plan_, spec);
        record.runKey = key; // the plan's is unknown where input files are gone
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
            return makeInstance(problem, problem.makeGraph(spec.graphSeed), spec.instanceSeed);
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

Progress ResultTable::progress(const RunRecord &record) const
{
    return loadProgress_ ? loadProgress_(record.runKey) : Progress();
}

std::optional<Solution> ResultTable::optimizedSolution(const RunRecord &record, const Instance &instance,
                                                       const Solution &solution) const
{
    if (!optimize_ || plan_.optimizers.empty() || !record.optimizedPathLength)
        return std::nullopt;
    Solution optimized = optimize_(instance, solution);
    const bool isAsRecorded =
        static_cast<std::int64_t>(optimized.pathLength()) == *record.optimizedPathLength;
    return isAsRecorded ? std::optional(std::move(optimized)) : std::nullopt;
}

} // namespace mrpp
