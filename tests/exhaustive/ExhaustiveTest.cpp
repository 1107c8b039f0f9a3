/// \file
/// A sample of what the target `exhaustive` does.

#include "tests/exhaustive/Exhaustive.h"
#include "tests/contract/EverythingRegistered.h"

#include <gtest/gtest.h>

namespace mrpp::test
{
namespace
{

TEST(Exhaustive, OracleAndPlannersAgreeWithBruteForceOnSmallGraphs)
{
    ExhaustiveSettings settings{.vertices = 5, .threads = 1};
    settings.every = 3;
    const ExhaustiveResult result = checkSmallGraphs(everythingRegistered(), settings);
    EXPECT_EQ(result.graphs, 31U);
    EXPECT_EQ(result.failures, 0U) << describe(result);
}

TEST(Exhaustive, PlannersSolveRandomSolvableInstances)
{
    const ExhaustiveResult result =
        checkRandomInstances(everythingRegistered(), {.threads = 1, .random = 200});
    EXPECT_EQ(result.instances, 560U);
    EXPECT_EQ(result.failures, 0U) << describe(result);
}

} // namespace
} // namespace mrpp::test
