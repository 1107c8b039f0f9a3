#include "algorithms/RestartingPlanner.h"

#include "algorithms/PushAndSwap.h"
#include "algorithms/optimizers/RedundancyRemoval.h"
#include "framework/Problem.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>

namespace mrpp
{
namespace
{

/// One robot on a path of three vertices, 0 to 2; attempt `good_` goes straight, the others step back and
/// forth, or fail.
class Script final : public RestartingPlanner
{
public:
    Script() : RestartingPlanner({.citation = "none", .completeFor = "nothing"}) {}

    enum class Others
    {
        detour,
        giveUp,
        throwing
    };

    Outcome attempt(std::uint64_t number, const TerminationCondition &) const override
    {
        ++calls;
        if (number == good)
            return {PlannerStatus::solved, {}, Solution({{0, 0, 1}, {0, 1, 2}})};
        switch (others)
        {
        case Others::detour:
            return {PlannerStatus::solved, {}, Solution({{1, 3, 4}, {0, 0, 1}, {0, 1, 2}})};
        case Others::giveUp:
            return {PlannerStatus::gave_up, "attempt " + std::to_string(number), {}};
        case Others::throwing:
            break;
        }
        throw std::bad_alloc();
    }

    std::uint64_t good = 7;
    Others others = Others::detour;
    mutable std::atomic<int> calls = 0;
};

PlannerStatus run(Script &planner, const char *restarts, const TerminationCondition &ptc = {})
{
    planner.parameters().set("restarts", restarts);
    planner.parameters().set("threads", "3");
    const auto graph = Graph::fromEdges(5, {{0, 1}, {1, 2}, {3, 4}});
    planner.setInstance(std::make_shared<Instance>(Instance{graph, {0, 3}, {2, 3}}));
    planner.setup();
    return planner.solve(ptc);
}

TEST(RestartingPlanner, KeepsTheShortestOfItsAttempts)
{
    Script planner;
    EXPECT_EQ(run(planner, "50"), PlannerStatus::solved);
    EXPECT_EQ(planner.solution().pathLength(), 2U);
    EXPECT_EQ(planner.calls, 50);
}

TEST(RestartingPlanner, MakesOneAttemptUnlessToldOtherwise)
{
    Script planner;
    EXPECT_EQ(run(planner, "1"), PlannerStatus::solved);
    EXPECT_EQ(planner.solution().pathLength(), 3U);
    EXPECT_EQ(planner.calls, 1);
}

TEST(RestartingPlanner, OneSuccessIsEnough)
{
    Script planner;
    planner.others = Script::Others::giveUp;
    EXPECT_EQ(run(planner, "50"), PlannerStatus::solved);
    EXPECT_TRUE(planner.reason().empty());
    EXPECT_EQ(run(planner, "5"), PlannerStatus::gave_up);
    EXPECT_EQ(planner.reason(), "attempt 0");
}

TEST(RestartingPlanner, KeepsWhatItHasWhenTimeIsUp)
{
    Script planner;
    EXPECT_EQ(run(planner, "1000000", TerminationCondition::after(0)), PlannerStatus::solved);
    EXPECT_EQ(planner.calls, 1);
}

TEST(RestartingPlanner, AThreadsExceptionReachesTheCaller)
{
    Script planner;
    planner.others = Script::Others::throwing;
    planner.good = 0;
    EXPECT_THROW(run(planner, "50"), std::bad_alloc);
}

TEST(RestartingPlanner, GivesTheSameSolutionWithAnyNumberOfThreads)
{
    const Instance instance = randomInstance(test::gridGraph(6, 5), 25, 11);
    std::vector<Solution> solutions;
    for (const char *threads : {"1", "2", "7"})
    {
        PushAndSwap planner;
        planner.parameters().set("restarts", "40");
        planner.parameters().set("threads", threads);
        planner.setInstance(std::make_shared<Instance>(instance));
        planner.setup();
        EXPECT_EQ(planner.solve({}), PlannerStatus::solved);
        EXPECT_TRUE(validate(instance, planner.solution(), MotionRule::pebble).valid());
        solutions.push_back(planner.solution());
    }
    EXPECT_EQ(solutions[0], solutions[1]);
    EXPECT_EQ(solutions[0], solutions[2]);

    PushAndSwap once;
    once.setInstance(std::make_shared<Instance>(instance));
    once.setup();
    EXPECT_EQ(once.solve({}), PlannerStatus::solved);
    const auto length = [&](const Solution &solution)
    { return RedundancyRemoval().improve(instance, solution, {}).pathLength(); };
    EXPECT_LE(length(solutions[0]), length(once.solution()));
}

} // namespace
} // namespace mrpp
