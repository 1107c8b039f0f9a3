/// \file
/// Planners on a graph of a million vertices, half and nearly full: they have to stop when they are told to
/// even while they still arrange their memory, and in the middle of a search over the whole graph.

#include "framework/Planner.h"
#include "framework/Problem.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/contract/UnderLimits.h"
#include "tests/support/PollWatch.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace mrpp::test
{
namespace
{

class OnAMillionVertices : public testing::TestWithParam<std::string>
{};

TEST_P(OnAMillionVertices, StopsInTime)
{
    underLimits(
        [&]
        {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
            GTEST_SKIP() << "takes minutes without optimization";
#endif
            const auto graph = gridGraph(1000, 1000);
            const auto planner = everythingRegistered().planners.create(GetParam());
            std::optional<std::string> reason;
            bool takesOne = false;
            for (const std::size_t robots : {500'000, 999'998, 999'999})
            {
                const auto instance = std::make_shared<const Instance>(randomInstance(graph, robots, 2));
                reason = planner->reasonToReject(*instance);
                if (reason)
                    continue;
                takesOne = true;
                planner->clear();
                planner->setInstance(instance);
                planner->setup();
                for (const double limit : {0.0, 0.02, 0.3, 1.0})
                {
                    PollWatch watch(limit);
                    const PlannerStatus status =
                        planner->solve(TerminationCondition::when([&watch] { return watch.poll(); }));
                    watch.poll();
                    // Below 50 ms on a quiet machine; other work makes memory slower.
                    EXPECT_LT(watch.longest(), 1.5 * kPromptly)
                        << robots << " robots, limit of " << limit << " s, " << toString(status);
                }
            }
            if (!takesOne)
                GTEST_SKIP() << *reason;
        });
}

INSTANTIATE_TEST_SUITE_P(Registered, OnAMillionVertices,
                         testing::ValuesIn(everythingRegistered().planners.names()), nameOf);

} // namespace
} // namespace mrpp::test
