/// \file
/// Worker processes, seen through whole campaigns.

#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "framework/support/Error.h"
#include "framework/system/Cores.h"
#include "tests/campaign/Fixtures.h"
#include "tests/campaign/Hostile.h"
#include "tests/campaign/Processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <map>
#include <set>
#include <thread>

namespace mrpp
{
namespace
{

using testing::HasSubstr;
using testing::StartsWith;

/// A campaign in workers; the workers' command lines hold the folder's name.
class Campaign
{
public:
    explicit Campaign(const std::string &plan) : plan_(fixtures::namedPlan(plan)) {}

    Benchmark::Summary run(std::int64_t jobs, const std::stop_token &stop = {})
    {
        return Benchmark(plan_, catalog_)
            .benchmark({.folder = folder_.path(),
                        .jobs = jobs,
                        .worker = {MRPP_CAMPAIGN_VICTIM, "worker", folder_.path().string()}},
                       stop);
    }

    /// The records of a planner.
    [[nodiscard]] std::vector<RunRecord> records(const std::string &planner) const
    {
        std::vector<RunRecord> records;
        for (const RunRecord &record : ResultStore(folder_.path(), ResultStore::Access::read).records())
            if (record.planner == planner)
                records.push_back(record);
        return records;
    }

    [[nodiscard]] RunRecord record(const std::string &planner) const { return records(planner).at(0); }
    [[nodiscard]] std::vector<std::string> rows() const { return fixtures::rows(plan_, folder_.path()); }
    [[nodiscard]] std::vector<pid_t> workers() const { return fixtures::processes(folder_.path().string()); }
    [[nodiscard]] const BenchmarkPlan &plan() const { return plan_; }
    [[nodiscard]] const Catalog &catalog() const { return catalog_; }

private:
    fixtures::TemporaryFolder folder_;
    BenchmarkPlan plan_;
    Catalog catalog_ = fixtures::hostileCatalog();
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

TEST(Worker, ContainsEveryHostilePlanner)
{
    if (kSanitized)
        GTEST_SKIP() << "a sanitizer has its own ways to die";
    Campaign campaign("hostile");
    const auto summary = campaign.run(2);
    EXPECT_EQ(summary.finished, summary.planned);
    EXPECT_TRUE(campaign.workers().empty());

    using enum PlannerStatus;
    const std::map<std::string, std::pair<PlannerStatus, std::string>> expected = {
        {"segfaulter", {crash, "killed by signal 11 (Segmentation fault) in solve()"}},
        {"aborter", {crash, "killed by signal 6 (Aborted) in solve()"}},
        {"exiter", {crash, "ended its process with exit code 0 in solve()"}},
        {"overflower", {crash, "killed by signal 11 (Segmentation fault) in solve()"}},
        {"spinner", {timeout, "did not stop in solve(): killed 2 s after its limit of 0.3 s"}},
        {"setup_spinner", {timeout, "did not stop in setup(): killed 2 s after its limit of 0.3 s"}},
        {"glutton", {memory_limit, "out of memory"}},
        {"eater", {memory_limit, "out of memory"}},
        {"thrower", {crash, "threw: no luck"}},
        {"liar", {invalid, ""}},
        {"jumper", {invalid, ""}},
        {"prover", {invalid, "called a solvable instance infeasible"}},
        {"daemon", {timeout, "did not stop in solve(): killed 2 s after its limit of 0.3 s"}},
        {"deserter", {crash, "killed by signal 11 (Segmentation fault) in solve()"}},
        {"family", {memory_limit, ""}},
        {"forker", {solved, ""}},
        {"double", {solved, ""}},
        {"sleeper", {solved, ""}},
        {"walker", {solved, ""}},
    };
    for (const auto &[planner, end] : expected)
    {
        SCOPED_TRACE(planner);
        ASSERT_EQ(campaign.records(planner).size(), 1U);
        const RunRecord record = campaign.record(planner);
        EXPECT_EQ(record.status, end.first) << record.reason;
        EXPECT_THAT(record.reason, StartsWith(end.second));
        EXPECT_EQ(record.vertices, 24);
        EXPECT_FALSE(record.instanceFingerprint.empty());
        EXPECT_THAT(record.limitMeans, HasSubstr("rlimit"));
    }
    for (const char *planner : {"spinner", "setup_spinner", "daemon"})
        EXPECT_EQ(campaign.record(planner).terminationReason, "walltime") << planner;
    for (const char *planner : {"glutton", "eater", "family"})
        EXPECT_EQ(campaign.record(planner).terminationReason, "memory") << planner;
    for (const char *planner : {"segfaulter", "exiter", "walker", "liar"})
        EXPECT_EQ(campaign.record(planner).terminationReason, "") << planner;

    // Whoever runs beside it, a healthy planner's answer is the same.
    BenchmarkPlan healthy = campaign.plan();
    std::erase_if(healthy.planners, [](const Configured &planner) { return planner.kind != "walker"; });
    const fixtures::TemporaryFolder folder;
    (void)Benchmark(healthy, campaign.catalog()).benchmark({.folder = folder.path()}, {});
    EXPECT_EQ(fixtures::rows(healthy, folder.path()),
              std::vector<std::string>{fixtures::timeless(campaign.record("walker"))});

    EXPECT_EQ(std::get<std::string>(campaign.record("aborter").extra.at("error_output")),
              "assertion failed\n");
    const auto spoken = std::get<std::string>(campaign.record("chatter").extra.at("error_output"));
    EXPECT_EQ(spoken.size(), 2048U);
    EXPECT_TRUE(spoken.ends_with("last words"));
    EXPECT_NEAR(campaign.record("spinner").time.value(), 2.3, 0.5);
}

TEST(Worker, KeepsTheEndOfAGigabyteOfOutput)
{
    Campaign campaign("shouters");
    (void)campaign.run(2);
    const RunRecord shouter = campaign.record("shouter");
    EXPECT_EQ(shouter.status, PlannerStatus::solved) << shouter.reason;
    const auto spoken = std::get<std::string>(shouter.extra.at("error_output"));
    EXPECT_EQ(spoken.size(), 2048U);
    EXPECT_TRUE(spoken.ends_with("last words"));
    EXPECT_EQ(campaign.record("walker").status, PlannerStatus::solved);
}

TEST(Worker, LimitsTheCpuTimeOfAPlannerAndWhatItStarts)
{
    if (kSanitized)
        GTEST_SKIP() << "too slow";
    Campaign campaign("busy");
    (void)campaign.run(2);
    EXPECT_TRUE(campaign.workers().empty());
    const std::map<std::string, std::pair<std::string, std::string>> expected = {
        {"busy", {"cputime-soft", "the CPU time limit of 0.4 s came first"}},
        {"spinner", {"cputime", "did not stop in solve(): killed 2 s of CPU time after its limit of 0.4 s"}},
        {"foreman", {"cputime", "did not stop in solve(): killed 2 s of CPU time after its limit of 0.4 s"}}};
    for (const auto &[planner, end] : expected)
    {
        SCOPED_TRACE(planner);
        const RunRecord record = campaign.record(planner);
        EXPECT_EQ(record.status, PlannerStatus::timeout);
        EXPECT_EQ(record.terminationReason, end.first);
        EXPECT_EQ(record.reason, end.second);
        const double least = end.first == "cputime" ? 2.4 : 0.4;
        EXPECT_GE(record.cpuTime.value(), least * 0.98);
        EXPECT_LT(record.cpuTime.value(), least + 0.5);
    }
    EXPECT_EQ(campaign.record("walker").status, PlannerStatus::solved);
    EXPECT_LT(campaign.record("walker").cpuTime.value(), 0.1);
}

TEST(Worker, ConfinesEachJobToCoresOfItsOwn)
{
    Campaign campaign("walkers");
    (void)campaign.run(2);
    std::set<std::string> cores;
    for (const RunRecord &record : campaign.records("walker"))
    {
        cores.insert(record.cores);
        EXPECT_TRUE(record.load.has_value());
    }
    const auto shares = shareCores(allowedCores(), 2);
    if (shares.empty())
        EXPECT_EQ(cores, std::set<std::string>{""});
    else
        for (const std::string &set : cores)
            EXPECT_TRUE(set == toString(shares[0]) || set == toString(shares[1])) << set;
}

TEST(Worker, GivesTheSameResultsAsThisProcess)
{
    Campaign inWorkers("walkers");
    const auto summary = inWorkers.run(2);
    EXPECT_EQ(summary.finished, 120U);
    const fixtures::TemporaryFolder folder;
    (void)Benchmark(inWorkers.plan(), inWorkers.catalog()).benchmark({.folder = folder.path()}, {});
    EXPECT_EQ(inWorkers.rows(), fixtures::rows(inWorkers.plan(), folder.path()));
}

TEST(Worker, TellsEachRunsOwnMemory)
{
    if (kSanitized)
        GTEST_SKIP() << "sanitizers need memory of their own";
    Campaign campaign("holders");
    (void)campaign.run(1);
    for (const RunRecord &record : campaign.records("holder"))
        EXPECT_NEAR(record.memory.value(), 300, 15);
    for (const RunRecord &record : campaign.records("walker"))
        EXPECT_LT(record.memory.value(), 5);
    for (const RunRecord &record : campaign.records("glutton"))
        EXPECT_EQ(record.status, PlannerStatus::memory_limit) << record.reason;
}

TEST(Worker, IsReplacedWhenSomebodyKillsIt)
{
    Campaign campaign("walkers");
    std::atomic<int> kills = 0;
    Benchmark::Summary summary;
    {
        const std::jthread killer(
            [&](const std::stop_token &stop)
            {
                Random random(7);
                while (!stop.stop_requested())
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(20 + random.below(60)));
                    const auto workers = campaign.workers();
                    if (!workers.empty() && ::kill(workers[random.below(workers.size())], SIGKILL) == 0)
                        ++kills;
                }
            });
        summary = campaign.run(2);
    }
    EXPECT_EQ(summary.finished, 120U);
    EXPECT_GT(kills, 0);
    EXPECT_FALSE(summary.statuses.contains(PlannerStatus::crash));
    const fixtures::TemporaryFolder folder;
    (void)Benchmark(campaign.plan(), campaign.catalog()).benchmark({.folder = folder.path()}, {});
    EXPECT_EQ(campaign.rows(), fixtures::rows(campaign.plan(), folder.path()));
}

TEST(Worker, DoesNotPassOnWhatAPlannerDidToItsProcess)
{
    if (kSanitized)
        GTEST_SKIP() << "sanitizers need their own";
    Campaign spoiled("spoilers");
    Campaign clean("inspectors");
    (void)spoiled.run(1);
    (void)clean.run(1);
    const auto reasons = [](const Campaign &campaign)
    {
        std::set<std::string> all;
        for (const RunRecord &record : campaign.records("inspector"))
            all.insert(record.reason);
        return all;
    };
    EXPECT_EQ(reasons(clean).size(), 1U);
    EXPECT_EQ(reasons(spoiled), reasons(clean));
    for (const char *planner : {"walker", "spoiler", "wrecker"})
    {
        EXPECT_EQ(spoiled.records(planner).size(), 12U);
        for (const RunRecord &record : spoiled.records(planner))
            EXPECT_EQ(record.status, PlannerStatus::solved) << planner << ": " << record.reason;
    }
}

TEST(Worker, StopsWithItsCampaign)
{
    Campaign campaign("hostile");
    std::stop_source stop;
    const std::jthread user(
        [&stop]
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            stop.request_stop();
        });
    const auto start = std::chrono::steady_clock::now();
    const auto summary = campaign.run(2, stop.get_token());
    EXPECT_TRUE(summary.interrupted);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(kSanitized ? 20 : 2));
    EXPECT_TRUE(campaign.workers().empty());
}

TEST(Worker, SaysWhyItCannotServe)
{
    const BenchmarkPlan plan = fixtures::namedPlan("walkers");
    const Catalog catalog = fixtures::hostileCatalog();
    const fixtures::TemporaryFolder folder;
    const auto complaint = [&](const std::vector<std::string> &command) -> std::string
    {
        try
        {
            (void)Benchmark(plan, catalog).benchmark({.folder = folder.path(), .worker = command}, {});
        }
        catch (const FileError &error)
        {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(complaint({"/no/such/program"}),
                HasSubstr("/no/such/program: cannot be started as a worker"));
    EXPECT_THAT(complaint({"/bin/true"}), HasSubstr("/bin/true: ended before its first run"));
}

} // namespace
} // namespace mrpp
