#include "framework/campaign/ResultTable.h"

#include "framework/support/Error.h"

#include <algorithm>
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
    std::unordered_map<std::string, std::size_t> byPlanKey; // answers of a program with other defaults
    std::map<decltype(questionOf(RunRecord())), std::size_t> byQuestion;
    const bool knowsKeys =
        std::ranges::none_of(specs_, [](const RunSpec &spec) { return spec.runKey.empty(); });
    byKey.reserve(records.size());
    byPlanKey.reserve(records.size());
    for (std::size_t i = 0; i < records.size(); ++i)
    {
        byKey[records[i].runKey] = i;
        byPlanKey[records[i].planKey] = i;
        if (!knowsKeys)
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
        auto found = spec.runKey.empty() ? find(byQuestion, questionOf(wanted)) : find(byKey, spec.runKey);
        if (!found && !spec.planKey.empty())
            found = find(byPlanKey, spec.planKey);
        if (!found)
            continue;
        records_.push_back(records[*found]);
        RunRecord &record = records_.back();
        // A run keeps its key when its problem or planner is renamed: the plan's names win.
        const std::string key = record.runKey;
        const std::string planKey = record.planKey;
        fillIdentity(record, plan_, spec);
        record.runKey = key; // the plan's is unknown where input files are gone
        record.planKey = planKey;
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
