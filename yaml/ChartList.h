#pragma once
/// \file
/// The figures that a plan asks for: `- chart: {x: occupancy, y: path_length, per: robots, log: [y]}`.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Config.h"

namespace mrpp
{

/// Reads what stands behind `chart:`. Throws PlanError, for names that results do not have as well; `plan`
/// has its points and planners by now.
[[nodiscard]] ChartRequest readChart(const Config::Entry &entry, const BenchmarkPlan &plan);

} // namespace mrpp
