#pragma once
/// \file
/// Schedules for PlanViz, the viewer of the League of Robot Runners, as its 2023 JSON.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"

#include <string>

namespace mrpp
{

/// U goes to the next row in PlanViz 2.1 and later (and in 1.3.0), to the one before in 1.3.5, 1.4.0
/// and 2.0.0.
enum class PlanVizVersion
{
    current,
    upTo2_0,
};

/// Each robot's goal is one task, assigned at time 0 and finished when the robot arrives for good. Rows come
/// before columns. Throws InputError where the graph does not lie on cells or a move does not go to a cell
/// beside. \pre the schedule is legal on the instance
/// O(robots · makespan).
[[nodiscard]] std::string formatPlanViz(const Instance &instance, const Schedule &schedule,
                                        PlanVizVersion version = PlanVizVersion::current);

} // namespace mrpp
