#pragma once
/// \file
/// From moves to steps: the schedule of least makespan in which the robots visit each vertex in the same
/// order as in the solution.
///
/// Every move starts as early as its robot's own moves and the earlier visits of its target allow: the
/// longest path in the graph of these precedences (the same idea as W. Hönig et al., "Multi-agent path
/// finding with kinematic constraints", ICAPS 2016, calls a temporal plan graph). O(moves + robots + V).

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"

#include <cstdint>
#include <vector>

namespace mrpp
{

/// The step (0, 1, …) in which each move happens. Under `pebble` one action a step; under `parallel` a vertex
/// is entered in the step after it was left at the earliest; under `following` and `rotation` in the same
/// step. A rotation of the solution stays one (its robots move in one step), whatever the rule. \pre the
/// solution is legal for the instance
[[nodiscard]] std::vector<std::uint32_t> moveSteps(const Instance &instance, const Solution &solution,
                                                   MotionRule rule);

/// The condensed schedule itself; the moves of a step are ordered by robot, which costs a factor of the
/// logarithm of their number. At most 36 bytes a move, solution and schedule included.
[[nodiscard]] Schedule condense(const Instance &instance, const Solution &solution, MotionRule rule);

} // namespace mrpp
