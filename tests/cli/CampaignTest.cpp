#include "tests/cli/Comparison.h"
#include "tests/cli/Program.h"
#include "tests/reports/EnvironmentVariable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <set>
#include <thread>

namespace mrpp::test
{

namespace
{

using mrpp::testing::EnvironmentVariable;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Waits until the campaign has kept that many solutions.
void awaitSolutions(const Scratch &scratch, const std::string &folder, std::size_t count)
{
    for (int i = 0; i < 3000; ++i)
    {
        std::size_t files = 0;
        std::error_code error;
        for (const auto &entry :
             std::filesystem::recursive_directory_iterator(scratch.path() / folder / "solutions", error))
            files += entry.path().extension() == ".csv" ? 1 : 0;
        if (files >= count)
            return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL() << "the campaign did not begin";
}

TEST(Campaign, findsItsMapsWhereItIsTold)
{
    const Scratch scratch;
    scratch.write("there/room.map", "type octile\nheight 2\nwidth 3\nmap\n...\n...\n");
    const std::string rest = "problems: [public_benchmark: {map: room.map, robots: 2}]\n"
                             "planners: [push_and_swap]\nreports: [csv]\n";
    scratch.write("bare.yaml", rest);
    scratch.write("told.yaml", "maps: there\n" + rest);
    EXPECT_EQ(mrppsim({"run", "bare.yaml"}, scratch).code, 2);
    EXPECT_EQ(mrppsim({"run", "bare.yaml", "--maps", "there"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"run", "told.yaml"}, scratch).code, 0);
    // The report knows it too: an instance can be drawn.
    EXPECT_EQ(mrppsim({"report", "results/bare", "--only", "layouts"}, scratch).code, 0);
    EXPECT_TRUE(scratch.has("results/bare/layouts/public_benchmark-room.svg"));
}

TEST(Campaign, saysWhatItsReportsCouldNotDraw)
{
    const Scratch scratch;
    scratch.write("plan.yaml",
                  "problems: [small_benchmark: [tree]]\nplanners: [push_and_swap]\nrepetitions: 1\n"
                  "reports: [csv, html, charts]\n");
    const EnvironmentVariable path("PATH", scratch.path().string());
    const Outcome outcome = mrppsim({"run", "plan.yaml"}, scratch);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("gnuplot cannot be started; install it"));
#ifndef MRPP_HAS_EXPLORER
    EXPECT_THAT(outcome.err,
                HasSubstr("warning: report.html: this mrppsim was built without Node.js and npm"));
#endif
}

TEST(Campaign, aSecondTimeKeepsEverythingAndRunsNothing)
{
    const Scratch scratch;
    prepareCampaign(scratch, 2);
    const Outcome first = mrppsim({"run", "plan.yaml"}, scratch);
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("16 runs (16 now, 0 before)"));
    EXPECT_THAT(first.out, HasSubstr("report: results/test/results.csv"));
    const std::string results = scratch.read("results/test/results.csv");
    const Outcome second = mrppsim({"run", "plan.yaml"}, scratch);
    EXPECT_THAT(second.out, HasSubstr("16 runs (0 now, 16 before)"));
    EXPECT_EQ(scratch.read("results/test/results.csv"), results);
}

TEST(Campaign, twoFoldersAndTwoJobsGiveTheSameBytes)
{
    const Scratch scratch;
    prepareCampaign(scratch, 3);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "one"}, scratch).code, 0);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "two", "--jobs", "2", "--quiet"}, scratch).code, 0);
    EXPECT_EQ(scratch.tree("one/instances").size(), 2U * 12U);
    EXPECT_EQ(scratch.tree("one/solutions").size(), 24U);
    expectSameCampaign(scratch, "one", "two");
}

TEST(Campaign, anotherOrderOfProblemsAndPlannersGivesTheSameAnswers)
{
    const Scratch scratch;
    prepareCampaign(scratch, 2);
    scratch.write("other.yaml", R"(campaign: test
seed: 5
repetitions: 2
limits: {time: 20 s}
problems:
  - public_benchmark: {robots: [4, 2], map: room.map}
  - small_benchmark: [connector, tree]
planners:
  - {planner: push_and_swap, name: another order, set: {order: random}}
  - push_and_swap
optimizers: [redundancy_removal]
reports: [csv]
keep: {instances: true, solutions: true}
)");
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "one"}, scratch).code, 0);
    ASSERT_EQ(mrppsim({"run", "other.yaml", "-o", "two"}, scratch).code, 0);
    expectSameAnswers(scratch, "one", "two");
}

