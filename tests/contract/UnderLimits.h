#pragma once
/// \file
/// Runs the body of a test as a campaign runs a planner: in a process of its own, under limits of memory and
/// time. What eats the memory of the machine, goes on for ever or crashes fails its own test, with a message,
/// and no other one.
///
/// \code
/// TEST_P(EveryPlanner, DoesSomething)
/// {
///     underLimits([&] { EXPECT_EQ(run(instance), PlannerStatus::solved); });
/// }
/// \endcode

#include "framework/plan/BenchmarkPlan.h"

#include <functional>

namespace mrpp::test
{

struct BodyLimits
{
    double memory = Limits{}.memory; ///< MB beyond what the process holds already; as in campaigns
    double cpu = 240;                ///< seconds of processor time; below the time of a test under ctest
    double wall = 280;               ///< seconds
};

/// Failures of the body are failures of the test; so is what ends its process. Sanitizers need memory of
/// their own and look for leaks at the end: with them the body runs here, without limits.
void underLimits(const std::function<void()> &body, const BodyLimits &limits = {});

} // namespace mrpp::test
