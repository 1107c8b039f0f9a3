#pragma once

#include "tests/campaign/Fixtures.h"

namespace mrpp::fixtures
{

/// 90 runs of some 10 ms each.
inline BenchmarkPlan victimPlan()
{
    BenchmarkPlan plan = fixtures::plan({"walker", "half", "quitter"}, 10);
    plan.planners[0].settings = {{"pause", "0.02"}};
    return plan;
}

} // namespace mrpp::fixtures
