/// \file
/// The contract suite survives what it tests.

#include "tests/contract/UnderLimits.h"
#include "framework/Planner.h"
#include "framework/Problem.h"
#include "tests/support/RandomCases.h"

#include <csignal>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>

namespace mrpp::test
{
namespace
{

/// Has a table robots × vertices.
class Hoarder final : public Planner
{
public:
    Hoarder() : Planner({.citation = "none", .completeFor = "nothing"}) {}
    void setup() override { table_.assign(instance().robotCount() * graph().vertexCount(), 1); }
    PlannerStatus solve(const TerminationCondition &) override { return PlannerStatus::gave_up; }

private:
    std::vector<std::uint32_t> table_;
};

class UnderLimits : public testing::Test
{
protected:
    void SetUp() override
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "sanitizers have limits of their own";
#endif
    }
};

TEST_F(UnderLimits, ATableOfRobotsAndVerticesFailsItsOwnTestWithAMessage)
{
    EXPECT_NONFATAL_FAILURE(underLimits(
                                []
                                {
                                    Hoarder planner;
                                    const auto graph = gridGraph(300, 300);
                                    planner.setInstance(
                                        std::make_shared<Instance>(randomInstance(graph, 40'000, 1)));
                                    planner.setup(); // 14 GB
                                },
                                {.memory = 1000}),
                            "needs more than 1000 MB of memory");
}

TEST_F(UnderLimits, WhatNeverStopsFailsItsOwnTestWithAMessage)
{
    const auto spin = []
    {
        for (volatile int i = 0;; i = i + 1)
            ;
    };
    EXPECT_NONFATAL_FAILURE(underLimits(spin, {.cpu = 1}), "took more than 1 s of processor time");
    EXPECT_NONFATAL_FAILURE(underLimits([] { ::pause(); }, {.wall = 0.5}), "went on after 0.5 s");
}

TEST_F(UnderLimits, ACrashFailsItsOwnTestWithAMessage)
{
    EXPECT_NONFATAL_FAILURE(underLimits([] { std::raise(SIGKILL); }), "killed by signal 9");
    EXPECT_NONFATAL_FAILURE(underLimits([] { throw std::runtime_error("no"); }), "failed in its own process");
}

TEST_F(UnderLimits, NothingThatTheBodyDoesIsSeenOutside)
{
    int seen = 0;
    underLimits([&seen] { seen = 1; });
    EXPECT_EQ(seen, 0);
}

} // namespace
} // namespace mrpp::test
