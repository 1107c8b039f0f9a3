#pragma once
/// \file
/// The `planners` and `optimizers` of a plan: registered ones with their settings, and outside programs.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Config.h"

#include <filesystem>
#include <vector>

namespace mrpp
{

/// All planners, in the plan's order. A setting may be a sweep: it makes planners of its own, named after the
/// value. \param folder the plan's, where commands start
/// Throws PlanError, also where two have one name.
[[nodiscard]] std::vector<Configured> readPlanners(const Config::Entry &entry, const Catalog &catalog,
                                                   const std::filesystem::path &folder);

/// Throws PlanError.
[[nodiscard]] std::vector<Configured> readOptimizers(const Config::Entry &entry, const Catalog &catalog);

} // namespace mrpp
