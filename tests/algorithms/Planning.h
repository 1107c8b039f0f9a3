#pragma once
/// \file
/// What the planners' tests have in common: a planner that is made, set, run and asked in one call, and small
/// instances.

#include "framework/Planner.h"
#include "framework/evaluation/Validator.h"
#include "framework/model/Instance.h"
#include "tests/support/CpuClock.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mrpp::test
{

using Edges = std::vector<std::pair<Vertex, Vertex>>;

[[nodiscard]] std::shared_ptr<const Graph> graphOf(std::size_t vertices, const Edges &pairs);

/// One of the family `small_benchmark`.
[[nodiscard]] Instance smallProblem(const std::string &name);

using PlannerSettings = std::vector<std::pair<std::string, std::string>>; ///< parameters' names and values

struct Answer
{
    PlannerStatus status = PlannerStatus::unknown;
    Solution solution;
    std::string reason;
    double cpuSeconds = 0; ///< of solve()
};

/// A new planner's answer. \param seconds wall time at most
template <class AnyPlanner>
[[nodiscard]] Answer plan(const Instance &instance, const PlannerSettings &settings = {}, double seconds = 60)
{
    AnyPlanner planner;
    EXPECT_FALSE(planner.reasonToReject(instance)) << *planner.reasonToReject(instance);
    for (const auto &[name, value] : settings)
        planner.parameters().set(name, value);
    planner.setInstance(std::make_shared<Instance>(instance));
    planner.setup();
    const double begin = cpuSeconds();
    const PlannerStatus status = planner.solve(TerminationCondition::after(seconds));
    const double end = cpuSeconds();
    return {status, planner.takeSolution(), planner.reason(), end - begin};
}

template <class AnyPlanner>
void expectSolved(const Instance &instance, const std::string &what)
{
    const Answer answer = plan<AnyPlanner>(instance);
    ASSERT_EQ(answer.status, PlannerStatus::solved) << what << ": " << answer.reason;
    const Verdict verdict = validate(instance, answer.solution, AnyPlanner().specs().motion);
    ASSERT_TRUE(verdict.valid()) << what << ": " << verdict.violation;
}

/// A planner of those with a trail, for many instances one after another.
template <class TrailPlannerType>
class TrailRun
{
public:
    explicit TrailRun(const char *restarts = "1", const char *threads = "0")
    {
        planner_.parameters().set("restarts", restarts);
        planner_.parameters().set("threads", threads);
    }

    PlannerStatus operator()(const Instance &instance, Seed seed = 1)
    {
        planner_.setInstance(std::make_shared<Instance>(instance));
        planner_.setSeed(seed);
        planner_.setup();
        return planner_.solve({});
    }

    void expectSolved(const Instance &instance, Seed seed = 1)
    {
        ASSERT_EQ((*this)(instance, seed), PlannerStatus::solved) << reason();
        const Verdict verdict = validate(instance, solution(), planner_.specs().motion);
        ASSERT_TRUE(verdict.valid()) << verdict.violation;
    }

    [[nodiscard]] const Solution &solution() const { return planner_.solution(); }
    [[nodiscard]] const std::string &reason() const { return planner_.reason(); }
    /// How often the main loop failed and the certain way was taken.
    [[nodiscard]] double fallbacks() const { return planner_.progressProperties().front().second(); }

private:
    TrailPlannerType planner_;
};

} // namespace mrpp::test
