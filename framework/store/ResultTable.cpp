#include "framework/store/ResultTable.h"

#include "framework/plan/RunKeyMap.h"
#include "framework/run/RunIdentity.h"
#include "framework/support/Error.h"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace mrpp
{

namespace
{

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

/// Where input files are gone there are no keys; then the case, its seeds and the planner's name tell runs
/// apart.
auto questionOf(const RunRecord &record)
{
    return std::tuple(record.caseId, record.planner, record.graphSeed, record.instanceSeed,
                      record.plannerSeed);
}

/// Finds the record that answers a run of the plan. Most campaigns need no more than the first index.
class Answers
{
public:
    Answers(const BenchmarkPlan &plan, const std::vector<RunRecord> &records)
        : plan_(plan), records_(records), byKey_(indexBy(&RunRecord::runKey))
    {}

    /// The record's position, or kNowhere.
    std::size_t find(const RunSpec &spec)
    {
        if (spec.runKey.empty())
        {
            const std::size_t found = findQuestion(spec);
            if (found != kNowhere || spec.planKey.empty())
                return found;
        }
        else if (const std::size_t *found = byKey_.find(spec.runKey))
        {
            return *found;
        }
        if (!byPlanKey_)
            byPlanKey_ = indexBy(&RunRecord::planKey);
        const std::size_t *found = byPlanKey_->find(spec.planKey);
        return found == nullptr ? kNowhere : *found;
    }

private:
    using Index = RunKeyMap<std::size_t>;

    const BenchmarkPlan &plan_;
    const std::vector<RunRecord> &records_;
    Index byKey_;
    std::optional<Index> byPlanKey_; // answers of a program with other defaults
    std::map<decltype(questionOf(RunRecord())), std::size_t> byQuestion_;

    [[nodiscard]] Index indexBy(std::string RunRecord::*key) const
    {
        Index index;
        index.reserve(records_.size());
        for (std::size_t i = 0; i < records_.size(); ++i)
            index.set(records_[i].*key, i);
        return index;
    }

    std::size_t findQuestion(const RunSpec &spec)
    {
        if (byQuestion_.empty())
            for (std::size_t i = 0; i < records_.size(); ++i)
                byQuestion_[questionOf(records_[i])] = i;
        RunRecord wanted;
        fillIdentity(wanted, plan_, spec);
        const auto found = byQuestion_.find(questionOf(wanted));
        return found == byQuestion_.end() ? kNowhere : found->second;
    }
};

/// Keeps the records at these positions, each of which occurs once, in this order. In place: there may be
/// millions.
void arrange(std::vector<RunRecord> &records, std::vector<std::size_t> positions)
{
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        std::size_t &from = positions[i];
        while (from < i) // another record was exchanged with that one
            from = positions[from];
        if (from != i)
            std::swap(records[i], records[from]);
    }
    records.erase(records.begin() + static_cast<std::ptrdiff_t>(positions.size()), records.end());
}

} // namespace

ResultTable::ResultTable(BenchmarkPlan plan, std::vector<RunRecord> records, SolutionLoader loadSolution,
                         ProgressLoader loadProgress, SolutionOptimizer optimize)
    : plan_(std::move(plan)), records_(std::move(records)), loadSolution_(std::move(loadSolution)),
      loadProgress_(std::move(loadProgress)), optimize_(std::move(optimize))
{
    std::vector<RunSpec> specs = expand(plan_, MissingInput::tolerate);
    plannedRuns_ = specs.size();
    for (const RunSpec &spec : specs)
        if (spec.planner == 0)
            points_.emplace(spec.caseId, spec.point);

    std::vector<std::size_t> positions;
    positions.reserve(specs.size());
    Answers answers(plan_, records_);
    std::erase_if(specs,
                  [&](const RunSpec &spec)
                  {
                      const std::size_t found = answers.find(spec);
                      if (found != kNowhere)
                          positions.push_back(found);
                      return found == kNowhere;
                  });
    std::vector<bool> isTaken(records_.size());
    for (std::size_t &position : positions)
    {
        if (isTaken[position]) // an old answer to two questions that differ by a default only
        {
            records_.push_back(records_[position]);
            position = records_.size() - 1;
        }
        else
        {
            isTaken[position] = true;
        }
    }
    arrange(records_, std::move(positions));
    for (std::size_t i = 0; i < specs.size(); ++i)
    {
        // A run keeps its key when its problem or planner is renamed: the plan's names win.
        RunRecord &record = records_[i];
        std::string key = std::move(record.runKey);
        std::string planKey = std::move(record.planKey);
        fillIdentity(record, plan_, specs[i]);
        record.runKey = std::move(key); // the plan's is unknown where input files are gone
        record.planKey = std::move(planKey);
    }
}

std::optional<Instance> ResultTable::instance(const RunRecord &record) const
{
    const auto point = points_.find(record.caseId);
    if (point == points_.end())
        return std::nullopt;
    const Problem &problem = *plan_.points[point->second].problem;
    try
    {
        return makeInstance(problem, problem.makeGraph(record.graphSeed), record.instanceSeed);
    }
    catch (const InputError &)
    {
        return std::nullopt;
    }
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
