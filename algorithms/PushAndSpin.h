#pragma once
/// \file
/// Push and Spin.
///
/// Robots go home one after another, by pushes and swaps, as in Push and Rotate, but several robots on a
/// cycle may turn at once. That makes swaps possible with a single free vertex (*spins*, see
/// pebble/SpinOperations.h), and turns a full cycle where a push would have to go far.
///
/// Use it for: any instance with at least one free vertex in each component in which somebody must move. It
/// solves it, or proves that it cannot be solved.
///
/// \code
/// PushAndSpin planner;
/// planner.parameters().set("restarts", "1000"); // small problems: shorter solutions
/// planner.setInstance(instance);
/// planner.setup();
/// const PlannerStatus status = planner.solve(TerminationCondition::after(10));
/// \endcode
///
/// Complexity: setup O(V + E); then one path search a robot plus what pushes and swaps touch. A swap at a
/// cycle of L vertices takes about 2L moves beside the way there and back. Memory O(V + E + moves).
///
/// Source: E. T. S. Alotaibi, H. Al-Rawi, "Push and spin: a complete multi-robot path planning algorithm",
/// ICARCV 2016; "A complete multi-robot path-planning algorithm", Autonomous Agents and Multi-Agent Systems
/// 32 (2018) 693–740. docs/push_and_spin.md says what differs.

#include "algorithms/TrailPlanner.h"

namespace mrpp
{

class PushAndSpin final : public TrailPlanner
{
public:
    PushAndSpin();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;

private:
    [[nodiscard]] Outcome start(const Run &run) const override;
};

} // namespace mrpp
