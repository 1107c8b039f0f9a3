#include "reports/PdfReport.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/ChartsReport.h"
#include "reports/picture/PdfFile.h"
#include "reports/picture/Picture.h"
#include "reports/picture/Process.h"
#include "reports/summary/SummaryTables.h"
#include "tests/reports/Campaigns.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

FakeCampaign smallCampaign()
{
    FakeCampaign campaign("demo & <b>more</b>", 2);
    campaign.planner("push_and_swap")
        .planner("a planner whose name is so long that no table column and no legend can ever hold it whole")
        .problem("small_benchmark", "tree", treeInstance())
        .sweep("fg_vr", "grid", "robots", {1, 2},
               [](double robots) { return gridInstance(4, static_cast<std::size_t>(robots)); });
    campaign.plan().text = "campaign: demo\nproblems: # <i>verbatim</i> & more\n  - small_benchmark: tree\n";
    return campaign;
}

/// Writes report.pdf, checks its structure and returns its text without line breaks.
std::string reportText(const ResultTable &results, const std::filesystem::path &folder)
{
    const auto files = PdfReport().write(results, fakeProvenance(), folder);
    EXPECT_EQ(files, std::vector<std::filesystem::path>{folder / "report.pdf"});
    const auto check = runProcess({"qpdf", "--check", "report.pdf"}, folder, std::chrono::seconds(60));
    EXPECT_TRUE(check.succeeded()) << check.output;
    const auto text = runProcess({"pdftotext", "report.pdf", "report.txt"}, folder, std::chrono::seconds(60));
    EXPECT_TRUE(text.succeeded()) << text.output;
    std::string words = readFile(folder / "report.txt");
    std::replace(words.begin(), words.end(), '\n', ' ');
    return words;
}

void expectWords(const std::string &text, const std::vector<std::string> &expected)
{
    for (const std::string &words : expected)
        EXPECT_NE(text.find(words), std::string::npos) << "missing: " << words;
}

TEST(PdfReport, StandsAlone)
{
    const TemporaryFolder folder;
    const std::string text = reportText(smallCampaign().run(solveSmoothly), folder.path());
    expectWords(text,
                {"demo & <b>more</b>", "12 finished of 12 planned: 12 solved, 0 not", "push_and_swap",
                 "0123456789abcdef0123456789abcdef01234567", "2026-07-31T12:34:56Z", "Debian GNU/Linux 12",
                 "Every run ended with a valid solution.", "<i>verbatim</i> & more",
                 "Figure 1. Path length on grid (fg vr) against robots", "Solved (%)", "Time (ms)",
                 "Figure 6. Success rate on grid", "tree: 7 vertices, 6 edges, 3 robots",
                 "Of 12 finished runs on 6 distinct instances, 12 solved."});
}

TEST(PdfReport, LinksToFilesBesideItAndWithinItself)
{
    const TemporaryFolder folder;
    FakeCampaign campaign = smallCampaign();
    campaign.plan().reports = {"csv", "charts", "layouts", "pdf"};
    (void)PdfReport().write(campaign.run(solveSmoothly), fakeProvenance(), folder.path());
    const auto run = [&](const std::vector<std::string> &command)
    {
        const auto result = runProcess(command, folder.path(), std::chrono::seconds(60));
        EXPECT_TRUE(result.succeeded()) << result.output;
    };
    run({"qpdf", "--qdf", "--object-streams=disable", "report.pdf", "plain.pdf"});
    expectWords(readFile(folder.path() / "plain.pdf"),
                {"/URI (plan.yaml)", "/URI (results.csv)", "/URI (figures/fg_vr-grid-path_length.csv)",
                 "/URI (layouts/small_benchmark-tree.svg)"});

    run({"pdftotext", "-f", "1", "-l", "1", "-layout", "report.pdf", "contents.txt"});
    std::istringstream contents(readFile(folder.path() / "contents.txt"));
    std::string page;
    for (std::string line; std::getline(contents, line);)
        if (line.starts_with("Plan "))
            page = line.substr(line.find_last_of(' ') + 1);
    ASSERT_NE(page, "");
    run({"pdftotext", "-f", page, "-l", page, "report.pdf", "page.txt"});
    expectWords(readFile(folder.path() / "page.txt"), {"Plan\n", "campaign: demo"});
}

