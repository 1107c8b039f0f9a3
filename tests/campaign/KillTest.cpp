#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "tests/campaign/Victim.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mrpp
{
namespace
{

using Access = ResultStore::Access;

/// Starts the victim on a folder; returns its process id.
pid_t startVictim(const std::filesystem::path &folder, const std::string &jobs)
{
    const std::string name = folder.string();
    const pid_t child = ::fork();
    if (child == 0)
    {
        ::execl(MRPP_CAMPAIGN_VICTIM, "victim", name.c_str(), jobs.c_str(), nullptr);
        ::_exit(127);
    }
    return child;
}

std::size_t finishedRuns(const std::filesystem::path &folder)
{
    if (!std::filesystem::exists(folder / "provenance.json")) // written when the store is there
        return 0;
    return ResultStore(folder, Access::read).finishedKeys().size();
}

/// Waits until more than `count` runs are finished, then kills; returns what waitpid says.
int killAfter(pid_t victim, const std::filesystem::path &folder, std::size_t count)
{
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(100);
    while (finishedRuns(folder) <= count && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(victim, SIGKILL);
    int status = 0;
    ::waitpid(victim, &status, 0);
    return status;
}

/// Each finished run with everything that was measured.
std::map<std::string, std::string> finished(const std::filesystem::path &folder)
{
    const ResultStore store(folder, Access::read);
    std::map<std::string, std::string> runs;
    for (const RunRecord &record : store.records())
    {
        std::string text;
        for (const RunColumn &column : runColumns())
            text += toText(column.get(record)) + "\n";
        const auto solution = store.solution(record.runKey);
        runs[record.runKey] = text + (solution ? solution->fingerprint() : "");
    }
    return runs;
}

class KillTest : public testing::TestWithParam<std::string>
{};

TEST_P(KillTest, LosesRepeatsAndChangesNoFinishedRun)
{
    const BenchmarkPlan plan = fixtures::victimPlan();
    const fixtures::TemporaryFolder folder;
    std::map<std::string, std::string> before;
    for (const std::size_t count : {3U, 20U, 40U})
    {
        const int status = killAfter(startVictim(folder.path(), GetParam()), folder.path(), count);
        ASSERT_TRUE(WIFSIGNALED(status)) << "ended by itself: " << status;
        const auto now = finished(folder.path());
        EXPECT_GT(now.size(), count);
        EXPECT_LT(now.size(), 90U);
        for (const auto &[key, run] : before)
            EXPECT_EQ(now.at(key), run);
        before = now;
    }

    const Catalog catalog = fixtures::catalog();
    const auto summary = Benchmark(plan, catalog).benchmark({.folder = folder.path()}, {});
    EXPECT_EQ(summary.kept, before.size());
    EXPECT_EQ(summary.kept + summary.finished, 90U);
    const auto after = finished(folder.path());
    EXPECT_EQ(after.size(), 90U);
    for (const auto &[key, run] : before)
        EXPECT_EQ(after.at(key), run);

    // Runs that a kill caught under way, or on their way to the disk, are begun again: a few of the ninety.
    // What was on the disk is not.
    std::int64_t repeated = 0;
    const ResultTable table = fixtures::table(plan, folder.path());
    for (const RunRecord &record : table.records())
        repeated += record.attempt - 1;
    EXPECT_LE(repeated, 30);

    const fixtures::TemporaryFolder undisturbed;
    (void)Benchmark(plan, catalog).benchmark({.folder = undisturbed.path()}, {});
    EXPECT_EQ(fixtures::rows(plan, folder.path()), fixtures::rows(plan, undisturbed.path()));
}

INSTANTIATE_TEST_SUITE_P(Jobs, KillTest, testing::Values("1", "2"));

TEST(CampaignFolder, BelongsToOneProcessAtATime)
{
    const fixtures::TemporaryFolder folder;
    const ResultStore mine(folder.path(), Access::write);
    const pid_t victim = startVictim(folder.path(), "1");
    int status = 0;
    ::waitpid(victim, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3);
    EXPECT_TRUE(mine.finishedKeys().empty());
}

} // namespace
} // namespace mrpp
