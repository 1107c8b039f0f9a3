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

void change(const Scratch &scratch, const std::string &folder, const std::string &sql)
{
    sqlite::Connection store(scratch.path() / folder / "results.sqlite", sqlite::Connection::Mode::write);
    store.run(sql);
}

/// The same campaign twice, in "before" and "now".
void runTwice(const Scratch &scratch)
{
    prepareCampaign(scratch, 3);
    for (const char *folder : {"before", "now"})
    {
        const Outcome outcome = mrppsim({"run", "plan.yaml", "-o", folder, "--no-report", "-q"}, scratch);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        change(scratch, folder, "UPDATE runs SET time = 0.01 + id * 0.0001, path_length = 100 + id");
    }
}

TEST(Compare, ofTheSameFindsNothing)
{
    const Scratch scratch;
    runTwice(scratch);
    const Outcome outcome = mrppsim({"compare", "before", "now"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("24 pairs of runs, 0 only before, 0 only now"));
    EXPECT_THAT(outcome.out, HasSubstr("no regression beyond chance"));
}

TEST(Compare, endsWithOneWhereSomethingBecameWorse)
{
    const Scratch scratch;
    runTwice(scratch);
    change(scratch, "now", "UPDATE runs SET time = time * 3");
    const Outcome worse = mrppsim({"compare", "before", "now", "-o", "comparison"}, scratch);
    EXPECT_EQ(worse.code, 1) << worse.err;
    EXPECT_THAT(worse.out, HasSubstr("regression: "));
    EXPECT_THAT(worse.out, HasSubstr("time 3.00 times as large"));
    EXPECT_TRUE(scratch.has("comparison/comparison.pdf"));
    EXPECT_TRUE(scratch.has("comparison/comparison.csv"));
    const Outcome better = mrppsim({"compare", "now", "before"}, scratch);
    EXPECT_EQ(better.code, 0);
    EXPECT_THAT(better.out, HasSubstr("improvement: "));
}

TEST(Compare, namesWhatDiffersBeforeItTests)
{
    const Scratch scratch;
    prepareCampaign(scratch, 1);
    std::string other = campaignPlan(1);
    other.replace(other.find("20 s"), 4, "15 s");
    other.replace(other.find("order: random"), 13, "order: given");
    scratch.write("other.yaml", other);
    for (const auto &[plan, folder] : {std::pair("plan.yaml", "before"), std::pair("other.yaml", "now")})
        ASSERT_EQ(mrppsim({"run", plan, "-o", folder, "--no-report", "-q"}, scratch).code, 0);
    const Outcome outcome = mrppsim({"compare", "before", "now"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(
        outcome.out.starts_with("differs: time limit: 20 before, 15 now\n"
                                "differs: parameter order: random before, given now (another order)\n"))
        << outcome.out;
}

TEST(Compare, countsCopiesOfAnInstanceOnce)
{
    const Scratch scratch;
    scratch.write("copies.yaml", "campaign: copies\nrepetitions: 20\nproblems: [small_benchmark: tunnel]\n"
                                 "planners: [push_and_rotate]\n");
    for (const char *folder : {"before", "now"})
        ASSERT_EQ(mrppsim({"run", "copies.yaml", "-o", folder, "--no-report", "-q"}, scratch).code, 0);
    change(scratch, "now", "UPDATE runs SET time = time * 3 + 1, path_length = path_length + 5");
    const Outcome outcome = mrppsim({"compare", "before", "now"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_THAT(outcome.out,
                HasSubstr("1 pairs are tested: repetitions that are copies of one instance count once"));
    EXPECT_THAT(outcome.out, HasSubstr("no regression beyond chance"));
}

TEST(Compare, callsLostSolutionsARegression)
{
    const Scratch scratch;
    runTwice(scratch);
    // All solved near the limit before, and timed out now.
    change(scratch, "before", "UPDATE runs SET time = 19");
    change(scratch, "now", "UPDATE runs SET status = 4, solved = 0, time = 20");
    const Outcome outcome = mrppsim({"compare", "before", "now"}, scratch);
    EXPECT_EQ(outcome.code, 1) << outcome.out;
    EXPECT_THAT(outcome.out, HasSubstr("24 flapping timeouts"));
    EXPECT_THAT(outcome.out, HasSubstr("24 runs were solved or proved before alone, 0 now alone"));
    EXPECT_THAT(
        outcome.out,
        HasSubstr("regression: push_and_swap (pebble) on everything: 8 instances solved before alone"));
}

TEST(Compare, needsTwoCampaigns)
{
    const Scratch scratch;
    EXPECT_EQ(mrppsim({"compare", "nothing", "here"}, scratch).code, 2);
}

} // namespace

} // namespace mrpp::test
