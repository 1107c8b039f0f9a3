#pragma once

#include "framework/plan/BenchmarkPlan.h"

namespace mrpp
{

/// Says on standard error which outside planners' programs cannot be started here: where nothing is run now,
/// they may still come.
void noteMissingPrograms(const BenchmarkPlan &plan);

} // namespace mrpp
