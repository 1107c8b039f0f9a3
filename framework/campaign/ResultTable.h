#pragma once
/// \file
/// What reports read: the plan, the records in the plan's order, and on request the instances and solutions.

#include "framework/campaign/BenchmarkPlan.h"
#include "framework/campaign/ProgressSampler.h"
#include "framework/campaign/RunRecord.h"
#include "framework/model/Instance.h"
#include "framework/model/Solution.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

class ResultTable
{
public:
    using SolutionLoader = std::function<std::optional<Solution>(const std::string &runKey)>;
    using ProgressLoader = std::function<Progress(const std::string &runKey)>;

    /// \param records finished runs, in any order; those that are not in the plan are left out
    ResultTable(BenchmarkPlan plan, std::vector<RunRecord> records, SolutionLoader loadSolution,
                ProgressLoader loadProgress = {});

    [[nodiscard]] const BenchmarkPlan &plan() const { return plan_; }

    /// Finished runs, in the plan's order.
    [[nodiscard]] const std::vector<RunRecord> &records() const { return records_; }

    /// How many runs the plan has; more than records().size() while the campaign is unfinished.
    [[nodiscard]] std::size_t plannedRuns() const { return specs_.size(); }

    /// Rebuilds a record's instance from its problem and seeds. Nothing where an input file is gone.
    [[nodiscard]] std::optional<Instance> instance(const RunRecord &record) const;

    /// The solution (before optimizing), where the store kept it.
    [[nodiscard]] std::optional<Solution> solution(const RunRecord &record) const;

    /// What the run's progress properties were over time; empty where none was watched.
    [[nodiscard]] Progress progress(const RunRecord &record) const;

private:
    BenchmarkPlan plan_;
    std::vector<RunSpec> specs_;
    std::vector<RunRecord> records_;
    SolutionLoader loadSolution_;
    ProgressLoader loadProgress_;
};

} // namespace mrpp
