#pragma once
/// \file
/// Why a campaign that goes on would carry out a run that its folder seems to hold already.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/store/ResultStore.h"

#include <string>
#include <vector>

namespace mrpp
{

struct MissingRun
{
    RunSpec spec;
    std::string
        why; ///< "new: …", "changed: time limit was '60', is '30'", "…; begun once before, never finished"
};

/// The runs of the plan that the store does not hold, in the plan's order, each with the reason: nobody has
/// asked this planner this case before, or what the newest such run depended on has changed, part by part.
/// \param store of the campaign's folder; null where there is none yet
[[nodiscard]] std::vector<MissingRun> missingRuns(const BenchmarkPlan &plan, const ResultStore *store);

} // namespace mrpp
