/// \file
/// A report that cannot be written, or a tool that is missing, costs no other report.

#include "tests/cli/Program.h"
#include "tests/reports/EnvironmentVariable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

class BrokenReport : public ::testing::Test
{
protected:
    void SetUp() override
    {
        scratch_.write("plan.yaml", "problems: [small_benchmark: tree]\nplanners: [push_and_swap]\n"
                                    "reports: [charts, csv, latex, layouts, markdown, pdf]\n");
        ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "out", "--no-report"}, scratch_).code, 0);
    }

    void expectComplete(const std::vector<std::string> &files) const
    {
        for (const std::string &file : files)
            EXPECT_TRUE(scratch_.has("out/" + file)) << file;
    }

    const Scratch scratch_;
};

TEST_F(BrokenReport, WithoutDrawingToolsPicturesAreMissingAndTheRestIsThere)
{
    const testing::EnvironmentVariable path("PATH", scratch_.path().string());
    const Outcome outcome = mrppsim({"report", "out"}, scratch_);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("warning: small_benchmark-tree: "));
    EXPECT_THAT(scratch_.read("out/figures/NOT_DRAWN.txt"),
                HasSubstr("gnuplot cannot be started; install it (Debian: gnuplot-nox)"));
    EXPECT_THAT(scratch_.read("out/layouts/NOT_DRAWN.txt"), HasSubstr("cannot be started; install"));
    expectComplete({"results.csv", "summary.csv", "report.md", "report.pdf", "latex/tables.tex",
                    "figures/small_benchmark-time.gp"});
}

TEST_F(BrokenReport, AFolderThatCannotBeWrittenIsOneErrorAndTheRestIsThere)
{
    scratch_.write("out/figures", "a file where the folder of the figures should be");
    const Outcome outcome = mrppsim({"report", "out"}, scratch_);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, MatchesRegex("mrppsim: out/figures[^\n]*; all other reports are written\n"));
    expectComplete({"results.csv", "summary.csv", "layouts/small_benchmark-tree.svg", "report.pdf"});
}

} // namespace
} // namespace mrpp::test
