/// Whatever is said must arrive, or the command has failed.

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StandardOutput : public ::testing::Test
{
protected:
    StandardOutput()
    {
        scratch_.write("plan.yaml", "problems: [small_benchmark: [tree, theta]]\nplanners: [push_and_swap]\n"
                                    "reports: [csv]\n");
        EXPECT_EQ(mrppsim({"run", "plan.yaml", "-o", "done"}, scratch_).code, 0);
        EXPECT_EQ(mrppsim({"generate", "grid", "--side", "3", "--graph", "g.graphml"}, scratch_).code, 0);
        scratch_.write("g.instance", "graph = g.graphml\nagent: start = 0, goal = 1\n");
        scratch_.write("g.csv", "step,robot,from,to\n0,0,0,1\n");
    }

    /// `mrppsim COMMAND` by a shell, with what is written behind it.
    [[nodiscard]] Outcome shell(const std::string &command, const std::string &behind) const
    {
        return Process({"bash", "-c", std::string(MRPP_PROGRAM) + " " + command + " " + behind}, scratch_)
            .wait();
    }

    Scratch scratch_;
};

TEST_F(StandardOutput, ofEveryCommandIsMissed)
{
    for (const char *command :
         {"generate grid --side 100", "generate grid --side 3", "list planners --json", "list formats",
          "--help", "--version", "run --help", "check --instance g.instance",
          "check --instance g.instance --json", "solve --instance g.instance --planner push_and_swap",
          "validate --instance g.instance --solution g.csv", "run plan.yaml --dry-run",
          "run plan.yaml -o done --why", "run plan.yaml -o done", "report done", "compare done done",
          "merge merged done", "convert g.graphml h.edges",
          "solve --instance g.instance --planner push_and_swap --json /dev/full"})
    {
        const Outcome outcome = shell(command, ">/dev/full");
        EXPECT_EQ(outcome.code, 2) << command;
        EXPECT_THAT(outcome.err, HasSubstr("No space left on device")) << command;
    }
}

TEST_F(StandardOutput, isMissedWhereItIsClosed)
{
    const Outcome outcome = shell("list planners", ">&-");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("the standard output cannot be written: Bad file descriptor"));
    const Outcome run = shell("run plan.yaml -o closed -q", ">&- <&- 2>&-");
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(scratch_.read("closed/results.csv").substr(0, 8), "run_key,");
}

TEST_F(StandardOutput, ofWhichSomebodyReadsOnlyTheBeginningIsNoErrorToTalkAbout)
{
    const Outcome outcome = shell("generate grid --side 200", "| head -1; echo \"${PIPESTATUS[0]}\"");
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_THAT(outcome.out, HasSubstr("\n2\n"));
}

TEST_F(StandardOutput, isWhatItWas)
{
    const Outcome outcome = shell("generate grid --side 100", "");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(mrppsim({"generate", "grid", "--side", "100", "--graph", "file.graphml"}, scratch_).code, 0);
    EXPECT_EQ(outcome.out, scratch_.read("file.graphml"));
}

} // namespace
} // namespace mrpp::test
