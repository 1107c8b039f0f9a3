/// \file
/// Campaigns whose processes are stopped and continued at random moments, for longer than their limits.
/// MRPP_PAUSES says how often each time; a few by default.

#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "framework/system/ProcessTree.h"
#include "tests/campaign/Fixtures.h"
#include "tests/campaign/Hostile.h"
#include "tests/campaign/Processes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{
namespace
{

using std::chrono::milliseconds;

pid_t start(const std::filesystem::path &folder, const char *plan)
{
    const std::string name = folder.string();
    const pid_t child = ::fork();
    if (child == 0)
    {
        ::execl(MRPP_CAMPAIGN_VICTIM, "victim", name.c_str(), "2", plan, nullptr);
        ::_exit(127);
    }
    return child;
}

/// Guardians are children of the campaign, workers are their first children, and all are their descendants.
std::vector<pid_t> chosen(const std::string &who, pid_t campaign, Random &random)
{
    std::vector<pid_t> all = descendantsOf(campaign);
    if (who == "campaign")
        return {campaign};
    if (who == "all")
    {
        all.push_back(campaign);
        return all;
    }
    std::vector<pid_t> some = childrenOf(campaign);
    if (who == "worker")
    {
        std::vector<pid_t> workers;
        for (const pid_t guardian : some)
            for (const pid_t worker : childrenOf(guardian))
                workers.push_back(worker);
        some = workers;
    }
    return some.empty() ? some : std::vector{some[random.below(some.size())]};
}

void pause(const std::vector<pid_t> &processes, milliseconds duration)
{
    for (const pid_t process : processes)
        ::kill(process, SIGSTOP);
    std::this_thread::sleep_for(duration);
    for (const pid_t process : processes)
        ::kill(process, SIGCONT);
}

int pauses()
{
    constexpr int kAFew = 2;
    const char *asked = std::getenv("MRPP_PAUSES");
    return asked == nullptr ? kAFew : std::atoi(asked);
}

/// The campaign's rows after `count` pauses at random moments of it.
std::vector<std::string> disturbed(const std::string &who, int count, milliseconds duration)
{
    const fixtures::TemporaryFolder folder;
    const pid_t campaign = start(folder.path(), "brief");
    Random random(std::getenv("MRPP_PAUSES") == nullptr ? 5 : std::random_device()());
    int status = 0;
    bool over = false;
    for (int i = 0; i < count && !over; ++i)
    {
        std::this_thread::sleep_for(milliseconds(100 + random.below(300)));
        pause(chosen(who, campaign, random), duration);
        over = ::waitpid(campaign, &status, WNOHANG) == campaign;
    }
    if (!over)
        ::waitpid(campaign, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    return fixtures::rows(fixtures::namedPlan("brief"), folder.path());
}

std::vector<std::string> undisturbed()
{
    const BenchmarkPlan plan = fixtures::namedPlan("brief");
    const fixtures::TemporaryFolder folder;
    (void)Benchmark(plan, fixtures::hostileCatalog()).benchmark({.folder = folder.path(), .jobs = 2}, {});
    return fixtures::rows(plan, folder.path());
}

class Pause : public testing::TestWithParam<std::string>
{};

TEST_P(Pause, IsNobodysTimeout)
{
    EXPECT_EQ(disturbed(GetParam(), pauses(), milliseconds(900)), undisturbed());
}

TEST_P(Pause, MayLastLongerThanTheCampaignsPatience)
{
    EXPECT_EQ(disturbed(GetParam(), 1, milliseconds(3500)), undisturbed());
}

INSTANTIATE_TEST_SUITE_P(Of, Pause, testing::Values("campaign", "all", "worker", "guardian"),
                         [](const auto &info) { return info.param; });

TEST(PauseOfAPlannerThatNeverStops, IsNoExcuseForIt)
{
    const fixtures::TemporaryFolder folder;
    const pid_t campaign = start(folder.path(), "deaf");
    std::this_thread::sleep_for(milliseconds(400));
    Random random(1);
    pause(chosen("worker", campaign, random), milliseconds(300));
    int status = 0;
    ::waitpid(campaign, &status, 0);
    const auto records = ResultStore(folder.path(), ResultStore::Access::read).records();
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].status, PlannerStatus::timeout) << records[0].reason;
    EXPECT_NEAR(records[0].time.value(), 2.3, 0.5); // of a go without a pause
}

} // namespace
} // namespace mrpp
