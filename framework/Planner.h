#pragma once
/// \file
/// Subclass Planner to add an algorithm.
///
/// \code
/// class Waiter final : public mrpp::Planner
/// {
/// public:
///     Waiter() : Planner({.citation = "…", .completeFor = "instances whose robots are at their goals"}) {}
///
///     mrpp::PlannerStatus solve(const mrpp::TerminationCondition &) override
///     {
///         return instance().starts == instance().goals ? mrpp::PlannerStatus::solved
///                                                      : because(mrpp::PlannerStatus::gave_up, "robots must
///                                                      move");
///     }
/// };
/// \endcode
///
/// Two duties: call the termination condition at least every 50 ms of work, and tell the truth: every
/// solution is replayed by a validator that shares no code with the planners.

#include "framework/PlannerStatus.h"
#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"
#include "framework/support/Parameters.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// What a planner promises.
struct PlannerSpecs
{
    std::string citation;                   ///< authors, title, venue, year
    MotionRule motion = MotionRule::pebble; ///< the narrowest rule under which its solutions are legal
    std::string completeFor;                ///< the class of instances that it always solves, in words
    int version = 1;                        ///< of the algorithm: raised when its answers change
    bool provesInfeasibility = false;       ///< whether `infeasible` is a proof it can give
    bool complete = false;                  ///< it solves every solvable instance that it does not reject
};

class Planner
{
public:
    explicit Planner(PlannerSpecs specs) : specs_(std::move(specs)) {}
    virtual ~Planner() = default;
    Planner(const Planner &) = delete;
    Planner &operator=(const Planner &) = delete;

    /// Whether chance decides its answers under the settings that it has, so that another seed teaches
    /// something new. Not where chance is a last resort, for what fails without it.
    [[nodiscard]] virtual bool usesChance() const { return true; }

    [[nodiscard]] const PlannerSpecs &specs() const { return specs_; }
    [[nodiscard]] ParameterSet &parameters() { return parameters_; }
    [[nodiscard]] const ParameterSet &parameters() const { return parameters_; }

    /// Gives the planner its question and forgets the last one. \pre instance->defect() is empty
    void setInstance(std::shared_ptr<const Instance> instance);

    /// The seed of all its random choices; the same seed gives the same solution.
    void setSeed(Seed seed) { seed_ = seed; }

    /// Why this planner does not take such an instance; nothing where it does. Called before setup().
    [[nodiscard]] virtual std::optional<std::string> reasonToReject(const Instance &) const
    {
        return std::nullopt;
    }

    /// Preprocessing, before solve(); timed apart from it. What takes long asks setupCondition() as solve()
    /// asks its own, and returns when that says stop; solve() is not called then.
    virtual void setup() {}

    /// Ends setup() early. At first nothing does.
    void setSetupCondition(TerminationCondition ptc) { setupCondition_ = std::move(ptc); }

    /// Looks for a solution until it has one or `ptc` says stop. On `solved` and `partial` solution() holds
    /// it.
    virtual PlannerStatus solve(const TerminationCondition &ptc) = 0;

    /// Forgets solution, reason and everything computed for the instance. Overriding classes call this one.
    virtual void clear();

    [[nodiscard]] const Solution &solution() const { return solution_; }

    /// Gives the solution away; solution() is empty afterwards.
    [[nodiscard]] Solution takeSolution() { return std::exchange(solution_, {}); }

    /// Why the run ended as it did, in a sentence that names robots and vertices; empty when solved.
    [[nodiscard]] const std::string &reason() const { return reason_; }

    /// Named values that grow or shrink while solve() runs, sampled every 50 ms from another thread: read
    /// atomics in them. Kept in the table `progress` of results.sqlite.
    using ProgressProperties = std::vector<std::pair<std::string, std::function<double()>>>;
    [[nodiscard]] const ProgressProperties &progressProperties() const { return progressProperties_; }

protected:
    template <ParameterType T>
    void declareParam(std::string name, T &slot, std::string range, std::string help)
    {
        parameters_.declare(std::move(name), slot, std::move(range), std::move(help));
    }
    void addProgressProperty(std::string name, std::function<double()> value)
    {
        progressProperties_.emplace_back(std::move(name), std::move(value));
    }

    [[nodiscard]] const Instance &instance() const { return *instance_; }
    [[nodiscard]] const Graph &graph() const { return *instance_->graph; }
    [[nodiscard]] Seed seed() const { return seed_; }
    [[nodiscard]] const TerminationCondition &setupCondition() const { return setupCondition_; }

    /// For planners that move one robot at a time, or turn cycles.
    void setSolution(Solution solution) { solution_ = std::move(solution); }
    /// For planners that plan in steps.
    void setSolution(const Schedule &schedule) { solution_ = schedule.toSolution(graph().vertexCount()); }

    /// `return because(PlannerStatus::gave_up, "…")`.
    PlannerStatus because(PlannerStatus status, std::string reason)
    {
        reason_ = std::move(reason);
        return status;
    }

private:
    PlannerSpecs specs_;
    ParameterSet parameters_;
    ProgressProperties progressProperties_;
    std::shared_ptr<const Instance> instance_;
    Seed seed_ = 0;
    TerminationCondition setupCondition_;
    Solution solution_;
    std::string reason_;
};

} // namespace mrpp
