#pragma once
/// \file
/// A planner that may try again with other orders and tie-breaks and keeps its best answer. Rule-based
/// planners make hundreds of choices that do not matter for success and matter much for length; on small
/// problems a thousand attempts cost less than a second.
///
/// Subclasses implement attempt() instead of solve().

#include "framework/Planner.h"

#include <cstdint>

namespace mrpp
{

class RestartingPlanner : public Planner
{
public:
    /// How one attempt ended; a solution only where the status is `solved` or `partial`.
    struct Outcome
    {
        PlannerStatus status;
        std::string reason;
        Solution solution;
    };

    explicit RestartingPlanner(PlannerSpecs specs);

    /// Makes `restarts` attempts, on `threads` threads, and keeps the solution that is shortest after
    /// redundancy removal, the earliest of equals: the number of threads does not change it. What the
    /// solution is without redundancy removal is what it hands over. Where no attempt solves the instance,
    /// the one that brings most robots to their goals. Where time runs out, the best so far.
    PlannerStatus solve(const TerminationCondition &ptc) final;

    [[nodiscard]] bool usesChance() const override { return restarts_ > 1; }

protected:
    /// Attempt 0 makes the planner's own best choices, the others random ones, all derived from
    /// attemptSeed(number). Called from several threads at once, after setup().
    [[nodiscard]] virtual Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const = 0;

    [[nodiscard]] Seed attemptSeed(std::uint64_t number) const
    {
        return deriveSeed(seed(), "attempt", number);
    }

private:
    std::int64_t restarts_ = 1;
    std::int64_t threads_ = 0;
};

} // namespace mrpp
