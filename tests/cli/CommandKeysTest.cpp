/// What a run by an outside program is known by: its values as the texts that they are, and the files that
/// its command names.

#include "framework/store/ResultStore.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

/// A planner that ends with the exit code 9, but for one value: then it has no answer.
std::string versionPlan(const std::string &value)
{
    return "campaign: keys\nproblems: [small_benchmark: tree]\nplanners:\n"
           "  - {command: \"sh -c 'test x$0 = x1.10 || exit 9' {v} {instance} {output}\", name: ver, set: "
           "{v: " +
           value + "}}\nreports: [csv]\n";
}

std::map<std::string, PlannerStatus> statuses(const Scratch &scratch)
{
    std::map<std::string, PlannerStatus> byPlanner;
    const auto rows = parseCsv(scratch.read("results/keys/results.csv"));
    const auto column = [&rows](const std::string &name)
    { return std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin(); };
    for (std::size_t i = 1; i < rows.size(); ++i)
        byPlanner[rows[i][column("planner")]] = *plannerStatus(rows[i][column("status")]);
    return byPlanner;
}

Outcome runPlan(const Scratch &scratch, const std::string &plan, const std::vector<std::string> &more = {})
{
    scratch.write("plan.yaml", plan);
    std::vector<std::string> words = {"run", "plan.yaml"};
    words.insert(words.end(), more.begin(), more.end());
    return mrppsim(words, scratch);
}

TEST(CommandKeys, tellTextsApartThatAreEqualNumbers)
{
    using enum PlannerStatus;
    const std::vector<std::pair<std::string, std::string>> pairs = {
        {"'1.1'", "'1.10'"}, {"'1000'", "'1e3'"},   {"'9007199254740992'", "'9007199254740993'"},
        {"'7'", "'007'"},    {"1.50", "1.5"},       {"'+5'", "'5'"},
        {"'0x10'", "'16'"},  {"'a b'", "\"a\\nb\""}};
    for (const auto &[before, after] : pairs)
    {
        const Scratch scratch;
        (void)runPlan(scratch, versionPlan(before));
        const std::string why = runPlan(scratch, versionPlan(after), {"--why"}).out;
        EXPECT_THAT(why, HasSubstr("1 run would be made")) << before << " and " << after;
        EXPECT_THAT(why, HasSubstr("changed: parameter v was '")) << before << " and " << after;
        EXPECT_THAT(runPlan(scratch, versionPlan(after)).out, HasSubstr("1 run (1 now, 0 before)"));
    }
    const Scratch scratch;
    (void)runPlan(scratch, versionPlan("'1.1'"));
    EXPECT_EQ(statuses(scratch).at("ver"), crash);
    EXPECT_THAT(runPlan(scratch, versionPlan("'1.10'"), {"--why"}).out,
                HasSubstr("parameter v was '1.1', is '1.10'"));
    (void)runPlan(scratch, versionPlan("'1.10'"));
    EXPECT_EQ(statuses(scratch).at("ver"), gave_up);
}

TEST(CommandKeys, keepResultsWithTheirValuesWhenAListIsReordered)
{
    using enum PlannerStatus;
    const Scratch scratch;
    (void)runPlan(scratch, versionPlan("['1.1', '1.10', 1.100]"));
    const std::map<std::string, PlannerStatus> right = {
        {"ver v=1.1", crash}, {"ver v=1.10", gave_up}, {"ver v=1.100", crash}};
    EXPECT_EQ(statuses(scratch), right);
    EXPECT_THAT(runPlan(scratch, versionPlan("[1.100, '1.10', '1.1']")).out,
                HasSubstr("3 runs (0 now, 3 before)"));
    EXPECT_EQ(statuses(scratch), right);
}

TEST(CommandKeys, ofPlannersThatAreBuiltInTakeNumbersAsNumbers)
{
    const Scratch scratch;
    const auto plan = [](const std::string &seconds)
    {
        return "campaign: keys\nproblems: [small_benchmark: tree]\nplanners: [{planner: push_and_swap, set: "
               "{restarts: " +
               seconds + "}}]\nreports: [csv]\n";
    };
    ASSERT_EQ(runPlan(scratch, plan("2")).code, 0);
    EXPECT_THAT(runPlan(scratch, plan("+2")).out, HasSubstr("1 run (0 now, 1 before)"));
}

class CommandFilesInKeys : public ::testing::TestWithParam<const char *>
{};

TEST_P(CommandFilesInKeys, runAgainWhenTheyChangeAndSoWhySays)
{
    const Scratch scratch;
    scratch.write("conf.txt", "0");
    scratch.write("other.txt", "0");
    const std::string plan =
        "campaign: keys\nproblems: [small_benchmark: tree]\nplanners:\n  - {command: \"sh "
        "-c 'exit 0' x {instance} " +
        std::string(GetParam()) + ", name: x}\nreports: [csv]\n";
    ASSERT_EQ(runPlan(scratch, plan).code, 0);
    EXPECT_THAT(runPlan(scratch, plan, {"--why"}).out, HasSubstr("0 runs would be made"));
    scratch.write("conf.txt", "1");
    EXPECT_THAT(runPlan(scratch, plan, {"--why"}).out, HasSubstr("changed: file conf.txt changed\n"));
    EXPECT_THAT(runPlan(scratch, plan).out, HasSubstr("1 run (1 now, 0 before)"));
    scratch.write("other.txt", "1");
    EXPECT_THAT(runPlan(scratch, plan).out, HasSubstr("1 run (0 now, 1 before)"));
}

INSTANTIATE_TEST_SUITE_P(EveryForm, CommandFilesInKeys,
                         ::testing::Values("conf.txt\"", "--config=conf.txt\"", "-fconf.txt\"",
                                           "x:conf.txt,y\"", "{config}\", set: {config: conf.txt}",
                                           "--c={config}\", set: {config: conf.txt}", "\", files: conf.txt",
                                           "\", files: [conf.txt]"));

TEST(CommandKeys, aFileOfThePlanMustBeThere)
{
    const Scratch scratch;
    const Outcome outcome =
        runPlan(scratch, "campaign: keys\nproblems: [small_benchmark: tree]\nplanners:\n  - {command: \"true "
                         "{instance}\", files: [gone.txt]}\nreports: [csv]\n");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("plan.yaml:4:15: planner 'true' depends on a file: "));
    EXPECT_THAT(outcome.err, HasSubstr("gone.txt: there is no such file"));
}

} // namespace
} // namespace mrpp::test
