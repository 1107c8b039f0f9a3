#pragma once
/// \file
/// A solution as a strip of frames: where the robots stand at its key steps.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "reports/layouts/Placement.h"
#include "reports/picture/Picture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrpp
{

/// Ascending, at most `most` (\pre 2 or more): 0, the makespan, and of equal parts of the schedule between
/// them the step each after which most robots are at their goals, of several the last one.
/// \param atGoal robots at their goals after each step, from 0 to the makespan
[[nodiscard]] std::vector<std::size_t> keySteps(const std::vector<std::uint32_t> &atGoal, std::size_t most);

/// The steps are those of the condensed solution. Graphs of at most kLargestGraph vertices and grids of any
/// size, drawn with cairo; the same input gives the same bytes. \pre the solution is legal
/// Throws DrawingError where the graph is too large.
[[nodiscard]] Picture drawFrames(const Instance &instance, const Solution &solution,
                                 const Placement &placement, const std::string &title);

} // namespace mrpp
