#include "framework/campaign/Sqlite.h"
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
    EXPECT_THAT(worse.out, HasSubstr("time 3.000 times as large"));
    EXPECT_TRUE(scratch.has("comparison/comparison.pdf"));
    EXPECT_TRUE(scratch.has("comparison/comparison.csv"));
    const Outcome better = mrppsim({"compare", "now", "before"}, scratch);
    EXPECT_EQ(better.code, 0);
    EXPECT_THAT(better.out, HasSubstr("improvement: "));
}

TEST(Compare, needsTwoCampaigns)
{
    const Scratch scratch;
    EXPECT_EQ(mrppsim({"compare", "nothing", "here"}, scratch).code, 2);
}

} // namespace

} // namespace mrpp::test
