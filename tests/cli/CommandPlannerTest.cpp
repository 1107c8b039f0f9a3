/// Outside programs as planners, most of them a line of shell.

#include "framework/store/ResultStore.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
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
        {"unsolved", {gave_up, "says that it found no solution"}},
        {"failing", {crash, "ended with exit code 7"}},
        {"refusing", {gave_up, "ended with exit code 8"}},
        {"liar", {invalid, "called a solvable instance infeasible"}},
        {"crashing", {crash, "killed by signal 11 (Segmentation fault)"}},
        {"other", {invalid, "its answer cannot be used: this is no kei18_result"}},
        {"hanging", {timeout, "did not end within 1 s after the time limit, and was killed"}},
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

/// What the plan's folder holds but for the results.
std::vector<std::string> namesIn(const Scratch &scratch)
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(scratch.path()))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(CommandPlanner, runsInAFolderOfItsOwnThatShowsThePlans)
{
    const Scratch scratch;
    prepare(scratch,
            "campaign: outside\nrepetitions: 6\nproblems: [public_benchmark: {map: yard.map, robots: 1}]\n"
            "planners:\n  - {command: \"./writes.sh {graph} {instance} {output}\", name: cwd}\n"
            "  - {command: \"sh -c 'cd {folder} && sh writes.sh $0 $1 $2' {graph} {instance} {output}\", "
            "name: told}\nreports: [csv]\n");
    // It calls a script beside it, and writes names that are always the same, one of which is there already.
    scratch.write("solve.sh",
                  std::string("exec ") + MRPP_PROGRAM +
                      " solve --graph $1 --instance $2 --planner push_and_swap --solution $3 >log.txt\n");
    scratch.write("writes.sh", "#!/bin/sh\nsh ./solve.sh $1 $2 result.csv; sleep 0.1; cp result.csv $3\n");
    std::filesystem::permissions(scratch.path() / "writes.sh", std::filesystem::perms::owner_all);
    scratch.write("result.csv", "from another time");
    auto names = namesIn(scratch);
    const Outcome outcome = mrppsim({"run", "plan.yaml", "--jobs", "2"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("12 runs (12 now, 0 before): solved 12\n"));
    EXPECT_EQ(scratch.read("result.csv"), "from another time");
    names.insert(std::find(names.begin(), names.end(), "solve.sh"), "results");
    EXPECT_EQ(namesIn(scratch), names);
    EXPECT_THAT(mrppsim({"run", "plan.yaml"}, scratch).out, HasSubstr("(0 now, 12 before)"));
}

TEST(CommandPlanner, readsFilesOfThePlansFolderHoweverTheyAreNamed)
{
    const Scratch scratch;
    scratch.write("beside/conf.txt", "0");
    const std::string reads = "sh -c 'test x$(cat ${1#*=}) = x0 || exit 9' x ";
    std::string planners;
    int number = 0;
    for (const char *word : {"conf.txt", "--c=conf.txt", "sub/conf.txt", "../beside/conf.txt",
                             "--c=../beside/conf.txt", "{plan_folder}/conf.txt"})
        planners += "  - {command: \"" + reads + word + " {instance} {output}\", name: r" +
                    std::to_string(number++) + "}\n";
    for (const char *file : {"plan/conf.txt", "plan/sub/conf.txt"})
        scratch.write(file, "0");
    scratch.write("plan/plan.yaml", "campaign: outside\nproblems: [small_benchmark: tree]\nplanners:\n" +
                                        planners + "reports: [csv]\n");
    ASSERT_EQ(mrppsim({"run", "plan/plan.yaml"}, scratch).code, 0);
    for (const auto &[planner, record] : records(scratch))
        EXPECT_EQ(record.reason, "wrote no answer") << planner;
}

TEST(CommandPlanner, isToldItsLimitInTheUnitsThatItTakes)
{
    const Scratch scratch;
    const std::string echo = "  - {command: \"sh -c 'echo $0 $1 $2 >&2; exit 7' {time_limit} {time_limit_s} "
                             "{time_limit_ms} {instance} {output}\", name: ";
    prepare(scratch,
            "campaign: outside\nlimits: {time: 2500 ms}\nproblems: [small_benchmark: tree]\nplanners:\n" +
                echo + "tenth}\n" + echo + "all, margin: 0 s}\n" + echo + "little, margin: 2400 ms}\n" +
                "reports: [csv]\n");
    ASSERT_NE(mrppsim({"run", "plan.yaml"}, scratch).code, 2);
    const auto told = [all = records(scratch)](const std::string &planner)
    {
        std::istringstream words(std::get<std::string>(all.at(planner).extra.at("error_output")));
        std::array<double, 3> numbers{};
        for (double &number : numbers)
            words >> number;
        return numbers;
    };
    for (const auto &[planner, most] :
         std::map<std::string, double>{{"tenth", 2.25}, {"all", 2.5}, {"little", 0.1}})
    {
        const auto [seconds, whole, milliseconds] = told(planner);
        EXPECT_LE(seconds, most) << planner;
        EXPECT_GT(seconds, most - 0.3) << planner;
        EXPECT_EQ(whole, std::max(1.0, std::floor(seconds))) << planner;
        EXPECT_EQ(std::round(seconds * 1000), milliseconds) << planner;
    }
}

TEST(CommandPlanner, thatStopsAtItsLimitIsATimeoutAndMayStillWrite)
{
    const Scratch scratch;
    const auto stops = [](const std::string &name, const std::string &then, const std::string &rest = "")
    {
        return "  - {command: \"sh -c 'sleep $0; " + then +
               "' {time_limit} {instance} {output}\", name: " + name + rest + "}\n";
    };
    std::string text =
        plan(stops("writes", "cp answer.csv $2") + stops("late", "sleep 0.4; cp answer.csv $2") +
             stops("silent", "true") + stops("says", "echo solved=0 >$2; echo solution= >>$2") +
             stops("code", "exit 9", ", exit_codes: {9: gave_up}") + stops("crash", "exit 9") +
             script("early", "exit 0"));
    text.replace(text.find("time: 1 s"), std::string("time: 1 s").size(), "time: 2 s");
    prepare(scratch, text);
    ASSERT_EQ(mrppsim({"solve", "--graph", "yard.map", "--instance", "yard.scen", "--planner",
                       "push_and_swap", "--solution", "answer.csv"},
                      scratch)
                  .code,
              0);
    ASSERT_NE(mrppsim({"run", "plan.yaml"}, scratch).code, 2);
    auto all = records(scratch);
    using enum PlannerStatus;
    EXPECT_EQ(all.at("writes").status, solved) << all.at("writes").reason;
    EXPECT_EQ(all.at("late").status, solved) << all.at("late").reason;
    EXPECT_EQ(all.at("silent").status, timeout);
    EXPECT_THAT(all.at("silent").reason, StartsWith("wrote no answer at its limit of 1."));
    EXPECT_EQ(all.at("says").status, timeout);
    EXPECT_THAT(all.at("says").reason, StartsWith("says that it found no solution at its limit of 1."));
    EXPECT_EQ(all.at("code").status, timeout);
    EXPECT_EQ(all.at("crash").status, crash);
    EXPECT_THAT(all.at("crash").reason, StartsWith("ended with exit code 9 at its limit of 1."));
    EXPECT_EQ(all.at("early").status, gave_up);
}

TEST(CommandPlanner, keepsTheEndsOfBothStreams)
{
    const Scratch scratch;
    const std::string solve =
        std::string(MRPP_PROGRAM) + " solve --planner push_and_swap --instance $1 --solution $2 >/dev/null";
    scratch.write("much.sh", "head -c 300000 /dev/zero | tr '\\0' x; echo end");
    for (const char *isolation : {"process", "none"})
    {
        prepare(scratch, plan(script("both", "echo file not found; echo usage >&2; exit 3") +
                              "  - {command: \"sh much.sh {instance} {output}\", name: much}\n" +
                              script("solved", "echo fine; " + solve) +
                              "  - {command: \"sh -c 'echo no such map' {instance}\", name: answer}\n") +
                             "execution: {isolation: " + isolation +
                             "}\nseed: " + (isolation == std::string("none") ? "2" : "1") + "\n");
        const Outcome outcome = mrppsim({"run", "plan.yaml"}, scratch);
        ASSERT_NE(outcome.code, 2) << outcome.err;
        auto all = records(scratch);
        const auto said = [&all](const std::string &planner, const std::string &column)
        {
            const auto &extra = all.at(planner).extra;
            return extra.contains(column) ? std::get<std::string>(extra.at(column)) : "";
        };
        EXPECT_EQ(said("both", "standard_output"), "file not found\n") << isolation;
        EXPECT_EQ(said("both", "error_output"), "usage\n") << isolation;
        EXPECT_THAT(said("much", "standard_output"), ::testing::EndsWith("xxxend\n"));
        EXPECT_EQ(said("much", "standard_output").size(), 2048U);
        EXPECT_EQ(said("solved", "standard_output"), "");
        EXPECT_EQ(said("answer", "standard_output"), "no such map\n");
    }
}

TEST(CommandPlanner, whatItSaysIsTextWhateverItIs)
{
    const Scratch scratch;
    scratch.write("bad.sh", "printf 'bad \\377\\376 nul:\\000: esc:\\033[31m cr\\r del\\177' >&2\n"
                            "printf '\\000\\001\\377' >$2\n");
    prepare(scratch, plan("  - {command: \"sh bad.sh {instance} {output}\", name: bad}\n") +
                         "reports: [csv, html, markdown]\n");
    std::string text = scratch.read("plan.yaml");
    text.erase(text.find("reports: [csv]\n"), std::string("reports: [csv]\n").size());
    scratch.write("plan.yaml", text);
    ASSERT_NE(mrppsim({"run", "plan.yaml"}, scratch).code, 2);
    const RunRecord bad = records(scratch).at("bad");
    EXPECT_EQ(std::get<std::string>(bad.extra.at("error_output")),
              "bad \uFFFD\uFFFD nul:\\x00: esc:\\x1B[31m cr\\x0D del\\x7F");
    for (const auto &[name, contents] : scratch.tree("results/outside"))
        if (name.ends_with(".csv") || name.ends_with(".md"))
        {
            EXPECT_EQ(contents.find_first_of(std::string("\0\x1B\x7F\r\x01", 5)), std::string::npos) << name;
            EXPECT_EQ(contents.find('\xFF'), std::string::npos) << name;
        }
}

} // namespace
} // namespace mrpp::test