TEST(PdfReport, OfPdfAloneLinksToNoOtherFiles)
{
    const TemporaryFolder folder;
    (void)PdfReport().write(smallCampaign().run(solveSmoothly), fakeProvenance(), folder.path());
    const auto plain = runProcess({"qpdf", "--qdf", "--object-streams=disable", "report.pdf", "plain.pdf"},
                                  folder.path(), std::chrono::seconds(60));
    ASSERT_TRUE(plain.succeeded()) << plain.output;
    const std::string text = readFile(folder.path() / "plain.pdf");
    EXPECT_EQ(text.find("/URI (results.csv)"), std::string::npos);
    EXPECT_EQ(text.find("/URI (figures/"), std::string::npos);
}

TEST(PdfReport, WritesTheSameBytesAgain)
{
    const ResultTable results = smallCampaign().run(solveSmoothly);
    const TemporaryFolder first;
    const TemporaryFolder second;
    (void)PdfReport().write(results, fakeProvenance(), first.path());
    (void)ChartsReport().write(results, fakeProvenance(), second.path()); // these figures are taken over
    (void)PdfReport().write(results, fakeProvenance(), second.path());
    EXPECT_EQ(readFile(first.path() / "report.pdf"), readFile(second.path() / "report.pdf"));
}

TEST(PdfReport, DoesNotTakeOverFiguresOfOtherResults)
{
    const TemporaryFolder folder;
    const TemporaryFolder fresh;
    FakeCampaign campaign = smallCampaign();
    (void)ChartsReport().write(campaign.run([](RunRecord &record, std::size_t) { solveSmoothly(record, 5); }),
                               fakeProvenance(), folder.path());
    const ResultTable results = campaign.run(solveSmoothly);
    (void)PdfReport().write(results, fakeProvenance(), folder.path());
    (void)PdfReport().write(results, fakeProvenance(), fresh.path());
    EXPECT_EQ(readFile(folder.path() / "report.pdf"), readFile(fresh.path() / "report.pdf"));
}

TEST(PdfReport, ListsFailuresWithTheirReasons)
{
    const TemporaryFolder folder;
    const std::string text = reportText(smallCampaign().run(
                                            [](RunRecord &record, std::size_t)
                                            {
                                                record.status = PlannerStatus::invalid;
                                                record.reason = "move 3 enters an occupied vertex";
                                            }),
                                        folder.path());
    expectWords(text, {"12 finished of 12 planned: 0 solved, 12 not", "move 3 enters an occupied vertex",
                       "nowhere were more than half of the instances solved"});
}

TEST(PdfReport, OfAnUnfinishedCampaignSaysSo)
{
    const TemporaryFolder folder;
    const ResultTable nothing(smallCampaign().plan(), {}, {});
    expectWords(reportText(nothing, folder.path()),
                {"0 finished of 12 planned", "not finished", "No run has finished yet."});
}

TEST(PdfReport, SurvivesNastyNames)
{
    const TemporaryFolder folder;
    const std::string marker = (folder.path() / "MARKER").string();
    FakeCampaign campaign("`touch " + marker + "`");
    campaign.planner("$(touch " + marker + ")\n\x01\xFF")
        .planner("<span size='xx-large'>big</span>")
        .problem("m", "\\N & ` \" '", treeInstance());
    campaign.plan().text = std::string(5000, 'x') + "\n\n\t<markup> \xFE\n";
    const std::string text = reportText(campaign.run(solveSmoothly), folder.path());
    EXPECT_FALSE(std::filesystem::exists(marker));
    expectWords(text, {"<span", "</span>", "<markup>", "\\N & ` \" '"});
}

TEST(PdfReport, PaginatesLongTablesWithTheirHeadings)
{
    FakeCampaign campaign("long");
    std::vector<double> values;
    for (int value = 1; value <= 120; ++value)
        values.push_back(value);
    campaign.planners(2).sweep("m", "p", "robots", values, [](double) { return treeInstance(); });
    const TemporaryFolder folder;
    const std::string text = reportText(campaign.run(solveSmoothly), folder.path());
    std::size_t headings = 0;
    for (std::size_t at = text.find("Makespan, optimized"); at != std::string::npos;
         at = text.find("Makespan, optimized", at + 1))
        ++headings;
    EXPECT_GE(headings, 4U); // 240 rows
}

TEST(PdfReport, ThrowsWhereItCannotWrite)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / "file", "");
    EXPECT_THROW(
        (void)PdfReport().write(smallCampaign().run(solveSmoothly), fakeProvenance(), folder.path() / "file"),
        FileError);
}

