#pragma once
/// \file
/// What reports read: the plan, the records in the plan's order, and on request the instances and solutions.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/ProgressSampler.h"
#include "framework/run/RunRecord.h"

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace mrpp
{

class ResultTable
{
public:
    using SolutionLoader = std::function<std::optional<Solution>(const std::string &runKey)>;
    using ProgressLoader = std::function<Progress(const std::string &runKey)>;
    /// What the plan's optimizers make of a solution.
    using SolutionOptimizer = std::function<Solution(const Instance &instance, Solution solution)>;

    /// \param records finished runs, in any order; those that are not in the plan are left out
    ResultTable(BenchmarkPlan plan, std::vector<RunRecord> records, SolutionLoader loadSolution,
                ProgressLoader loadProgress = {}, SolutionOptimizer optimize = {});

    [[nodiscard]] const BenchmarkPlan &plan() const { return plan_; }

    /// Finished runs, in the plan's order.
    [[nodiscard]] const std::vector<RunRecord> &records() const { return records_; }

    /// How many runs the plan has; more than records().size() while the campaign is unfinished.
    [[nodiscard]] std::size_t plannedRuns() const { return plannedRuns_; }

    /// Rebuilds a record's instance from its problem and seeds. Nothing where an input file is gone.
    [[nodiscard]] std::optional<Instance> instance(const RunRecord &record) const;

    /// The solution (before optimizing), where the store kept it.
    [[nodiscard]] std::optional<Solution> solution(const RunRecord &record) const;

    /// What the run's progress properties were over time; empty where none was watched.
    [[nodiscard]] Progress progress(const RunRecord &record) const;

    /// A kept solution after the plan's optimizers, which are run again; nothing where there are none, or
    /// where what comes out now is not as long as what was recorded.
    [[nodiscard]] std::optional<Solution> optimizedSolution(const RunRecord &record, const Instance &instance,
                                                            const Solution &solution) const;

private:
    BenchmarkPlan plan_;
    std::size_t plannedRuns_ = 0;
    std::unordered_map<std::string, std::size_t> points_; // of each case
    std::vector<RunRecord> records_;
    SolutionLoader loadSolution_;
    ProgressLoader loadProgress_;
    SolutionOptimizer optimize_;
};

} // namespace mrpp
