#include "reports/CsvReport.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/Golden.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

ResultTable mixedResults()
{
    return FakeCampaign("mixed", 3)
        .planner("push_and_swap")
        .planner("with \"quotes\", and a comma\nand a line")
        .problem("small_benchmark", "tree", treeInstance())
        .sweep("fg_vr", "grid", "robots", {2, 4},
               [](double robots) { return gridInstance(4, static_cast<std::size_t>(robots)); })
        .run(
            [](RunRecord &record, std::size_t planner)
            {
                if (planner == 1 && record.repetition == 1)
                {
                    record.status = PlannerStatus::timeout;
                    record.reason = "the time limit came first";
                    record.completed = 0.5;
                    return;
                }
                solveSmoothly(record, planner);
                if (record.problem == "tree")
                    record.extra["zeal"] = 0.25;
                if (planner == 0)
                    record.extra["notes"] = std::string("a,b");
            });
}

TEST(CsvReport, WritesResultsAndSummary)
{
    const ResultTable results = mixedResults();
    const TemporaryFolder folder;
    const auto files = CsvReport().write(results, fakeProvenance(), folder.path());
    ASSERT_EQ(files.size(), 2U);
    expectGolden("results.csv", readFile(folder.path() / "results.csv"));
    expectGolden("summary.csv", readFile(folder.path() / "summary.csv"));
}

TEST(CsvReport, HasOneRowARunAndTheColumnsInOrder)
{
    const std::string csv = resultsCsv(mixedResults().records());
    std::string heading;
    for (const RunColumn &column : runColumns())
        heading += std::string(column.name) + ",";
    EXPECT_EQ(csv.substr(0, csv.find('\n')), heading + "notes,zeal");
    EXPECT_NE(csv.find("\"with \"\"quotes\"\", and a comma\nand a line\""), std::string::npos);
    EXPECT_EQ(csv.find('\r'), std::string::npos);
}

TEST(CsvReport, OfNothingHasHeadingsOnly)
{
    const std::string results = resultsCsv({});
    EXPECT_EQ(results.find('\n'), results.size() - 1);
    const std::string summary = summaryCsv({}, 60);
    EXPECT_EQ(summary.find('\n'), summary.size() - 1);
}

TEST(CsvReport, SummaryLeavesMediansEmptyWhereNothingWasSolved)
{
    const ResultTable results =
        FakeCampaign("failed", 2)
            .planners(1)
            .problem("m", "p", treeInstance())
            .run([](RunRecord &record, std::size_t) { record.status = PlannerStatus::memory_limit; });
    const std::string summary = summaryCsv(results.records(), 60);
    EXPECT_NE(summary.find("m,p,,,planner_0,pebble,2,2,0,0,0,2,2,0,0,0.6576197724933469,,,,2,"),
              std::string::npos)
        << summary;
    EXPECT_NE(summary.find(",2,0,2,0,0,0,0,0,0,0,0,120,600,,,\n"), std::string::npos) << summary;
}

TEST(CsvReport, SummaryComparesWithTheBestPlannerAndPenalizesFailures)
{
    const ResultTable results = FakeCampaign("pair", 3)
                                    .planners(2)
                                    .problem("m", "p", treeInstance())
                                    .run(
                                        [](RunRecord &record, std::size_t planner)
                                        {
                                            if (planner == 1 && record.repetition == 2)
                                                return; // not solved
                                            record.status = PlannerStatus::solved;
                                            record.time = planner == 0 ? 4 : 1;
                                            record.pathLength = planner == 0 ? 10 : 12 + record.repetition;
                                            record.makespan = 0;
                                        });
    const std::string summary = summaryCsv(results.records(), 60);
    // Times 4, 4, 4: four times the best on the first two cases, the best on the third.
    EXPECT_NE(summary.find(",4,4,4,1,\n"), std::string::npos) << summary;
    // Times 1, 1 and a failure; 1.2 and 1.3 times as many moves, and a failure above them.
    EXPECT_NE(summary.find("," + formatNumber(122. / 3) + "," + formatNumber(602. / 3) + ",1,1.3,\n"),
              std::string::npos)
        << summary;
}

TEST(CsvReport, ThrowsWhereItCannotWrite)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / "file", "");
    EXPECT_THROW((void)CsvReport().write(mixedResults(), fakeProvenance(), folder.path() / "file" / "sub"),
                 FileError);
}

} // namespace
} // namespace mrpp
