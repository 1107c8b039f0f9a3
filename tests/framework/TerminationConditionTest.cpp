#include "framework/support/TerminationCondition.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

namespace mrpp
{
namespace
{

TEST(TerminationCondition, NeverNeverStops)
{
    EXPECT_FALSE(TerminationCondition()());
    EXPECT_FALSE(TerminationCondition::never()());
    EXPECT_FALSE(TerminationCondition::never().deadline().has_value());
}

TEST(TerminationCondition, StopsAfterTheDeadlineAndNotBefore)
{
    const auto begin = TerminationCondition::Clock::now();
    const auto condition = TerminationCondition::after(0.05);
    while (!condition())
        std::this_thread::yield();
    EXPECT_GE(TerminationCondition::Clock::now() - begin, std::chrono::milliseconds(50));
    EXPECT_TRUE(condition()) << "and stays stopped";
    EXPECT_FALSE(TerminationCondition::after(1000)());
}

TEST(TerminationCondition, TakesAnyNumberOfSeconds)
{
    EXPECT_TRUE(TerminationCondition::after(0)());
    EXPECT_TRUE(TerminationCondition::after(-5)());
    EXPECT_FALSE(TerminationCondition::after(1e300)());
    EXPECT_FALSE(TerminationCondition::after(std::numeric_limits<double>::infinity())());
}

TEST(TerminationCondition, StopsWhenTheTokenIsTriggered)
{
    std::stop_source source;
    const auto condition = TerminationCondition::when(source.get_token());
    EXPECT_FALSE(condition());
    source.request_stop();
    EXPECT_TRUE(condition());
    EXPECT_FALSE(TerminationCondition::when(std::stop_token())());
}

TEST(TerminationCondition, StopsWhenThePredicateSaysSo)
{
    std::atomic<bool> stop = false;
    const auto condition = TerminationCondition::when([&] { return stop.load(); });
    EXPECT_FALSE(condition());
    stop = true;
    EXPECT_TRUE(condition());
}

TEST(TerminationCondition, OrStopsAsSoonAsAnyPartDoes)
{
    // Every subset of three parts, each part triggered alone, joined in both orders.
    for (int trigger = 0; trigger < 5; ++trigger)
    {
        std::stop_source first;
        std::stop_source second;
        std::atomic<bool> third = false;
        std::atomic<bool> fourth = false;
        const auto tokens =
            TerminationCondition::when(first.get_token()) || TerminationCondition::when(second.get_token());
        const auto predicates = TerminationCondition::when([&] { return third.load(); }) ||
                                TerminationCondition::when([&] { return fourth.load(); });
        const auto late = TerminationCondition::after(1000);
        const auto left = tokens || predicates || late;
        const auto right = late || (predicates || tokens);
        EXPECT_FALSE(left() || right());
        if (trigger == 0)
            first.request_stop();
        else if (trigger == 1)
            second.request_stop();
        else if (trigger == 2)
            third = true;
        else if (trigger == 3)
            fourth = true;
        const bool over = trigger == 4;
        EXPECT_TRUE((left || TerminationCondition::after(over ? 0 : 1000))()) << trigger;
        EXPECT_TRUE((TerminationCondition::after(over ? 0 : 1000) || right)()) << trigger;
        EXPECT_EQ(left(), !over) << trigger;
    }
}

TEST(TerminationCondition, OrKeepsTheEarlierDeadline)
{
    const auto soon = TerminationCondition::after(1);
    const auto late = TerminationCondition::after(1000);
    EXPECT_EQ((soon || late).deadline(), soon.deadline());
    EXPECT_EQ((late || soon).deadline(), soon.deadline());
    EXPECT_EQ((TerminationCondition::never() || soon).deadline(), soon.deadline());
}

} // namespace
} // namespace mrpp