TEST(Campaign, keptInstancesAndSolutionsFitTogether)
{
    const Scratch scratch;
    prepareCampaign(scratch, 1);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "one"}, scratch).code, 0);
    const auto solutions = scratch.tree("one/solutions");
    ASSERT_EQ(solutions.size(), 8U);
    for (const auto &[name, contents] : solutions)
    {
        const std::string caseId = name.substr(0, name.find('.', name.rfind('/')));
        EXPECT_EQ(mrppsim({"validate", "--instance", "one/instances/" + caseId + ".instance", "--solution",
                           "one/solutions/" + name, "--motion", "pebble"},
                          scratch)
                      .code,
                  0)
            << name;
    }
}

TEST(Campaign, interruptionsEndCleanlyAndTheSameCommandGoesOn)
{
    for (const int signal : {SIGINT, SIGTERM})
    {
        const Scratch scratch;
        prepareCampaign(scratch, 30);
        Process process(mrppsimWords({"run", "plan.yaml", "-o", "one"}), scratch);
        awaitSolutions(scratch, "one", 20);
        process.signal(signal);
        const Outcome interrupted = process.wait();
        ASSERT_EQ(interrupted.code, 130) << interrupted.err;
        EXPECT_THAT(interrupted.err, HasSubstr("to go on: mrppsim run plan.yaml -o one"));
        EXPECT_FALSE(scratch.has("one/results.csv"));

        const Outcome resumed = mrppsim({"run", "plan.yaml", "-o", "one"}, scratch);
        EXPECT_EQ(resumed.code, 0) << resumed.err;
        EXPECT_THAT(resumed.out, HasSubstr("240 runs ("));
        EXPECT_EQ(resumed.out.find(" 0 before"), std::string::npos) << resumed.out;
        ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "two"}, scratch).code, 0);
        expectSameCampaign(scratch, "one", "two");
    }
}

TEST(Campaign, killedInTheMiddleItLosesNoFinishedRunAndRepeatsNone)
{
    const Scratch scratch;
    prepareCampaign(scratch, 50);
    for (const std::size_t solutions : {20U, 120U, 250U})
    {
        Process process(mrppsimWords({"run", "plan.yaml", "-o", "one", "--jobs", "2"}), scratch);
        awaitSolutions(scratch, "one", solutions);
        process.signal(SIGKILL);
        EXPECT_EQ(process.wait().code, -SIGKILL);
        ASSERT_EQ(mrppsim({"report", "one"}, scratch).code, 0);
        const auto kept = parseCsv(scratch.read("one/results.csv"));
        constexpr std::size_t kInOneCommit = 10; // tiny runs that end while one commit reaches a busy disk
        EXPECT_GE(kept.size() + kInOneCommit, solutions);
    }
    const auto before = parseCsv(scratch.read("one/results.csv"));
    const Outcome resumed = mrppsim({"run", "plan.yaml", "-o", "one"}, scratch);
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    const auto after = parseCsv(scratch.read("one/results.csv"));
    EXPECT_EQ(after.size(), 401U);
    for (const auto &row : before)
        EXPECT_EQ(std::count(after.begin(), after.end(), row), 1); // unchanged, times included

    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "two"}, scratch).code, 0);
    expectSameCampaign(scratch, "one", "two");
}

TEST(Campaign, halfWrittenFilesOfAKilledOneAreCleanedUp)
{
    const Scratch scratch;
    prepareCampaign(scratch, 1);
    scratch.write("one/instances/small_benchmark/tree/0.graphml.a1B2c3", "half");
    scratch.write("one/solutions/small_benchmark/tree/0.push_and_swap.csv.X1Y2z3", "half");
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "one"}, scratch).code, 0);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "two"}, scratch).code, 0);
    expectSameCampaign(scratch, "one", "two");
}

TEST(Campaign, shardsAreApartAndTogetherTheWhole)
{
    const Scratch scratch;
    prepareCampaign(scratch, 3);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "whole"}, scratch).code, 0);
    std::set<std::vector<std::string>> rows;
    std::size_t count = 0;
    for (int i = 1; i <= 3; ++i)
    {
        const std::string folder = "part" + std::to_string(i);
        ASSERT_EQ(
            mrppsim({"run", "plan.yaml", "-o", folder, "--shard", std::to_string(i) + "/3"}, scratch).code,
            0);
        const auto part = lastingResults(scratch, folder);
        rows.insert(part.begin(), part.end());
        count += part.size() - 1;
    }
    const auto whole = lastingResults(scratch, "whole");
    EXPECT_EQ(count, 24U);
    EXPECT_EQ(rows, (std::set<std::vector<std::string>>(whole.begin(), whole.end())));
}

