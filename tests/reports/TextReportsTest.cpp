#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/LatexReport.h"
#include "reports/MarkdownReport.h"
#include "reports/document/Markup.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;
using ::testing::HasSubstr;

TEST(LatexText, MeansItself)
{
    EXPECT_EQ(latexText("a_b & 50% of $1 #2 {x}"), "a\\_b \\& 50\\% of \\$1 \\#2 \\{x\\}");
    EXPECT_EQ(latexText("\\input{x} ~ ^"),
              "\\textbackslash{}input\\{x\\} \\textasciitilde{} \\textasciicircum{}");
    EXPECT_EQ(latexText("--"), "{-}{-}");
    EXPECT_EQ(latexName("push_and_swap 2"), "PushAndSwapTwo");
    EXPECT_EQ(latexName("Ω!"), "Unnamed");
}

TEST(MarkdownText, MeansItself)
{
    EXPECT_EQ(markdownText("a_b | *c* `d` [e](f) <g> & !h #1"),
              "a\\_b \\| \\*c\\* \\`d\\` \\[e\\]\\(f\\) &lt;g&gt; &amp; \\!h \\#1");
}

ResultTable results()
{
    FakeCampaign campaign("text", 4);
    campaign.planner("push_and_swap")
        .planner("50% _of_ `it`|")
        .sweep("fg_vr", "grid", "robots", {1, 2, 3}, [](double) { return gridInstance(4, 1); })
        .problem("small_benchmark", "tree", treeInstance());
    return campaign.run(solveSmoothly);
}

TEST(LatexReport, HasTablesNumbersAndFigures)
{
    const TemporaryFolder folder;
    const auto files = LatexReport().write(results(), fakeProvenance(), folder.path());
    for (const auto &file : files)
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    const std::string tables = readFile(folder.path() / "latex" / "tables.tex");
    EXPECT_THAT(tables, HasSubstr("\\toprule\nRobots & Planner & Solved & "));
    EXPECT_THAT(tables, HasSubstr("50\\% \\_of\\_ \\textasciigrave{}it\\textasciigrave{}\\textbar{}"));
    EXPECT_THAT(tables, HasSubstr("\\textbf{"));
    const std::string numbers = readFile(folder.path() / "latex" / "numbers.tex");
    EXPECT_THAT(numbers, HasSubstr("\\newcommand{\\mrppRuns}{32}"));
    EXPECT_THAT(numbers, HasSubstr("\\newcommand{\\mrppSolvedByPushAndSwap}{16}"));
    EXPECT_THAT(numbers, HasSubstr("\\newcommand{\\mrppRatioPathLengthPushAndSwapOverFiveZeroOfIt}{0."));
    EXPECT_THAT(readFile(folder.path() / "latex" / "figures.tex"),
                HasSubstr("\\includegraphics[width=\\linewidth]{../figures/fg_vr-grid-time.pdf}"));
    EXPECT_THAT(readFile(folder.path() / "latex" / "report.tex"),
                HasSubstr("\\item push\\_and\\_swap (pebble) needs fewer moves"));
}

TEST(MarkdownReport, HasFindingsTablesAndFigures)
{
    const TemporaryFolder folder;
    const TemporaryFolder again;
    (void)MarkdownReport().write(results(), fakeProvenance(), folder.path());
    (void)MarkdownReport().write(results(), fakeProvenance(), again.path());
    const std::string text = readFile(folder.path() / "report.md");
    EXPECT_EQ(text, readFile(again.path() / "report.md"));
    EXPECT_THAT(text, HasSubstr("| 1 | 50% \\_of\\_ \\`it\\`\\| \\(pebble\\) | 4/4 |"));
    EXPECT_THAT(text, HasSubstr("* push\\_and\\_swap \\(pebble\\) needs fewer moves than"));
    EXPECT_THAT(text, HasSubstr("![](figures/overall-cactus-time.svg)"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "figures" / "overall-cactus-time.svg"));
}

TEST(TextReports, OfNothingAreWhole)
{
    const TemporaryFolder folder;
    const ResultTable nothing(FakeCampaign("empty").planners(2).plan(), {}, {});
    (void)LatexReport().write(nothing, fakeProvenance(), folder.path());
    (void)MarkdownReport().write(nothing, fakeProvenance(), folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "latex" / "report.tex"));
}

} // namespace
} // namespace mrpp
