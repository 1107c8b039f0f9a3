#include "framework/run/RunQueue.h"

#include "framework/store/ResultWriter.h"
#include "framework/support/Error.h"
#include "tests/campaign/Fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace mrpp
{
namespace
{

std::vector<RunSpec> specs()
{
    return expand(fixtures::plan({"walker", "half", "liar"}, 10)); // 30 cases
}

TEST(RunQueue, GivesEachRunOnce)
{
    RunQueue queue(specs(), 1, 3);
    std::set<std::string> keys;
    for (std::size_t taker = 0; const RunSpec *run = queue.take(taker % 3); ++taker)
        EXPECT_TRUE(keys.insert(run->runKey).second);
    EXPECT_EQ(keys.size(), 90U);
    for (std::size_t taker = 0; taker < 3; ++taker)
        EXPECT_EQ(queue.take(taker), nullptr);
}

TEST(RunQueue, LeavesACaseWithItsTakerUntilNoneIsUntouched)
{
    RunQueue queue(specs(), 1, 2);
    std::vector<std::string> mine;
    std::vector<std::string> others;
    for (int i = 0; i < 30; ++i)
    {
        mine.push_back(queue.take(0)->caseId);
        others.push_back(queue.take(1)->caseId);
    }
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
        EXPECT_EQ(mine[i], mine[i - i % 3]);
        EXPECT_EQ(others[i], others[i - i % 3]);
        EXPECT_NE(mine[i], others[i]);
    }
}

TEST(RunQueue, HelpsOthersWithTheLastCase)
{
    std::vector<RunSpec> one = specs();
    std::erase_if(one, [&one](const RunSpec &run) { return run.repetition != 0 || run.point != 0; });
    RunQueue queue(std::move(one), 1, 2);
    EXPECT_NE(queue.take(0), nullptr);
    EXPECT_NE(queue.take(1), nullptr);
    EXPECT_NE(queue.take(1), nullptr);
    EXPECT_EQ(queue.take(0), nullptr);
}

TEST(RunQueue, ShufflesBySeed)
{
    const auto order = [](Seed seed)
    {
        RunQueue queue(specs(), seed, 1);
        std::vector<std::string> keys;
        while (const RunSpec *run = queue.take(0))
            keys.push_back(run->runKey);
        return keys;
    };
    EXPECT_EQ(order(1), order(1));
    EXPECT_NE(order(1), order(2));
}

FinishedRun named(const std::string &key)
{
    FinishedRun run;
    run.record.runKey = key;
    run.record.caseId = "a/b/0";
    return run;
}

TEST(ResultWriter, TellsOfEachRunWhenItIsKept)
{
    const fixtures::TemporaryFolder folder;
    ResultStore store(folder.path(), ResultStore::Access::write);
    std::vector<std::string> kept;
    const auto onKept = [&](const RunRecord &record)
    {
        const auto keys = ResultStore(folder.path(), ResultStore::Access::read).finishedKeys();
        EXPECT_TRUE(keys.contains(record.runKey));
        kept.push_back(record.runKey);
    };
    ResultWriter writer(store, onKept, [] { FAIL(); });
    std::vector<std::string> put;
    for (int i = 0; i < 100; ++i)
    {
        put.push_back(std::to_string(i));
        writer.put(named(put.back()));
    }
    writer.finish();
    EXPECT_EQ(kept, put);
}

TEST(ResultWriter, KeepsTheRunsBeforeTheOneThatCannotBeKept)
{
    const fixtures::TemporaryFolder folder;
    ResultStore store(folder.path(), ResultStore::Access::write);
    int failures = 0;
    ResultWriter writer(
        store, [](const RunRecord &) {}, [&failures] { ++failures; });
    writer.put(named("a"));
    writer.put(named("b"));
    FinishedRun bad = named("c");
    bad.record.extra["time"] = 1.0; // the name of another column
    writer.put(std::move(bad));
    EXPECT_THROW(writer.finish(), InputError);
    EXPECT_EQ(failures, 1);
    EXPECT_EQ(store.finishedKeys(), (std::set<std::string>{"a", "b"}));
}

} // namespace
} // namespace mrpp
