#pragma once

#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/RunRecord.h"

namespace mrpp
{

/// Writes into a record which run of the plan it is; what the run gave stays.
void fillIdentity(RunRecord &record, const BenchmarkPlan &plan, const RunSpec &spec);

} // namespace mrpp
