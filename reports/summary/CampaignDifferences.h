#pragma once
/// \file
/// What two campaigns that are compared were told and where they ran, as far as it differs: before any test,
/// a reader must know that one had other limits.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultStore.h"

#include <string>
#include <vector>

namespace mrpp
{

/// One of the two.
struct ComparedCampaign
{
    const BenchmarkPlan &plan;
    const Provenance &provenance;
    AskedParts asked; ///< may be empty
};

/// A line each, settings and limits first, then program and machine: "time limit: 60 before, 0.003 now",
/// "parameter restarts: 1 before, 20 now (push_and_rotate)". What only one of the two has beside the other is
/// left out. What the store wrote down of its runs counts; where it knows nothing, the plan.
[[nodiscard]] std::vector<std::string> campaignDifferences(const ComparedCampaign &before,
                                                           const ComparedCampaign &now);

} // namespace mrpp
