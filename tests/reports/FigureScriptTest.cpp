#include "reports/gnuplot/FigureScript.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/Gnuplot.h"
#include "reports/picture/Process.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/Golden.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

const Figure &figureNamed(const std::vector<Figure> &figures, const std::string &name)
{
    for (const Figure &figure : figures)
        if (figure.name == name)
            return figure;
    throw std::out_of_range("no figure " + name);
}

ResultTable sweptResults()
{
    return FakeCampaign("swept", 4)
        .planner("push_and_swap")
        .planner("fails often")
        .sweep("fg_vr", "grid", "robots", {1, 2, 3, 4},
               [](double robots) { return gridInstance(4, static_cast<std::size_t>(robots)); })
        .problem("small_benchmark", "tree", treeInstance())
        .problem("small_benchmark", "grid 100%", gridInstance(3, 2))
        .run(
            [](RunRecord &record, std::size_t planner)
            {
                if (planner == 1 &&
                    (record.sweepValue == 2 || (record.sweepValue == 3 && record.repetition > 0)))
                    record.status = PlannerStatus::gave_up;
                else
                    solveSmoothly(record, planner);
            });
}

TEST(GnuplotString, ProtectsEverythingThatAUserCanType)
{
    EXPECT_EQ(gnuplotString("push_and_swap"), "'push_and_swap'");
    EXPECT_EQ(gnuplotString("`date` \"x\" $(y) \\n @m %d {z}"), "'`date` \"x\" $(y) \\n @m %d {z}'");
    EXPECT_EQ(gnuplotString("it's"), "'it'.\"'\".'s'");
    EXPECT_EQ(gnuplotString("\'\'"), "\'\'.\"'\".\'\'.\"'\".\'\'");
    EXPECT_EQ(gnuplotString("a\nset output b\n"), "'a set output b '");
}

TEST(GnuplotScript, OfASweepIsAsBlessed)
{
    const auto figures = campaignFigures(sweptResults()).figures;
    expectGolden("curves.gp", gnuplotScript(figureNamed(figures, "fg_vr-grid-path_length")));
    expectGolden("curves.csv", figureCsv(figureNamed(figures, "fg_vr-grid-path_length")));
    expectGolden("success.gp", gnuplotScript(figureNamed(figures, "fg_vr-grid-success_rate")));
}

TEST(GnuplotScript, OfAComparisonIsAsBlessed)
{
    const auto figures = campaignFigures(sweptResults()).figures;
    expectGolden("comparison.gp", gnuplotScript(figureNamed(figures, "small_benchmark-time")));
    expectGolden("comparison.csv", figureCsv(figureNamed(figures, "small_benchmark-makespan")));
}

TEST(GnuplotScript, BreaksTheLineWhereNothingWasSolvedAndShowsHowManyWere)
{
    const auto figures = campaignFigures(sweptResults()).figures;
    const std::string script = gnuplotScript(figureNamed(figures, "fg_vr-grid-time"));
    // Columns: at, median, solved, of how many. At 2 nothing was solved, at 3 one of four, which is no
    // median.
    EXPECT_NE(script.find(" 4 4\n\n4 "), std::string::npos) << script;
    EXPECT_NE(script.find("'fails often (9/16 solved)'"), std::string::npos) << script;
}

TEST(GnuplotScript, RunsByHandInItsOwnFolder)
{
    const auto figures = campaignFigures(sweptResults()).figures;
    const TemporaryFolder folder;
    for (const Figure &figure : figures)
    {
        writeFile(folder.path() / (figure.name + ".gp"), gnuplotScript(figure));
        const auto result =
            runProcess({"gnuplot", "-d", figure.name + ".gp"}, folder.path(), std::chrono::seconds(60));
        EXPECT_TRUE(result.succeeded()) << figure.name << ": " << result.output;
        // Without a UTF-8 locale gnuplot warns that it has no degree sign, which no figure needs.
        EXPECT_TRUE(result.output.empty() || result.output.find("degree sign") != std::string::npos)
            << figure.name << ": " << result.output;
        for (const char *extension : {".png", ".pdf", ".svg"})
            EXPECT_TRUE(std::filesystem::exists(folder.path() / (figure.name + extension)));
    }
}

TEST(CampaignFigures, AreSweepsMeasuresAndComparisons)
{
    std::string names;
    for (const Figure &figure : campaignFigures(sweptResults()).figures)
    {
        names += figure.name + " ";
        EXPECT_FALSE(figure.caption.empty());
    }
    EXPECT_EQ(names, "fg_vr-grid-path_length fg_vr-grid-optimized_path_length fg_vr-grid-makespan "
                     "fg_vr-grid-optimized_makespan fg_vr-grid-time fg_vr-grid-success_rate "
                     "small_benchmark-path_length small_benchmark-optimized_path_length "
                     "small_benchmark-makespan small_benchmark-optimized_makespan small_benchmark-time "
                     "overall-cactus-time overall-profile-path_length overall-profile-time "
                     "overall-boxes-path_length overall-scatter-path_length-push_and_swap-fails-often ");
}

TEST(CampaignFigures, ShowSuccessAndComplainWhereNothingWasSolved)
{
    const auto [figures, complaints] = campaignFigures(
        FakeCampaign("failed")
            .planners(2)
            .sweep("fg_vr", "grid", "robots", {1, 2}, [](double) { return treeInstance(); })
            .run([](RunRecord &record, std::size_t) { record.status = PlannerStatus::timeout; }));
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_EQ(figures[0].name, "fg_vr-grid-success_rate");
    EXPECT_EQ(figures[0].series[0].points[1].value->median, 0);
    ASSERT_EQ(complaints.size(), 1U);
    EXPECT_EQ(complaints[0], "grid: nowhere were more than half of the instances solved, so there is no "
                             "figure but that of success");
    EXPECT_TRUE(drawFigure(figures[0]).pdf.starts_with("%PDF-"));
}

} // namespace
} // namespace mrpp
