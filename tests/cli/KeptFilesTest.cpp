/// solutions/ and instances/ are those of the plan as it is, whatever it was.

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::Contains;
using ::testing::Key;
using ::testing::Not;

std::string plan(const std::string &given, const std::string &random,
                 const std::string &problems = "[connector]",
                 const std::string &keep = "{solutions: true, instances: true}")
{
    return "campaign: kept\nproblems:\n  - small_benchmark: " + problems +
           "\nplanners:\n  - {planner: push_and_swap, name: " + given +
           ", set: {order: given}}\n  - {planner: push_and_swap, name: " + random +
           ", set: {order: random}}\nkeep: " + keep + "\nreports: [csv]\n";
}

void run(const Scratch &scratch, const std::string &plan, const std::string &folder)
{
    scratch.write("plan.yaml", plan);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", folder}, scratch).code, 0);
}

void expectSame(const Scratch &scratch)
{
    EXPECT_EQ(scratch.tree("old/solutions"), scratch.tree("new/solutions"));
    EXPECT_EQ(scratch.tree("old/instances"), scratch.tree("new/instances"));
}

TEST(KeptFiles, followNamesThatAreExchanged)
{
    const Scratch scratch;
    run(scratch, plan("A", "B"), "old");
    const auto before = scratch.tree("old/solutions");
    ASSERT_EQ(before.size(), 2U);
    run(scratch, plan("B", "A"), "old");
    run(scratch, plan("B", "A"), "new");
    expectSame(scratch);
    EXPECT_EQ(scratch.tree("old/solutions").at("small_benchmark/connector/0.B.csv"),
              before.at("small_benchmark/connector/0.A.csv"));
}

TEST(KeptFiles, ofNamesThatAreGoneAreRemovedAndNothingElse)
{
    const Scratch scratch;
    run(scratch, plan("A", "B", "[connector, tree]"), "old");
    scratch.write("old/solutions/mine.csv", "mine");
    run(scratch, plan("A", "C"), "old");
    EXPECT_EQ(scratch.read("old/solutions/mine.csv"), "mine");
    std::filesystem::remove(scratch.path() / "old/solutions/mine.csv");
    run(scratch, plan("A", "C"), "new");
    expectSame(scratch);
    EXPECT_THAT(scratch.tree("old/instances"), Not(Contains(Key("small_benchmark/tree/0.graphml"))));
    run(scratch, plan("A", "C", "[connector, tree]"), "old");
    run(scratch, plan("A", "C", "[connector, tree]"), "new");
    expectSame(scratch);
}

TEST(KeptFiles, areWrittenForRunsThatWereThereBeforeThePlanAskedForThem)
{
    const Scratch scratch;
    run(scratch, plan("A", "B", "[connector]", "{solutions: false}"), "old");
    EXPECT_FALSE(scratch.has("old/solutions"));
    run(scratch, plan("A", "B"), "old");
    run(scratch, plan("A", "B"), "new");
    expectSame(scratch);
}

TEST(KeptFiles, ofACampaignOfBeforeThereWasAListAreTakenOver)
{
    const Scratch scratch;
    run(scratch, plan("A", "B"), "old");
    std::filesystem::remove(scratch.path() / "old/kept-files.csv");
    run(scratch, plan("C", "A"), "old");
    run(scratch, plan("C", "A"), "new");
    expectSame(scratch);
}

TEST(KeptFiles, comeBackWhenTheyWereDeleted)
{
    const Scratch scratch;
    run(scratch, plan("A", "B"), "new");
    run(scratch, plan("A", "B"), "old");
    std::filesystem::remove_all(scratch.path() / "old/solutions");
    std::filesystem::remove_all(scratch.path() / "old/instances");
    run(scratch, plan("A", "B"), "old");
    expectSame(scratch);
}

} // namespace
} // namespace mrpp::test
