/// Outside programs as planners, most of them a line of shell.

#include "framework/campaign/ResultStore.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <sstream>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A yard of cells in which two robots pass each other, and planners of it.
std::string plan(const std::string &planners,
                 const std::string &problem = "public_benchmark: {map: yard.map, "
                                              "scenario: yard.scen, robots: 2}")
{
    return "campaign: outside\nlimits: {time: 1 s}\nproblems: [" + problem + "]\nplanners:\n" + planners +
           "reports: [csv]\n";
}

/// A planner that runs that script with instance and answer as $1 and $2.
std::string script(const std::string &name, const std::string &text, const std::string &rest = "")
{
    return "  - {command: \"sh -c '" + text + "' sh {instance} {output}\", name: " + name + rest + "}\n";
}

void prepare(const Scratch &scratch, const std::string &text)
{
    scratch.write("yard.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
    scratch.write("yard.scen",
                  "version 1\n0\tyard.map\t4\t3\t0\t0\t3\t0\t3\n0\tyard.map\t4\t3\t3\t0\t0\t0\t3\n");
    scratch.write("plan.yaml", text);
}

/// Of each planner the run with the most robots, in whatever order they were made.
std::map<std::string, RunRecord> records(const Scratch &scratch)
{
    std::map<std::string, RunRecord> byPlanner;
    for (RunRecord &record :
         ResultStore(scratch.path() / "results/outside", ResultStore::Access::read).records())
        if (RunRecord &kept = byPlanner[record.planner]; record.robots >= kept.robots)
            kept = std::move(record);
    return byPlanner;
}

/// The program itself, as if it were somebody else's.
std::string ownSolver(const std::string &more, const std::string &rest)
{
    return std::string("  - {command: \"") + MRPP_PROGRAM +
           " solve --planner push_and_swap --optimizer none " + more + "\"" + rest + "}\n";
}

TEST(CommandPlanner, givesTheSameResultsAsTheSamePlannerInside)
{
    const Scratch scratch;
    prepare(
        scratch,
        plan("  - push_and_swap\n" +
                 ownSolver("--graph {graph} --instance {instance} --solution {output} --seed {seed} "
                           "--time-limit {time_limit} --robots {robots} --set order={order}",
                           ", name: files, format: solution, motion: pebble, set: {order: [given, random]}") +
                 ownSolver("--graph {map} --instance {scen} --schedule {output}",
                           ", name: cells, motion: following") +
                 std::string("  - {command: \"sh -c '") + MRPP_PROGRAM +
                 " solve --planner push_and_swap --instance $1 --graph $2 --solution $1.csv > $1.log; "
                 "cat $1.csv' sh {instance} {map}\", name: said, instance_format: kei18_instance}\n",
             "public_benchmark: {map: yard.map, scenario: yard.scen, robots: [1, 2]}"));
    const Outcome outcome = mrppsim({"run", "plan.yaml", "--jobs", "2"}, scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    auto all = records(scratch);
    ASSERT_EQ(all.size(), 5U);
    const RunRecord &inside = all.at("push_and_swap");
    for (const char *name : {"files order=given", "files order=random", "cells", "said"})
    {
        EXPECT_EQ(all.at(name).status, PlannerStatus::solved) << name << ": " << all.at(name).reason;
        EXPECT_GT(all.at(name).time.value_or(0), 0);
        EXPECT_EQ(all.at(name).pathLength.has_value(), inside.pathLength.has_value());
    }
    EXPECT_EQ(all.at("cells").pathLength, inside.pathLength);
    EXPECT_EQ(all.at("cells").makespan, inside.makespan);
}

TEST(CommandPlanner, whateverHappensIsRecordedAsWhatItIs)
{
    const Scratch scratch;
    const std::string jump = "printf \\\"step,robot,from,to\\\\n0,0,0,2\\\\n\\\" > $2";
    prepare(scratch,
            plan(script("garbage", "echo hello > $2") + script("noise", "head -c 100000 /dev/urandom > $2") +
                 script("half", "printf \\\"step,robot,from,to\\\\n\\\" > $2") + script("jump", jump) +
                 script("silent", "true") + script("unsolved", "echo solved=0 > $2; echo solution= >> $2") +
                 script("failing", "echo last words >&2; exit 7") +
                 script("refusing", "exit 8", ", exit_codes: {8: gave_up}") +
                 script("liar", "exit 9", ", exit_codes: {9: infeasible}") +
                 script("crashing", "kill -SEGV $$") + script("other", "echo hello > $2", ", format: kei18") +
                 script("hanging", "sleep 4321.5 & sleep 4321.5; true")));
    const Outcome outcome = mrppsim({"run", "plan.yaml", "--jobs", "2"}, scratch);
    EXPECT_EQ(outcome.code, 3) << outcome.err; // invalid answers
    auto all = records(scratch);
    using enum PlannerStatus;
    const std::map<std::string, std::pair<PlannerStatus, std::string>> expected = {
        {"garbage", {invalid, "its answer cannot be used: "}},
        {"noise", {invalid, "its answer cannot be used: "}},
        {"half", {invalid, "robot 0"}},
        {"jump", {invalid, "its answer cannot be used: line 2: step 0: "}},
        {"silent", {gave_up, "wrote no answer"}},
        {"unsolved", {gave_up, "says that it has no solution"}},
        {"failing", {crash, "ended with exit code 7"}},
        {"refusing", {gave_up, "ended with exit code 8"}},
        {"liar", {invalid, "called a solvable instance infeasible"}},
        {"crashing", {crash, "killed by signal 11 (Segmentation fault)"}},
        {"other", {invalid, "its answer cannot be used: this is no kei18_result"}},
        {"hanging", {timeout, ""}},
    };
    ASSERT_EQ(all.size(), expected.size());
    for (const auto &[planner, end] : expected)
    {
        EXPECT_EQ(all.at(planner).status, end.first) << planner << ": " << all.at(planner).reason;
        EXPECT_THAT(all.at(planner).reason, StartsWith(end.second)) << planner;
    }
    EXPECT_EQ(std::get<std::string>(all.at("failing").extra.at("error_output")), "last words\n");
    EXPECT_GT(all.at("hanging").time.value(), 0.99);

    for (const auto &entry : std::filesystem::directory_iterator("/proc"))
    {
        std::ifstream file(entry.path() / "cmdline");
        std::stringstream line;
        line << file.rdbuf();
        EXPECT_THAT(line.str(), ::testing::Not(HasSubstr("4321.5"))) << entry.path();
    }
}

TEST(CommandPlanner, isUnsupportedWhereItCannotBeToldTheInstance)
{
    const Scratch scratch;
    prepare(scratch,
            plan("  - {command: \"false {map} {scen}\", name: cells}\n"
                 "  - {command: \"false {instance}\", name: rotating, motion: rotation}\nmotion: pebble\n",
                 "small_benchmark: biconnected"));
    ASSERT_EQ(mrppsim({"run", "plan.yaml"}, scratch).code, 0);
    const auto all = records(scratch);
    EXPECT_EQ(all.at("cells").status, PlannerStatus::unsupported);
    EXPECT_EQ(all.at("rotating").status, PlannerStatus::unsupported);
}

TEST(CommandPlanner, aMissingProgramIsAnErrorBeforeAnythingRuns)
{
    const Scratch scratch;
    for (const auto &[command, complaint] : std::map<std::string, std::string>{
             {"no-such-solver {instance}", "plan.yaml:5:15: there is no program 'no-such-solver' in PATH"},
             {"./solver.py {instance}",
              "plan.yaml:5:15: there is no program './solver.py'; its path starts at"},
             {"./yard.map {instance}", "plan.yaml:5:15: './yard.map' is no executable file"}})
    {
        prepare(scratch, plan("  - {command: \"" + command + "\", name: x}\n  - push_and_swap\n"));
        const Outcome outcome = mrppsim({"run", "plan.yaml"}, scratch);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, StartsWith(complaint));
        EXPECT_FALSE(scratch.has("results"));
    }
}

TEST(CommandPlanner, runsAgainWhenItsScriptHasChanged)
{
    const Scratch scratch;
    prepare(scratch, plan("  - {command: \"sh solver.sh {instance}\", name: x}\n  - push_and_swap\n"));
    scratch.write("solver.sh", "exit 0\n");
    ASSERT_EQ(mrppsim({"run", "plan.yaml"}, scratch).code, 0);
    EXPECT_THAT(mrppsim({"run", "plan.yaml"}, scratch).out, HasSubstr("2 runs (0 now, 2 before)"));
    scratch.write("solver.sh", "echo hello\n");
    EXPECT_THAT(mrppsim({"run", "plan.yaml"}, scratch).out, HasSubstr("2 runs (1 now, 1 before)"));

    // Neither a report nor a look at the plan needs the program.
    std::filesystem::remove(scratch.path() / "solver.sh");
    EXPECT_EQ(mrppsim({"report", "results/outside"}, scratch).code, 0);
    EXPECT_EQ(parseCsv(scratch.read("results/outside/results.csv")).size(), 3U);
}

} // namespace
} // namespace mrpp::test