TEST(Campaign, aReportNeedsNeitherTheMapsNorTheFirstPlace)
{
    const Scratch scratch;
    prepareCampaign(scratch, 1);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "one"}, scratch).code, 0);
    const std::string results = scratch.read("one/results.csv");
    std::filesystem::remove(scratch.path() / "room.map");
    std::filesystem::remove(scratch.path() / "plan.yaml");
    std::filesystem::remove(scratch.path() / "one/results.csv");
    std::filesystem::rename(scratch.path() / "one", scratch.path() / "moved");
    const Outcome outcome = mrppsim({"report", "moved", "--only", "csv"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(scratch.read("moved/results.csv"), results);
    const Outcome unknown = mrppsim({"report", "moved", "--only", "cvs"}, scratch);
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean 'csv'?"));
}

TEST(Campaign, saysInADryRunWhatRepetitionsCannotTeach)
{
    const Scratch scratch;
    const auto dryRun = [&scratch](const std::string &repetitions, const std::string &problem)
    {
        scratch.write(
            "plan.yaml",
            "repetitions: " + repetitions + "\nproblems: [" + problem + "]\n" +
                "planners: [push_and_rotate, {planner: push_and_rotate, name: many, set: "
                "{restarts: 20}}, {planner: push_and_swap, name: any order, set: {order: random}}]\n");
        const Outcome outcome = mrppsim({"run", "plan.yaml", "--dry-run"}, scratch);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_THAT(
        dryRun("20", "small_benchmark: tunnel"),
        HasSubstr(
            "note: there is no chance in small_benchmark/tunnel: 20 repetitions are copies of one instance, "
            "which count once in reports; push_and_rotate, without chance too, will give the same answer to "
            "each of them (only times may differ)\n"));
    EXPECT_THAT(dryRun("1", "small_benchmark: tunnel"), ::testing::Not(HasSubstr("no chance")));
    EXPECT_THAT(dryRun("20", "fg_vr: {graph: {grid: {side: 4}}, robots: [3]}"),
                ::testing::Not(HasSubstr("no chance")));
}

TEST(Campaign, aDryRunSaysAndWritesNothingElse)
{
    const Scratch scratch;
    prepareCampaign(scratch, 2);
    const auto before = scratch.tree();
    const Outcome outcome = mrppsim({"run", "plan.yaml", "--dry-run"}, scratch);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("16 runs: 8 cases (4 problem points, 2 repetitions) by 2 planners"));
    EXPECT_THAT(outcome.out, HasSubstr("planner another order, push_and_swap, order=random"));
    EXPECT_THAT(outcome.out, HasSubstr("case small_benchmark/tree/1"));
    EXPECT_EQ(scratch.tree(), before);
}

TEST(Campaign, namesThatShellsAndPlottersWouldRunAreOnlyNames)
{
    const Scratch scratch;
    scratch.write("plan.yaml", R"yaml(campaign: names
problems: [small_benchmark: [tree, theta]]
planners:
  - {planner: push_and_swap, name: "`touch owned1`"}
  - {planner: push_and_swap, name: "$(touch owned2) \"quoted\" 'single'"}
  - {planner: push_and_swap, name: "one line; system('touch owned3')"}
  - {planner: push_and_swap, name: "../../outside, with a comma & <tags> \\ {x}_y^z %s"}
keep: {instances: true, solutions: true}
)yaml");
    const Outcome outcome = mrppsim({"run", "plan.yaml", "-o", "deep/down/one"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = parseCsv(scratch.read("deep/down/one/results.csv"));
    ASSERT_EQ(rows.size(), 9U);
    const auto column = std::find(rows[0].begin(), rows[0].end(), "planner") - rows[0].begin();
    std::set<std::string> names;
    for (const auto &row : rows)
        names.insert(row.at(static_cast<std::size_t>(column)));
    EXPECT_TRUE(names.contains("one line; system('touch owned3')"));
    EXPECT_TRUE(names.contains("$(touch owned2) \"quoted\" 'single'"));
    for (const auto &[name, contents] : scratch.tree())
    {
        EXPECT_TRUE(name == "plan.yaml" || name.starts_with("deep/down/one/")) << name;
    }
    EXPECT_EQ(scratch.tree("deep/down/one/solutions").size(), 8U);
}

} // namespace
} // namespace mrpp::test
