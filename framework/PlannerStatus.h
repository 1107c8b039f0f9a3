#pragma once
/// \file
/// One value for each way a run can end.

#include <optional>
#include <string_view>

namespace mrpp
{

/// Numbered as OMPL's PlannerStatus where it has the same, so that its tools read our databases.
enum class PlannerStatus
{
    unknown = 0,    ///< not run
    timeout = 4,    ///< the time limit came first
    partial = 5,    ///< ended with some robots at their goals; the moves so far are legal (OMPL: approximate)
    solved = 6,     ///< every robot is at its goal
    crash = 7,      ///< the planner threw, or its process died
    aborted = 8,    ///< stopped by the user
    infeasible = 9, ///< proved: no solution exists under the planner's motion rule
    gave_up = 11,   ///< ended without a solution and without a proof that there is none
    unsupported = 12,  ///< the planner does not take such an instance; the reason says why
    memory_limit = 13, ///< the memory limit came first
    invalid = 14,      ///< the planner claimed a solution that the validator refused, or called a solvable
                       ///< instance infeasible: a defect of the planner
};

/// The name used in every file: `solved`, `gave_up`, ….
[[nodiscard]] std::string_view toString(PlannerStatus status);
[[nodiscard]] std::optional<PlannerStatus> plannerStatus(std::string_view name);

} // namespace mrpp
