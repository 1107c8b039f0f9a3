#include "framework/store/ResultStore.h"
#include "framework/store/Sqlite.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

void runCampaign(const Scratch &scratch)
{
    scratch.write("room.map", "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@..\n..@..\n.....\n");
    scratch.write("plan.yaml", R"(campaign: test
seed: 5
repetitions: 2
problems:
  - small_benchmark: tree
  - public_benchmark: {map: room.map, robots: [2, 4]}
planners: [{planner: push_and_swap, set: {order: random}}, tass]
optimizers: [redundancy_removal]
keep: {solutions: true}
)");
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "results", "--no-report", "-q"}, scratch).code, 0);
}

std::vector<RunRecord> records(const Scratch &scratch)
{
    return ResultStore(scratch.path() / "results", ResultStore::Access::read).records();
}

TEST(Replay, givesEveryRecordedAnswerAgain)
{
    const Scratch scratch;
    runCampaign(scratch);
    std::size_t solved = 0;
    for (const RunRecord &record : records(scratch))
        for (const bool inProcess : {false, true})
        {
            std::vector<std::string> words = {"replay", "results", record.runKey, "--solution", "moves.csv"};
            if (inProcess)
                words.emplace_back("--in-process");
            const Outcome outcome = mrppsim(words, scratch);
            EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
            if (!record.solved())
            {
                EXPECT_THAT(outcome.out, HasSubstr("the same end\n"));
                continue;
            }
            ++solved;
            EXPECT_THAT(outcome.out, HasSubstr("the same solution\n"));
            EXPECT_EQ(scratch.read("moves.csv"),
                      scratch.read("results/solutions/" + record.caseId + "." + record.planner + ".csv"));
        }
    EXPECT_GE(solved, 8U);
}

TEST(Replay, findsARunByTheBeginningOfItsKey)
{
    const Scratch scratch;
    runCampaign(scratch);
    const std::string key = records(scratch).front().runKey;
    EXPECT_EQ(mrppsim({"replay", "results", key.substr(0, 12)}, scratch).code, 0);
    const Outcome many = mrppsim({"replay", "results", ""}, scratch);
    EXPECT_EQ(many.code, 2);
    EXPECT_THAT(many.err, HasSubstr("results: 12 runs begin with '': "));
    const Outcome none = mrppsim({"replay", "results", "hello"}, scratch);
    EXPECT_EQ(none.code, 2);
    EXPECT_THAT(none.err, HasSubstr("results: holds no finished run 'hello'"));
}

TEST(Replay, writesWhatItRan)
{
    const Scratch scratch;
    runCampaign(scratch);
    const RunRecord record = records(scratch).front();
    ASSERT_EQ(mrppsim({"replay", "results", record.runKey, "--graph", "g.graphml", "--instance", "g.instance",
                       "--solution", "moves.csv", "--json", "record.json"},
                      scratch)
                  .code,
              0);
    EXPECT_EQ(mrppsim({"validate", "--instance", "g.instance", "--solution", "moves.csv"}, scratch).code, 0);
    EXPECT_THAT(scratch.read("record.json"), HasSubstr("\"run_key\": \"" + record.runKey + "\""));
}

TEST(Replay, saysWhereTheAnswerIsAnother)
{
    const Scratch scratch;
    runCampaign(scratch);
    sqlite::Connection(scratch.path() / "results/results.sqlite", sqlite::Connection::Mode::write)
        .run("UPDATE runs SET path_length = 7, solution_fingerprint = 'f' WHERE status = 6");
    for (const RunRecord &record : records(scratch))
        if (record.solved())
        {
            const Outcome outcome = mrppsim({"replay", "results", record.runKey}, scratch);
            EXPECT_EQ(outcome.code, 1);
            EXPECT_THAT(outcome.out, HasSubstr("another answer: solution_fingerprint path_length\n"));
            return;
        }
    FAIL() << "no run was solved";
}

TEST(Replay, knowsThePlanThatARunBelongsTo)
{
    const Scratch scratch;
    runCampaign(scratch);
    const auto old = records(scratch);
    std::string plan = scratch.read("plan.yaml");
    plan.replace(plan.find("seed: 5"), 7, "seed: 6");
    scratch.write("plan.yaml", plan);
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "results", "--no-report", "-q"}, scratch).code, 0);
    ASSERT_GT(records(scratch).size(), old.size());
    EXPECT_EQ(mrppsim({"replay", "results", old.back().runKey}, scratch).code, 0);

    // Of the map that a run was on nothing is left.
    scratch.write("room.map", "type octile\nheight 1\nwidth 5\nmap\n.....\n");
    for (const RunRecord &record : old)
    {
        const Outcome outcome = mrppsim({"replay", "results", record.runKey}, scratch);
        const bool onMap = record.model == "public_benchmark";
        EXPECT_EQ(outcome.code, onMap ? 2 : 0);
        if (onMap)
        {
            EXPECT_THAT(outcome.err, HasSubstr("an input file has changed since then"));
        }
    }
}

} // namespace
} // namespace mrpp::test
