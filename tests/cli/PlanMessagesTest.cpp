/// What is wrong with a plan, or with a file that it names, is said at the plan's place.

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class PlanMessages : public ::testing::Test
{
protected:
    PlanMessages()
    {
        scratch_.write("yard.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
        scratch_.write("yard.scen", "version 1\n0\tyard.map\t4\t3\t0\t0\t3\t0\t3\n");
        scratch_.write("broken.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@\n....\n");
    }

    [[nodiscard]] Outcome run(const std::string &problem, const std::string &planner = "push_and_swap",
                              const std::vector<std::string> &more = {}) const
    {
        scratch_.write("plan.yaml", "campaign: messages\nproblems:\n  - " + problem + "\nplanners:\n  - " +
                                        planner + "\nreports: [csv]\n");
        std::vector<std::string> words = {"run", "plan.yaml"};
        words.insert(words.end(), more.begin(), more.end());
        return mrppsim(words, scratch_);
    }

    void expectComplaint(const Outcome &outcome, const ::testing::Matcher<std::string> &matcher) const
    {
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, matcher);
        EXPECT_FALSE(scratch_.has("results"));
    }

    Scratch scratch_;
};

TEST_F(PlanMessages, ofAMissingMapSayWhereItIsLookedForAndWhoPublishesIt)
{
    expectComplaint(run("public_benchmark: {map: den312d.map, robots: 3}"),
                    AllOf(StartsWith("plan.yaml:3:29: problem 'den312d': den312d.map: there is no such map"),
                          HasSubstr("https://movingai.com/benchmarks/"), HasSubstr("'maps:'"),
                          HasSubstr("--maps (there are none)")));
    std::filesystem::create_directory(scratch_.path() / "other");
    expectComplaint(run("public_benchmark: {map: [yard.map, den312d.map], robots: 3}", "push_and_swap",
                        {"--maps", "other"}),
                    AllOf(StartsWith("plan.yaml:3:40: problem 'den312d'"), HasSubstr("--maps (other)")));
}

TEST_F(PlanMessages, ofOtherMissingFilesNameThemAndTheProblem)
{
    expectComplaint(run("public_benchmark: {map: yard.map, scenario: gone.scen}"),
                    AllOf(StartsWith("plan.yaml:3:49: problem 'yard"),
                          HasSubstr("gone.scen: there is no such scenario"),
                          HasSubstr("https://movingai.com/benchmarks/")));
    expectComplaint(run("fully_controlled: {instance: gone.instance}"),
                    AllOf(StartsWith("plan.yaml:3:34: problem 'gone'"), HasSubstr("there is no such file"),
                          HasSubstr("'maps:'")));
}

TEST_F(PlanMessages, ofTooManyRobotsNameTheLineAndTheProblem)
{
    expectComplaint(
        run("public_benchmark: {map: yard.map, robots: 11}"),
        StartsWith("plan.yaml:3:47: problem 'yard': robots = 11 does not fit a graph of 10 vertices"));
    expectComplaint(run("public_benchmark: {map: yard.map, robots: [3, 11]}"),
                    StartsWith("plan.yaml:3:51: problem 'yard': robots = 11 does not fit"));
    expectComplaint(run("public_benchmark: {map: yard.map, free: 12}"),
                    StartsWith("plan.yaml:3:45: problem 'yard': free = 12 does not fit"));
    expectComplaint(run("public_benchmark: {map: yard.map, scenario: yard.scen, robots: 2}"),
                    AllOf(StartsWith("plan.yaml:3:"), HasSubstr("problem 'yard"), HasSubstr("yard.scen")));
    expectComplaint(run("grid: {side: 3, robots: 12}"),
                    AllOf(StartsWith("plan.yaml:3:29: problem 'grid"), HasSubstr("does not fit")));
}

TEST_F(PlanMessages, ofBrokenFilesKeepTheirLinesAndNameTheProblem)
{
    expectComplaint(run("public_benchmark: {map: broken.map, robots: 3}"),
                    AllOf(StartsWith("broken.map:6:"), HasSubstr("(problem 'broken', plan.yaml:3:")));
}

TEST_F(PlanMessages, ofCommandsSayWhichPlaceWasMeant)
{
    const std::string problem = "small_benchmark: tree";
    expectComplaint(
        run(problem, "{command: \"true {instance} {Output}\"}"),
        StartsWith("plan.yaml:5:15: there is no place {Output}; did you mean 'output'?; the text itself is "
                   "written {{Output}}"));
    expectComplaint(run(problem, "{command: \"true {instance} {time-limit}\"}"),
                    StartsWith("plan.yaml:5:15: there is no place {time-limit}; did you mean 'time_limit'?"));
    expectComplaint(run(problem, "{command: \"true {instance} '{ seed }'\"}"),
                    StartsWith("plan.yaml:5:15: there is no place { seed }; did you mean 'seed'?"));
    expectComplaint(run(problem, "{command: \"true {instance} {weigth}\", set: {weight: 2}}"),
                    HasSubstr("{weight}"));
    expectComplaint(run(problem, "{command: \"true {instance}\", exit_codes: {1: gave_up, 01: infeasible}}"),
                    StartsWith("plan.yaml:5:59: the exit code 1 stands here a second time"));
    EXPECT_EQ(run(problem, "{command: \"true {instance} {{Output}} {{output}} ${HOME} '{print $1}'\"}").code,
              0);
}

TEST_F(PlanMessages, refuseControlCharactersAndNamesOfSeveralLines)
{
    const std::string problem = "small_benchmark: tree";
    expectComplaint(run(problem, "{planner: push_and_swap, name: \"nul\\0\"}"),
                    StartsWith("plan.yaml:5:36: this text holds a control character (\\x00)"));
    expectComplaint(run(problem, "{planner: push_and_swap, name: \"esc\\e[31m\"}"), HasSubstr("(\\x1B)"));
    expectComplaint(run(problem, "{planner: push_and_swap, name: \"\\u202Ertl\"}"), HasSubstr("(\\u202E)"));
    expectComplaint(run(problem, "{planner: push_and_swap, name: \"a\\nb\"}"),
                    HasSubstr("a name has one line"));
    expectComplaint(run("public_benchmark: {map: \"a\\x01.map\", robots: 2}"), HasSubstr("(\\x01)"));
    EXPECT_EQ(run(problem, "{planner: push_and_swap, name: \"größer 😀 'q' <b>\"}").code, 0);
}

} // namespace
} // namespace mrpp::test
