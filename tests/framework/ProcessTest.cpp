/// \file
/// Cores, process trees and control groups: what the engine asks of the system.

#include "framework/system/ControlGroup.h"
#include "framework/system/Cores.h"
#include "framework/system/CpuTime.h"
#include "framework/system/ProcessTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

/// A process that does something and then waits to be killed.
template <class Work>
pid_t startProcess(Work &&work)
{
    const pid_t child = ::fork();
    if (child != 0)
        return child;
    work();
    for (;;)
        ::pause();
}

void spin(double seconds)
{
    const double end = processCpuTime() + seconds;
    while (processCpuTime() < end)
        continue;
}

template <class Condition>
bool soon(Condition &&condition)
{
    constexpr int kPatience = 3000;
    for (int i = 0; i < kPatience && !condition(); ++i)
        ::usleep(10'000);
    return condition();
}

TEST(Cores, AreSharedInEqualNeighbouringParts)
{
    const CoreSet cores = {0, 4, 1, 5, 2};
    EXPECT_EQ(shareCores(cores, 2), (std::vector<CoreSet>{{0, 4}, {1, 5}}));
    EXPECT_EQ(shareCores(cores, 5).size(), 5U);
    EXPECT_TRUE(shareCores(cores, 6).empty());
    EXPECT_TRUE(shareCores(cores, 0).empty());
    EXPECT_EQ(toString(CoreSet{3, 0, 1, 2, 8}), "0-3,8");
    EXPECT_EQ(toString(CoreSet{}), "");
}

TEST(Cores, ConfineAProcess)
{
    const CoreSet cores = allowedCores();
    ASSERT_FALSE(cores.empty());
    const pid_t child = startProcess([] {});
    EXPECT_TRUE(confine(child, {cores.front()}));
    cpu_set_t set;
    CPU_ZERO(&set);
    ASSERT_EQ(::sched_getaffinity(child, sizeof set, &set), 0);
    EXPECT_EQ(CPU_COUNT(&set), 1);
    EXPECT_TRUE(CPU_ISSET(cores.front(), &set));
    endChildren();
}

TEST(CpuWatch, StopsAfterItsTime)
{
    const CpuWatch watch;
    const TerminationCondition ptc = watch.limit(0.05);
    EXPECT_FALSE(ptc());
    while (!ptc())
        continue;
    EXPECT_GE(watch.seconds(), 0.05);
    EXPECT_TRUE(ptc());
}

TEST(ProcessTree, FindsCountsAndEndsDescendantsInOtherSessions)
{
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t child = startProcess(
        []
        {
            if (::fork() == 0)
            {
                ::setsid();
                spin(0.2);
            }
        });
    EXPECT_TRUE(soon([child] { return descendantsOf(child).size() == 1; }));
    EXPECT_TRUE(soon([child] { return treeCpuTime(child) >= 0.19; }));
    const std::vector<pid_t> all = descendantsOf(::getpid());
    EXPECT_EQ(all.size(), 2U);
    endChildren();
    for (const pid_t process : all)
        EXPECT_NE(::kill(process, 0), 0);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(ProcessTree, TellsAProcessesOwnMemory)
{
    const pid_t child = startProcess(
        []
        {
            constexpr std::size_t kBytes = 50'000'000;
            char *memory = static_cast<char *>(std::malloc(kBytes));
            std::fill_n(memory, kBytes, 'x');
            static volatile char last = memory[kBytes - 1];
            (void)last;
        });
    EXPECT_TRUE(soon([child] { return ownMemory(child) >= 50; }));
    endChildren();
}

TEST(ControlGroup, CountsWhatIsInItAndEndsIt)
{
    auto group = ControlGroup::make();
    if (!group)
        GTEST_SKIP() << "this system gives no control groups";
    const auto work = []
    {
        ::raise(SIGSTOP); // until it is in the group
        if (::fork() == 0)
            spin(0.2);
    };
    const pid_t child = startProcess(work);
    int status = 0;
    ::waitpid(child, &status, WUNTRACED);
    ASSERT_TRUE(group->add(child));
    ::kill(child, SIGCONT);
    const bool counts = !group->cpuMeans().empty();
    EXPECT_TRUE(soon([&] { return !counts || group->cpuTime().value_or(0) >= 0.2; }));
    const std::vector<pid_t> inside = descendantsOf(child);
    group.reset();
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    for (const pid_t process : inside)
        EXPECT_TRUE(soon([process] { return ::kill(process, 0) != 0; }));
}

TEST(ControlGroup, MeasuresAndLimitsMemory)
{
    auto group = ControlGroup::make();
    if (!group || group->memoryMeans().empty())
        GTEST_SKIP() << "this system gives no control groups for memory";
    const auto eat = [](std::size_t bytes)
    {
        return [bytes]
        {
            ::raise(SIGSTOP);
            char *memory = static_cast<char *>(std::malloc(bytes));
            std::fill_n(memory, bytes, 'x');
            static volatile char last = memory[bytes - 1];
            (void)last;
        };
    };
    int status = 0;
    const pid_t modest = startProcess(eat(50'000'000));
    ::waitpid(modest, &status, WUNTRACED);
    ASSERT_TRUE(group->add(modest));
    group->watchMemory();
    group->limitMemory(100);
    ::kill(modest, SIGCONT);
    EXPECT_TRUE(soon([modest] { return ownMemory(modest) >= 50; }));
    EXPECT_NEAR(group->memoryGrowth().value_or(50), 50, 5);
    EXPECT_FALSE(group->ranOutOfMemory());

    const pid_t greedy = startProcess(eat(200'000'000));
    ::waitpid(greedy, &status, WUNTRACED);
    ASSERT_TRUE(group->add(greedy));
    ::kill(greedy, SIGCONT);
    EXPECT_EQ(::waitpid(greedy, &status, 0), greedy);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_TRUE(group->ranOutOfMemory());
    group.reset();
    ::waitpid(modest, &status, 0);
}

} // namespace
} // namespace mrpp
