#pragma once

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"

#include <memory>

namespace mrpp
{

/// The plan's planner, registered or an outside program, with its settings. Throws InputError where there is
/// no such planner or setting.
[[nodiscard]] std::unique_ptr<Planner> createPlanner(const Catalog &catalog, const Configured &configured);

} // namespace mrpp
