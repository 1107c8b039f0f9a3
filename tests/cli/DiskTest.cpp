/// \file
/// Folders that fill up and folders that cannot be written.

#include "tests/cli/Comparison.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

/// Runs a script in a mount namespace of its own. Only some users may.
Outcome privately(const std::string &script, const Scratch &scratch)
{
    Process process({"unshare", "-m", "sh", "-c", script}, scratch);
    return process.wait();
}

TEST(Disk, aFullOneLosesNothingAndTheSameCommandGoesOn)
{
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "small");
    const std::string mount = "mount -t tmpfs -o size=600k none small 2>/dev/null";
    if (privately(mount, scratch).code != 0)
        GTEST_SKIP() << "this user may mount nothing";
    scratch.write("plan.yaml",
                  "problems: [small_benchmark: [tree, corners]]\nplanners: [push_and_swap, tass]\n"
                  "repetitions: 300\nreports: [csv]\n");
    const std::string run = std::string(MRPP_PROGRAM) + " run plan.yaml -q -o ";
    const Outcome outcome =
        privately(mount + " && " + run + "small; echo code $?; mount -o remount,size=60m small && " + run +
                      "small; echo code $?; cp -r small full",
                  scratch);
    EXPECT_THAT(outcome.out, HasSubstr("code 2\n"));
    EXPECT_THAT(outcome.err, HasSubstr("the disk is full: make room and run the same command again"));
    EXPECT_THAT(outcome.out, HasSubstr("code 0\n"));
    EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("(1200 now, 0 before)"))); // what was kept was kept
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-q", "-o", "whole"}, scratch).code, 0);
    EXPECT_EQ(lastingResults(scratch, "full"), lastingResults(scratch, "whole"));
}

TEST(Disk, aFolderThatCannotBeWrittenIsRefused)
{
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "sealed");
    scratch.write("plan.yaml",
                  "problems: [small_benchmark: tree]\nplanners: [push_and_swap]\nreports: [csv]\n");
    const Outcome outcome = privately("mount -t tmpfs -o ro none sealed 2>/dev/null || exit 99; " +
                                          std::string(MRPP_PROGRAM) + " run plan.yaml -q -o sealed",
                                      scratch);
    if (outcome.code == 99)
        GTEST_SKIP() << "this user may mount nothing";
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("sealed: the folder cannot be written: Read-only file system"));
}

TEST(Disk, aPoorFileSystemStillKeepsACampaign)
{
    const std::vector<std::pair<std::string, std::string>> lacking = {
        {"maps",
         "note: out: this file system has no shared memory: results are kept with a rollback journal"},
        {"locks", "note: out: this file system has no locks: run one campaign in it at a time"},
        {"locks maps", "note: out: this file system has no locks"},
        {"chmod", ""}};
    for (const auto &[lack, note] : lacking)
    {
        SCOPED_TRACE(lack);
        const Scratch scratch;
        const std::string rest = "problems: [small_benchmark: [tree, corners]]\nplanners: [push_and_swap]\n"
                                 "reports: [csv]\n";
        const auto poorly = [&](const std::vector<std::string> &words)
        {
            std::vector<std::string> all = {"env", "LD_PRELOAD=" MRPP_POOR_FILE_SYSTEM, "MRPP_POOR=" + lack,
                                            MRPP_PROGRAM};
            all.insert(all.end(), words.begin(), words.end());
            return Process(all, scratch).wait();
        };
        scratch.write("plan.yaml", rest);
        // What a richer system left behind, in its own mode, is gone on with.
        ASSERT_EQ(mrppsim({"run", "plan.yaml", "-q", "-o", "out", "--shard", "1/2"}, scratch).code, 0);
        const Outcome outcome = poorly({"run", "plan.yaml", "-q", "-o", "out"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(note));
        EXPECT_EQ(parseCsv(scratch.read("out/results.csv")).size(), 3U);
        const Outcome again = poorly({"run", "plan.yaml", "-q", "-o", "out"});
        EXPECT_THAT(again.out, HasSubstr("2 runs (0 now, 2 before)")) << again.err;
        const Outcome report = poorly({"report", "out"});
        EXPECT_EQ(report.code, 0) << report.err;
    }
}

TEST(Why, saysWhichPartOfThePlanChanged)
{
    const Scratch scratch;
    const std::string rest = "problems: [small_benchmark: tree]\nplanners: [push_and_swap]\nreports: [csv]\n";
    scratch.write("plan.yaml", rest + "limits: {time: 20 s}\n");
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "--why"}, scratch).out,
              "small_benchmark/tree/0 by push_and_swap: new: the folder holds no campaign yet\n"
              "1 run would be made in results/plan\n");
    ASSERT_EQ(mrppsim({"run", "plan.yaml"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "--why"}, scratch).out, "0 runs would be made in results/plan\n");
    scratch.write("plan.yaml", rest + "limits: {time: 20 s, cpu: 5 s}\nexecution: {timing_repeats: 2}\n");
    EXPECT_THAT(mrppsim({"run", "plan.yaml", "--why"}, scratch).out,
                HasSubstr("changed: CPU limit was 'none', is '5'; timing repeats was '1', is '2'\n"));
    ASSERT_EQ(mrppsim({"run", "plan.yaml"}, scratch).code, 0);
    const auto rows = parseCsv(scratch.read("results/plan/results.csv"));
    const auto cell = [&rows](const std::string &name)
    {
        return rows[1][static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) -
                                                rows[0].begin())];
    };
    EXPECT_EQ(cell("timed"), "2");
    EXPECT_EQ(cell("repeatable"), "yes");
}

TEST(Why, speaksOfOnePartWhereAskedTo)
{
    const Scratch scratch;
    scratch.write("plan.yaml", "problems: [small_benchmark: [tree, corners, string]]\nrepetitions: 4\n"
                               "planners: [push_and_swap]\nreports: [csv]\n");
    const auto why = [&](const std::string &shard) {
        return mrppsim({"run", "plan.yaml", "--why", "--shard", shard}, scratch).out;
    };
    const std::string first = why("1/2");
    const std::string second = why("2/2");
    const auto lines = [](const std::string &text) { return std::count(text.begin(), text.end(), '\n') - 1; };
    EXPECT_EQ(lines(first) + lines(second), 12);
    EXPECT_GT(lines(first), 0);
    EXPECT_GT(lines(second), 0);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "--shard", "1/2"}, scratch).code, 0);
    EXPECT_EQ(why("1/2"), "0 runs would be made in results/plan\n");
    EXPECT_EQ(lines(why("2/2")), lines(second));
}

} // namespace

} // namespace mrpp::test
