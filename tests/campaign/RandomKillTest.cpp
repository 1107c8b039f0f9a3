/// \file
/// A campaign of 2004 runs in workers whose processes are killed, or stopped and continued, at random
/// moments, and which is started again each time its own process was killed. MRPP_KILLS says how often; a few
/// by default.

#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "tests/campaign/Fixtures.h"
#include "tests/campaign/Hostile.h"
#include "tests/campaign/Processes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{
namespace
{

using Rows = std::map<std::string, std::string>; // by run key, with everything that was measured

Rows finished(const std::filesystem::path &folder)
{
    Rows rows;
    if (!std::filesystem::exists(folder / "provenance.json")) // written when the store is there
        return rows;
    const ResultStore store(folder, ResultStore::Access::read);
    for (const RunRecord &record : store.records())
        for (const RunColumn &column : runColumns())
            rows[record.runKey] += toText(column.get(record)) + "\n";
    return rows;
}

pid_t start(const std::filesystem::path &folder)
{
    const std::string name = folder.string();
    const pid_t child = ::fork();
    if (child == 0)
    {
        ::execl(MRPP_CAMPAIGN_VICTIM, "victim", name.c_str(), "2", "many", nullptr);
        ::_exit(127);
    }
    return child;
}

/// Kills at random until the campaign's own process is hit or has ended.
/// \return how it ended, as waitpid says
int disturb(pid_t campaign, const std::filesystem::path &folder, Random &random, int &kills)
{
    int status = 0;
    for (;;)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(random.below(160)));
        if (::waitpid(campaign, &status, WNOHANG) == campaign)
            return status;
        std::vector<pid_t> workers = fixtures::processes(folder.string());
        std::erase(workers, campaign);
        const bool parent = workers.empty() || random.below(2) == 0;
        ++kills;
        if (random.below(3) == 0)
        {
            const pid_t stopped = parent ? campaign : workers[random.below(workers.size())];
            ::kill(stopped, SIGSTOP);
            std::this_thread::sleep_for(std::chrono::milliseconds(random.below(1500)));
            ::kill(stopped, SIGCONT);
            continue;
        }
        ::kill(parent ? campaign : workers[random.below(workers.size())], SIGKILL);
        if (!parent)
            continue;
        ::waitpid(campaign, &status, 0);
        return status;
    }
}

void expectNobodyIsLeft(const std::filesystem::path &folder)
{
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!fixtures::processes(folder.string()).empty() && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(fixtures::processes(folder.string()).empty());
}

TEST(RandomKills, AndPausesLoseRepeatAndChangeNothing)
{
    constexpr int kAFew = 12;
    const char *asked = std::getenv("MRPP_KILLS");
    const int wanted = asked == nullptr ? kAFew : std::atoi(asked);
    const BenchmarkPlan plan = fixtures::namedPlan("many");
    const fixtures::TemporaryFolder undisturbed;
    (void)Benchmark(plan, fixtures::hostileCatalog())
        .benchmark({.folder = undisturbed.path(), .jobs = 2}, {});
    const auto expected = fixtures::rows(plan, undisturbed.path());
    ASSERT_EQ(expected.size(), 2004U);

    Random random(asked == nullptr ? 1 : std::random_device()());
    int kills = 0;
    int campaigns = 0;
    while (kills < wanted)
    {
        ++campaigns;
        const fixtures::TemporaryFolder folder;
        Rows before;
        for (bool over = false; !over;)
        {
            const pid_t campaign = start(folder.path());
            int status = 0;
            if (kills < wanted)
                status = disturb(campaign, folder.path(), random, kills);
            else
                ::waitpid(campaign, &status, 0);
            over = WIFEXITED(status);
            ASSERT_TRUE(!over || WEXITSTATUS(status) == 0) << WEXITSTATUS(status);
            Rows now = finished(folder.path());
            ASSERT_GE(now.size(), before.size());
            for (const auto &[key, run] : before)
                ASSERT_EQ(now.at(key), run);
            before = std::move(now);
        }
        expectNobodyIsLeft(folder.path());
        EXPECT_EQ(before.size(), 2004U);
        EXPECT_EQ(fixtures::rows(plan, folder.path()), expected);
    }
    std::printf("%d kills and pauses, %d campaigns\n", kills, campaigns);
}

} // namespace
} // namespace mrpp
