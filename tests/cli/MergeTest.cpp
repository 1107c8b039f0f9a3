#include "framework/store/ResultStore.h"
#include "framework/store/Sqlite.h"
#include "tests/cli/Comparison.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

void runPart(const Scratch &scratch, const std::string &folder, const std::string &shard,
             const std::string &plan = "plan.yaml")
{
    const Outcome outcome =
        mrppsim({"run", plan, "-o", folder, "--shard", shard, "--no-report", "-q"}, scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
}

/// A whole campaign, and its three parts.
void runAll(const Scratch &scratch)
{
    prepareCampaign(scratch, 3);
    runPart(scratch, "whole", "1/1");
    for (const char *part : {"1", "2", "3"})
        runPart(scratch, std::string("part") + part, std::string(part) + "/3");
    ASSERT_EQ(mrppsim({"report", "whole"}, scratch).code, 0);
}

void change(const Scratch &scratch, const std::string &folder, const std::string &sql)
{
    sqlite::Connection store(scratch.path() / folder / "results.sqlite", sqlite::Connection::Mode::write);
    store.run(sql);
}

TEST(Merge, ofAllShardsIsTheWholeCampaign)
{
    const Scratch scratch;
    runAll(scratch);
    const Outcome outcome = mrppsim({"merge", "deep/all/", "part1", "part2", "part3"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "24 runs in deep/all/: 24 new, 0 found twice\n");
    EXPECT_FALSE(scratch.has("deep/all.merging"));
    EXPECT_EQ(mrppsim({"report", "deep/all"}, scratch).code, 0);
    expectSameCampaign(scratch, "whole", "deep/all");

    // It is a campaign's folder like any other: there is nothing left to run.
    const Outcome again = mrppsim({"run", "plan.yaml", "-o", "deep/all"}, scratch);
    EXPECT_THAT(again.out, HasSubstr("24 runs (0 now, 24 before)"));
}

TEST(Merge, countsWhatCameTwiceOnce)
{
    const Scratch scratch;
    runAll(scratch);
    runPart(scratch, "part2again", "2/3");
    EXPECT_EQ(mrppsim({"merge", "all", "part1", "part2", "part2again", "part3"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"report", "all"}, scratch).code, 0);
    expectSameCampaign(scratch, "whole", "all");
    const std::string results = scratch.read("all/results.csv");

    const Outcome again = mrppsim({"merge", "all", "all", "part2again", "part1", "part3"}, scratch);
    EXPECT_EQ(again.out, "24 runs in all: 0 new, 24 found twice\n");
    EXPECT_EQ(mrppsim({"report", "all"}, scratch).code, 0);
    EXPECT_EQ(scratch.read("all/results.csv"), results);
}

TEST(Merge, takesPartsAsTheyCome)
{
    const Scratch scratch;
    runAll(scratch);
    change(scratch, "part2", "DELETE FROM runs WHERE id % 2 = 0"); // it was stopped
    const Outcome first = mrppsim({"merge", "all", "part2"}, scratch);
    EXPECT_THAT(first.out, HasSubstr("runs of the plan missing; to run them: mrppsim run " +
                                     (scratch.path() / "plan.yaml").string() + " -o all"));
    EXPECT_EQ(mrppsim({"merge", "all", "part1", "part3"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "-o", "all", "-q"}, scratch).code, 0);
    expectSameCampaign(scratch, "whole", "all");
}

TEST(Merge, refusesContradictions)
{
    const Scratch scratch;
    runAll(scratch);
    runPart(scratch, "part2again", "2/3");
    change(scratch, "part2again", "UPDATE runs SET path_length = path_length + 1 WHERE id = 2");
    const Outcome outcome = mrppsim({"merge", "all", "part1", "part2", "part2again"}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err,
                ::testing::MatchesRegex("part2again: run [0-9a-f]{32} \\(.*\\) has the path_length "
                                        "[0-9]+, but [0-9]+ in part2; .*\n"));
    EXPECT_FALSE(scratch.has("all"));
    EXPECT_FALSE(scratch.has("all.merging"));

    // What is there already stays as it was.
    ASSERT_EQ(mrppsim({"merge", "all", "part1", "part2"}, scratch).code, 0);
    const auto before = scratch.tree("all");
    EXPECT_EQ(mrppsim({"merge", "all", "part3", "part2again"}, scratch).code, 2);
    const ResultStore store(scratch.path() / "all", ResultStore::Access::read);
    const ResultStore parts1(scratch.path() / "part1", ResultStore::Access::read);
    const ResultStore parts2(scratch.path() / "part2", ResultStore::Access::read);
    EXPECT_EQ(store.records().size(), parts1.records().size() + parts2.records().size());
    EXPECT_EQ(scratch.read("all/provenance.json"), before.at("provenance.json"));
}

TEST(Merge, knowsThatLimitsEndRunsNowAndThen)
{
    const Scratch scratch;
    runAll(scratch);
    runPart(scratch, "part2again", "2/3");
    change(scratch, "part2again",
           "UPDATE runs SET status = 4, path_length = NULL, solution_fingerprint = '' WHERE id = 2");
    EXPECT_EQ(mrppsim({"merge", "all", "part1", "part2", "part3", "part2again"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"report", "all"}, scratch).code, 0);
    expectSameCampaign(scratch, "whole", "all"); // the first folder's answer counts
}

TEST(Merge, refusesOtherPlansAndSaysWhatDiffers)
{
    const Scratch scratch;
    prepareCampaign(scratch, 3);
    const std::string plan = scratch.read("plan.yaml");
    std::string other = plan;
    other.replace(other.find("seed: 5"), 7, "seed: 6");
    scratch.write("other.yaml", other);
    scratch.write("longer.yaml", plan + "# the end\n");
    runPart(scratch, "one", "1/2");
    runPart(scratch, "two", "2/2", "other.yaml");
    runPart(scratch, "three", "2/2", "longer.yaml");
    const Outcome outcome = mrppsim({"merge", "all", "one", "two"}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "two/plan.yaml:2:1: here is 'seed: 6', but 'seed: 5' in one/plan.yaml; only parts of "
              "one campaign can be merged\n");
    EXPECT_EQ(mrppsim({"merge", "all", "one", "three"}, scratch).err,
              "three/plan.yaml:14:1: here is '# the end', but the end in one/plan.yaml; only parts of one "
              "campaign can be merged\n");
    EXPECT_FALSE(scratch.has("all"));
}

TEST(Merge, leavesOtherFoldersAlone)
{
    const Scratch scratch;
    prepareCampaign(scratch, 3);
    runPart(scratch, "one", "1/2");
    scratch.write("thesis/chapter1.tex", "done");
    const Outcome outcome = mrppsim({"merge", "thesis", "one"}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("thesis: is there already and holds no campaign"));
    EXPECT_EQ(scratch.tree("thesis").size(), 1U);
    EXPECT_THAT(mrppsim({"merge", "all", "one", "nowhere"}, scratch).err,
                HasSubstr("nowhere: holds no campaign"));
    EXPECT_FALSE(scratch.has("all"));
}

TEST(Merge, keepsColumnsTablesAndProgressOfEveryStore)
{
    const Scratch scratch;
    prepareCampaign(scratch, 3);
    runPart(scratch, "one", "1/2");
    runPart(scratch, "two", "2/2");
    change(
        scratch, "two",
        "ALTER TABLE runs ADD COLUMN turns INTEGER; UPDATE runs SET turns = id + 100;"
        "ALTER TABLE progress ADD COLUMN best REAL;"
        "INSERT INTO progress (runid, time, best) SELECT id, 0.5, id + 100 FROM runs;"
        "CREATE TABLE notes (run_key TEXT, note BLOB); INSERT INTO notes SELECT run_key, x'00ff' FROM runs");
    ASSERT_EQ(mrppsim({"merge", "all", "one", "two"}, scratch).code, 0);
    sqlite::Connection store(scratch.path() / "all/results.sqlite", sqlite::Connection::Mode::read);
    const auto number = [&store](const std::string &sql)
    {
        sqlite::Statement query(store, sql);
        return query.step() ? query.integer(0) : -1;
    };
    const std::int64_t extra = number("SELECT count(turns) FROM runs");
    EXPECT_GT(extra, 0);
    EXPECT_EQ(number("SELECT count(*) FROM runs JOIN progress ON runs.id = runid WHERE turns = best"), extra);
    EXPECT_EQ(number("SELECT count(*) FROM runs JOIN notes USING (run_key) WHERE note = x'00ff'"), extra);
    EXPECT_EQ(number("SELECT count(*) FROM runs"), 24);
    EXPECT_EQ(
        number("SELECT count(*) FROM runs JOIN experiments ON experiments.id = experimentid JOIN "
               "plannerConfigs ON plannerConfigs.id = plannerid WHERE planner = plannerConfigs.name AND "
               "\"case\" LIKE experiments.name || '/%'"),
        24);
    EXPECT_EQ(number("SELECT count(*) FROM experiments"), 4);
    EXPECT_EQ(number("SELECT count(*) FROM plannerConfigs"), 2);
}

} // namespace
} // namespace mrpp::test
