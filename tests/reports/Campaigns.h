#pragma once
/// \file
/// Hand-made campaigns for the tests of reports: any planners, problems and outcomes, with no planner run.

#include "framework/model/Instance.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultTable.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mrpp::testing
{

class FakeCampaign
{
public:
    /// Sets a record's outcome; identity and the instance's numbers are filled in already.
    using Outcome = std::function<void(RunRecord &record, std::size_t planner)>;

    explicit FakeCampaign(std::string name, std::int64_t repetitions = 1);

    FakeCampaign &planner(const std::string &name, MotionRule rule = MotionRule::pebble);
    FakeCampaign &planners(std::size_t count);
    FakeCampaign &problem(const std::string &model, const std::string &name, const Instance &instance);
    /// One point for each value, all with the same instance unless `makeInstance` says otherwise.
    FakeCampaign &sweep(const std::string &model, const std::string &name, const std::string &variable,
                        const std::vector<double> &values,
                        const std::function<Instance(double value)> &makeInstance);
    FakeCampaign &solution(const std::string &problem, Solution solution);

    [[nodiscard]] BenchmarkPlan &plan() { return plan_; }
    [[nodiscard]] ResultTable run(const Outcome &outcome) const;

private:
    BenchmarkPlan plan_;
    std::map<std::string, Solution> solutions_; ///< by problem
};

/// Costs that grow with the sweep value and differ between planners; no two calls differ.
void solveSmoothly(RunRecord &record, std::size_t planner);

/// side × side vertices, 4-connected, coordinates one apart, `robots` robots from the first vertices to the
/// last ones.
[[nodiscard]] Instance gridInstance(std::size_t side, std::size_t robots, bool withCoordinates = true);

/// The published problem "tree": 7 vertices, 6 edges, 3 robots.
[[nodiscard]] Instance treeInstance();

[[nodiscard]] Provenance fakeProvenance();

} // namespace mrpp::testing