TEST(SummaryTables, MarkTheBestAmongThoseWhoSolvedMost)
{
    const ResultTable results = FakeCampaign("best", 2)
                                    .planners(3)
                                    .problem("m", "p", treeInstance())
                                    .run(
                                        [](RunRecord &record, std::size_t planner)
                                        {
                                            solveSmoothly(record, planner);
                                            // The shortest paths, but only on half of the instances.
                                            if (planner == 0 && record.repetition == 1)
                                                record.status = PlannerStatus::timeout;
                                        });
    const auto tables = summaryTables(results.records());
    ASSERT_EQ(tables.size(), 1U);
    ASSERT_EQ(tables[0].rows.size(), 3U);
    EXPECT_EQ(tables[0].rows[0][2].text, "1/2");
    EXPECT_EQ(tables[0].rows[0][3].emphasis, PdfTableCell::Emphasis::none);
    EXPECT_EQ(tables[0].rows[1][3].emphasis, PdfTableCell::Emphasis::best);
    EXPECT_EQ(tables[0].rows[2][3].emphasis, PdfTableCell::Emphasis::none);
}

TEST(PlannerTable, CountsOutcomesOfDistinctInstances)
{
    // Ten instances, each twice; two have no solution, and one is not for the second planner.
    const ResultTable results =
        FakeCampaign("outcomes", 20)
            .planner("gives up")
            .planner("proves", MotionRule::rotation)
            .problem("m", "p", treeInstance())
            .run(
                [](RunRecord &record, std::size_t planner)
                {
                    solveSmoothly(record, planner);
                    const std::int64_t instance = record.repetition % 10;
                    record.instanceFingerprint = std::to_string(instance);
                    record.time = 1;
                    if (instance < 2)
                    {
                        record.solvable = "no";
                        record.status = planner == 0 ? PlannerStatus::gave_up : PlannerStatus::infeasible;
                    }
                    if (instance == 2 && planner == 1)
                        record.status = PlannerStatus::unsupported;
                    if (instance == 3)
                        record.status = PlannerStatus::timeout;
                });
    const SummaryTable table = plannerTable(results.records(), 9);
    ASSERT_EQ(table.rows.size(), 2U);
    const auto texts = [&](std::size_t row)
    {
        std::string text;
        for (const PdfTableCell &cell : table.rows[row])
            text += cell.text + "|";
        return text;
    };
    // 7 of 8, PAR-2 (7 + 18) / 8; 6 of 7, PAR-2 (6 + 18) / 7.
    EXPECT_EQ(
        texts(0),
        "gives up (pebble)|20|10|7|0|0|3|87.5|52.9–97.8|3.12|12.1|1 timeout, 2 gave up; 2 of them without "
        "a solution|");
    EXPECT_EQ(texts(1), "proves (rotation)|20|10|6|2|1|1|85.7|48.7–97.4|3.43|13.7|1 timeout|");
    const auto tables = summaryTables(results.records());
    EXPECT_EQ(tables[0].rows[0][2].text, "7/8");
    EXPECT_EQ(tables[0].rows[1][2].text, "6/7, 2 proved, 1 not applicable");
}

TEST(FailureTable, GroupsByPlannerStatusAndReason)
{
    const ResultTable results = FakeCampaign("failures", 6)
                                    .planners(1)
                                    .problem("m", "p", treeInstance())
                                    .run(
                                        [](RunRecord &record, std::size_t)
                                        {
                                            record.status = record.repetition % 2 == 0
                                                                ? PlannerStatus::timeout
                                                                : PlannerStatus::crash;
                                            record.reason = record.repetition == 5 ? "other" : "same";
                                        });
    const SummaryTable table = failureTable(results.records(), 10);
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(table.rows[0][1].text, "timeout");
    EXPECT_EQ(table.rows[0][2].text, "3");
    EXPECT_EQ(table.rows[1][2].text, "2");
    EXPECT_EQ(table.rows[2][3].text, "other");
    EXPECT_EQ(failureTable(results.records(), 1).rows.back()[3].text, "2 kinds more, see results.csv");
}

TEST(PdfFile, RefusesWhatIsNoPdf)
{
    EXPECT_THROW((void)withoutTimes("no PDF at all"), DrawingError);
    EXPECT_THROW((void)pageSize(""), DrawingError);
}

} // namespace
} // namespace mrpp
