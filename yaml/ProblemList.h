#pragma once
/// \file
/// The `problems` of a plan: a family's name and its settings each, resolved to points.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Config.h"
#include "yaml/Sweep.h"

#include <vector>

namespace mrpp
{

/// All points of all entries, in the plan's order. Two entries may sweep one problem's number of robots over
/// different values; otherwise a problem whose name is taken gets another one, so that no two instances share
/// a case. Throws PlanError, also where a point stands twice.
/// \param places where it is not null, it gets the places of each point
[[nodiscard]] std::vector<ProblemPoint> readProblems(const std::vector<Config> &entries,
                                                     const ProblemContext &context,
                                                     std::vector<PointPlaces> *places = nullptr);

} // namespace mrpp
