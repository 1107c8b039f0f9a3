#include "framework/store/ResultStore.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Plugin, takesPartInCampaignsAndTheirWorkers)
{
    const Scratch scratch;
    scratch.write("plan.yaml",
                  "campaign: test\nproblems: [small_benchmark: tree]\nplanners: [stander, push_and_swap]\n"
                  "reports: [csv]\n");
    EXPECT_THAT(mrppsim({"run", "plan.yaml"}, scratch).err, HasSubstr("there is no planner 'stander'"));
    const Outcome outcome =
        mrppsim({"run", "plan.yaml", "--plugin", MRPP_GOOD_PLUGIN, "--plugin=" MRPP_GOOD_PLUGIN}, scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const RunRecord &record :
         ResultStore(scratch.path() / "results/test", ResultStore::Access::read).records())
    {
        const bool solves = record.planner == "push_and_swap";
        EXPECT_EQ(record.status, solves ? PlannerStatus::solved : PlannerStatus::gave_up) << record.reason;
        ASSERT_EQ(record.extra.contains("half_length"), solves);
        if (solves)
        {
            EXPECT_EQ(std::get<double>(record.extra.at("half_length")),
                      static_cast<double>(record.pathLength.value()) / 2);
        }
        EXPECT_EQ(
            mrppsim({"--plugin", MRPP_GOOD_PLUGIN, "replay", "results/test", record.runKey}, scratch).code,
            0);
    }
    EXPECT_THAT(scratch.read("results/test/results.csv"), HasSubstr(",half_length"));
    EXPECT_EQ(mrppsim({"report", "results/test", "--plugin", MRPP_GOOD_PLUGIN}, scratch).code, 0);
}

TEST(Plugin, mayBeNamedInThePlan)
{
    const Scratch scratch;
    std::filesystem::create_directories(scratch.path() / "plans");
    std::filesystem::copy(MRPP_GOOD_PLUGIN, scratch.path() / "plans/mine.so");
    const std::string rest = "problems: [small_benchmark: tree]\nplanners: [stander]\nreports: [csv]\n";
    scratch.write("plans/plan.yaml", rest + "plugins: [mine.so]\n");
    const Outcome outcome = mrppsim({"run", "plans/plan.yaml", "-o", "out"}, scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto records = ResultStore(scratch.path() / "out", ResultStore::Access::read).records();
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].status, PlannerStatus::gave_up) << records[0].reason;
    EXPECT_EQ(mrppsim({"report", "out"}, scratch).code, 0);
    EXPECT_EQ(mrppsim({"replay", "out", records[0].runKey}, scratch).code, 0);

    scratch.write("plans/plan.yaml", rest + "plugins:\n  - mine.so\n  - yours.so\n");
    EXPECT_EQ(mrppsim({"run", "plans/plan.yaml"}, scratch).err,
              "plans/plan.yaml:6:5: plans/yours.so: there is no such plugin\n");
}

TEST(Plugin, isKnownToEveryCommand)
{
    const Scratch scratch;
    EXPECT_THAT(mrppsim({"list", "planners", "--plugin", MRPP_GOOD_PLUGIN}, scratch).out,
                HasSubstr("stander\n"));
    EXPECT_THAT(mrppsim({"list", "metrics", "--plugin", MRPP_GOOD_PLUGIN}, scratch).out,
                HasSubstr("half_length\n"));
    scratch.write("g.graphml", "<graphml><graph edgedefault=\"undirected\"><node id=\"a\"/><node id=\"b\"/>"
                               "<edge source=\"a\" target=\"b\"/></graph></graphml>");
    scratch.write("g.instance", "graph = g.graphml\nagent: start = 1, goal = 1\n");
    EXPECT_EQ(
        mrppsim({"solve", "--instance", "g.instance", "--planner", "stander", "--plugin", MRPP_GOOD_PLUGIN},
                scratch)
            .code,
        0);
}

TEST(Plugin, whoseMetricFailsSpoilsOneCellAndNobodyIsBlamed)
{
    const std::vector<std::pair<std::string, std::string>> ways = {
        {"throw", "metric 'turns' threw: no such turn"},
        {"abort", "no added metrics: one of them killed by signal 6 (Aborted)"},
        {"hang", "no added metrics: one of them needed too much time or memory"}};
    for (const std::string isolation : {"process", "none"})
        for (const auto &[way, note] : ways)
        {
            if (isolation == "none" && way != "throw")
                continue; // ends the campaign, as it would a debugger's program
            SCOPED_TRACE(isolation + " " + way);
            const Scratch scratch;
            scratch.write("plan.yaml", "problems: [small_benchmark: tree]\nplanners: [push_and_swap]\n"
                                       "limits: {time: 0.2 s}\nexecution: {isolation: " +
                                           isolation + "}\nreports: [csv]\n");
            const Outcome outcome = Process({"env", "MRPP_FAULT=" + way, MRPP_PROGRAM, "run", "plan.yaml",
                                             "-o", "out", "--plugin", MRPP_FAULTY_PLUGIN},
                                            scratch)
                                        .wait();
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            const auto records = ResultStore(scratch.path() / "out", ResultStore::Access::read).records();
            ASSERT_EQ(records.size(), 1U);
            EXPECT_EQ(records[0].status, PlannerStatus::solved) << records[0].reason;
            EXPECT_FALSE(records[0].extra.contains("turns"));
            EXPECT_EQ(records[0].extra.contains("half_length"), way == "throw");
            EXPECT_EQ(std::get<std::string>(records[0].extra.at("notes")), note);
        }
}

TEST(Plugin, isRefusedWithTheReason)
{
    const Scratch scratch;
    const auto complaint = [&](const std::string &file)
    {
        const Outcome outcome = mrppsim({"list", "planners", "--plugin", file}, scratch);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    scratch.write("text.so", "this is no library");
    EXPECT_EQ(complaint("nowhere.so"), "nowhere.so: there is no such plugin\n");
    EXPECT_THAT(complaint("text.so"), StartsWith("text.so: cannot be loaded: "));
    EXPECT_THAT(complaint(MRPP_EMPTY_PLUGIN),
                HasSubstr("is a library, but no plugin: it has no MRPP_PLUGIN"));
    EXPECT_THAT(complaint(MRPP_TAKEN_PLUGIN),
                HasSubstr("a planner named 'push_and_swap' is registered already"));
    EXPECT_THAT(
        complaint(MRPP_STRANGE_PLUGIN),
        ::testing::MatchesRegex(".*: was built against version [0-9.]+ \\(headers 01234567\\) with .* and "
                                ".*, but this is version [0-9.]+ \\(headers [0-9a-f]{8}\\) with .*; build "
                                "it again against the package of this version\n"));
    EXPECT_EQ(mrppsim({"list", "planners", "--plugin"}, scratch).err,
              "mrppsim: --plugin needs a file: --plugin ./libmine.so\n");
}

} // namespace
} // namespace mrpp::test
