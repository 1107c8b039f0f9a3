#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/ChartsReport.h"
#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/FigureScript.h"
#include "tests/reports/Campaigns.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

/// A sweep that grows the graph; the second planner needs half as much more, and fails on the largest graph.
FakeCampaign growing()
{
    FakeCampaign campaign("growing", 5);
    campaign.planner("first").planner("second").planner("it's `third`");
    campaign.sweep("fr_vg", "grid", "side", {2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                   [](double side) { return gridInstance(static_cast<std::size_t>(side), 1); });
    return campaign;
}

void cost(RunRecord &record, std::size_t planner)
{
    const auto vertices = static_cast<double>(*record.vertices);
    solveSmoothly(record, planner);
    record.time = 1e-5 * std::pow(vertices, 2) * (1 + 0.5 * static_cast<double>(planner)) *
                  (1 + 0.02 * static_cast<double>(record.repetition));
    if (planner == 1 && record.sweepValue == 11)
        record.status = PlannerStatus::timeout;
}

const Figure &named(const CampaignFigures &figures, const std::string &name)
{
    for (const Figure &figure : figures.figures)
        if (figure.name == name)
            return figure;
    throw std::out_of_range("no figure " + name);
}

TEST(CactusFigure, EndsWhereTheSolvedRunsEnd)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "overall-cactus-time");
    EXPECT_EQ(figure.series[0].steps.size(), 50U);
    EXPECT_EQ(figure.series[1].steps.size(), 45U);
    EXPECT_EQ(figure.series[1].runs, 50U);
    EXPECT_NEAR(figure.series[0].steps.back().y, 1e-5 * 121 * 121 * 1.08, 1e-12);
}

TEST(ProfileFigure, SaysHowOftenAPlannerIsBestAndHowOftenItSolves)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "overall-profile-time");
    EXPECT_EQ(figure.series[0].steps.back(), (StepPoint{1, 1}));
    EXPECT_EQ(figure.series[1].steps.back().y, 0.9);
    EXPECT_NEAR(figure.series[1].steps.back().x, 1.5, 1e-9);
    EXPECT_EQ(figure.series[2].steps.back().y, 1);
}

TEST(ScatterFigure, KeepsFailuresAndCountsThem)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "overall-scatter-path_length-first-second");
    EXPECT_EQ(figure.pairs.size(), 50U);
    EXPECT_FALSE(figure.pairs.back().y);
    EXPECT_THAT(figure.caption,
                ::testing::HasSubstr("first (pebble) needs less (45), below it second (pebble) (0)"));
    EXPECT_THAT(figure.caption,
                ::testing::HasSubstr("0 only by first (pebble), 5 only by second (pebble), 0 by both"));
}

TEST(RanksFigure, CountsFailuresAsWorst)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "overall-ranks-time");
    ASSERT_EQ(figure.series.size(), 3U);
    EXPECT_EQ(figure.series[0].label, "first");
    EXPECT_EQ(figure.series[0].meanRank, 1);
    EXPECT_NEAR(figure.series[1].meanRank, 2.1, 1e-12); // nine times second, once third
    EXPECT_NEAR(figure.criticalDifference, 2.343701 * std::sqrt(12.0 / 60), 1e-5);
}

TEST(ScalingFigure, NamesTheLawAndItsRate)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "fr_vg-grid-scaling-time");
    EXPECT_THAT(figure.series[0].remark, ::testing::StartsWith(" ∝ n^2.00 ["));
    EXPECT_NEAR(*figure.series[0].heldOutFrom, std::sqrt(64.0 * 81), 1e-9);
    EXPECT_THAT(figure.caption, ::testing::HasSubstr("first: the power law"));
    EXPECT_THAT(figureCsv(figure), ::testing::HasSubstr("fit of first,4,"));
}

TEST(AnytimeFigure, FollowsTheMedianRun)
{
    FakeCampaign campaign("watched", 3);
    campaign.planner("first").problem("m", "tree", treeInstance());
    const ResultTable plain = campaign.run(cost);
    const ResultTable results(campaign.plan(), plain.records(), {},
                              [&](const std::string &key)
                              {
                                  Progress progress;
                                  progress.names = {"arrived"};
                                  const double scale = key == plain.records()[0].runKey   ? 1
                                                       : key == plain.records()[1].runKey ? 2
                                                                                          : 3;
                                  for (int i = 1; i <= 4; ++i)
                                      progress.samples.push_back({0.1 * i, {scale * i}});
                                  return progress;
                              });
    const auto figures = campaignFigures(results);
    const Figure &figure = named(figures, "m-tree-anytime-arrived");
    EXPECT_EQ(figure.series[0].points.front().value->median, 2);
    EXPECT_EQ(figure.series[0].points.back().value, (Quartiles{6, 8, 10, 3}));
    EXPECT_EQ(figure.series[0].points.back().at, 0.4);
}

TEST(AnytimeFigure, KeepsRunsThatReportedNothingInItsDenominator)
{
    FakeCampaign campaign("watched", 3);
    campaign.planner("first").problem("m", "tree", treeInstance());
    const ResultTable plain = campaign.run(cost);
    const ResultTable results(campaign.plan(), plain.records(), {},
                              [&](const std::string &key)
                              {
                                  Progress progress;
                                  if (key != plain.records()[0].runKey)
                                      return progress;
                                  progress.names = {"arrived"};
                                  for (int i = 1; i <= 4; ++i)
                                      progress.samples.push_back({0.1 * i, {1.0 * i}});
                                  return progress;
                              });
    const auto figures = campaignFigures(results);
    const Figure &figure = named(figures, "m-tree-anytime-arrived");
    EXPECT_EQ(figure.series[0].points.back().solved, 1U);
    EXPECT_EQ(figure.series[0].points.back().runs, 3U);
}

TEST(RanksFigure, TakesTheMeanOfTwoMiddleValues)
{
    // Two repetitions each: by the upper one `second` would be best, by their mean `first` is.
    FakeCampaign campaign("even", 2);
    campaign.planner("first").planner("second").planner("third");
    std::vector<double> values;
    for (int i = 0; i < 12; ++i)
        values.push_back(i);
    campaign.sweep("m", "p", "robots", values, [](double) { return treeInstance(); });
    const auto figures = campaignFigures(campaign.run(
        [](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, 0);
            const std::int64_t moves[3][2] = {{1, 9}, {7, 8}, {20, 20}};
            record.pathLength = moves[planner][record.repetition];
        }));
    const Figure &figure = named(figures, "overall-ranks-path_length");
    EXPECT_EQ(figure.series[0].label, "first");
    EXPECT_EQ(figure.series[0].meanRank, 1);
    EXPECT_EQ(figure.series[1].meanRank, 2);
}

TEST(ScalingFigure, SplitsEachPlannerWhereItsOwnSizesSay)
{
    const auto figures = campaignFigures(growing().run(
        [](RunRecord &record, std::size_t planner)
        {
            cost(record, planner);
            if (planner == 1 && *record.sweepValue > 8)
                record.status = PlannerStatus::timeout;
        }));
    const Figure &figure = named(figures, "fr_vg-grid-scaling-time");
    EXPECT_NEAR(*figure.series[0].heldOutFrom, std::sqrt(64.0 * 81), 1e-9);
    EXPECT_NEAR(*figure.series[1].heldOutFrom, std::sqrt(36.0 * 49), 1e-9);
    EXPECT_THAT(figure.caption, ::testing::HasSubstr("second: the power law"));
    EXPECT_THAT(
        figure.caption,
        ::testing::HasSubstr("3 sizes left out, where no more than half of the instances were solved"));
}

TEST(BoxesFigure, IsOverWhatAllItsPlannersSolved)
{
    const auto figures = campaignFigures(growing().run(cost));
    const Figure &figure = named(figures, "overall-boxes-path_length");
    for (const FigureSeries &series : figure.series)
        EXPECT_EQ(series.sample.size(), 45U);
}

TEST(Figures, DrawNoBandOfFewInstances)
{
    FakeCampaign campaign("few", 2);
    campaign.planner("first").sweep("m", "grid", "robots", {1, 2}, [](double) { return treeInstance(); });
    const std::string script =
        gnuplotScript(named(campaignFigures(campaign.run(cost)), "m-grid-path_length"));
    EXPECT_THAT(script, ::testing::Not(::testing::HasSubstr("filledcurves")));
    EXPECT_THAT(script, ::testing::Not(::testing::HasSubstr("errorbars")));
}

TEST(AnytimeFigure, IsLeftOutWhereNothingChanges)
{
    FakeCampaign campaign("watched");
    campaign.planner("first").problem("m", "tree", treeInstance());
    const ResultTable plain = campaign.run(cost);
    const ResultTable results(campaign.plan(), plain.records(), {},
                              [](const std::string &)
                              {
                                  Progress progress;
                                  progress.names = {"fallbacks"};
                                  for (int i = 1; i <= 4; ++i)
                                      progress.samples.push_back({0.1 * i, {0}});
                                  return progress;
                              });
    for (const Figure &figure : campaignFigures(results).figures)
        EXPECT_THAT(figure.name, ::testing::Not(::testing::HasSubstr("anytime")));
}

TEST(AskedFigure, OfTooManyCurvesIsRefused)
{
    FakeCampaign campaign = growing();
    ChartRequest curves;
    curves.x = "vertices";
    curves.y = "path_length";
    curves.per = "run_key"; // a curve for each run
    campaign.plan().charts = {curves};
    campaign.plan().automaticCharts = false;
    const auto [figures, complaints] = campaignFigures(campaign.run(cost));
    EXPECT_TRUE(figures.empty());
    ASSERT_EQ(complaints.size(), 1U);
    EXPECT_THAT(complaints[0], ::testing::HasSubstr("curves are too many to tell apart (at most 24)"));
}

TEST(AskedFigure, IsWhatThePlanSays)
{
    FakeCampaign campaign = growing();
    ChartRequest curves;
    curves.x = "vertices";
    curves.y = "path_length";
    curves.per = "repetition";
    curves.logY = true;
    curves.title = "Mine";
    ChartRequest boxes;
    boxes.kind = "boxes";
    boxes.y = "time";
    ChartRequest impossible;
    impossible.x = "robots";
    impossible.y = "optimized_sum_of_costs";
    campaign.plan().charts = {curves, boxes, impossible};
    campaign.plan().automaticCharts = false;
    const auto [figures, complaints] = campaignFigures(campaign.run(cost));
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[0].name, "chart-curves-path_length-vertices-repetition");
    EXPECT_EQ(figures[0].title, "Mine");
    EXPECT_EQ(figures[0].series.size(), 15U);
    EXPECT_EQ(figures[0].series[1].label, "first, repetition 1");
    EXPECT_EQ(figures[0].logY, true);
    EXPECT_EQ(figures[1].series[1].sample.size(), 45U);
    EXPECT_THAT(
        complaints,
        ::testing::ElementsAre("chart-curves-optimized_sum_of_costs-robots: nowhere do more than half of the "
                               "instances have both robots and optimized_sum_of_costs"));
}

TEST(AskedFigure, ShowsHowOneCostGrowsWithAnother)
{
    FakeCampaign campaign = growing();
    ChartRequest scaling;
    scaling.kind = "scaling";
    scaling.x = "path_length";
    scaling.y = "time";
    campaign.plan().charts = {scaling};
    campaign.plan().automaticCharts = false;
    const auto figures = campaignFigures(campaign.run(
        [](RunRecord &record, std::size_t planner)
        {
            cost(record, planner);
            record.pathLength = static_cast<std::size_t>(std::pow(*record.vertices, 4));
        }));
    const Figure &figure = named(figures, "chart-scaling-time-path_length");
    EXPECT_THAT(figure.series[0].remark, ::testing::StartsWith(" ∝ n^0.50 ["));
    EXPECT_EQ(figure.series[0].points.back().at, 121.0 * 121 * 121 * 121);
    EXPECT_EQ(figure.variable, "Path length (moves)");
    EXPECT_THAT(figure.caption, ::testing::HasSubstr("against the path length n"));
}

TEST(Axis, OfLongNumbersLeavesRoomForItsTitle)
{
    FakeCampaign campaign("long", 1);
    campaign.planner("first").sweep("m", "grid", "robots", {1, 2}, [](double) { return treeInstance(); });
    const auto figures = campaignFigures(campaign.run(
        [](RunRecord &record, std::size_t)
        {
            solveSmoothly(record, 0);
            record.pathLength = 1'200'000 + record.sweepValue.value_or(0);
        }));
    const std::string script = gnuplotScript(named(figures, "m-grid-path_length"));
    EXPECT_THAT(script, ::testing::HasSubstr("'1\u202F000\u202F000' 1000000"));
    // Title at 0.55 cm, nine digits and blanks of a fifth of a centimetre: the panel begins at 3.1 of 16 cm.
    EXPECT_THAT(script, ::testing::HasSubstr("set lmargin at screen 0.19344"));
}

TEST(ChartsReport, DrawsOnlyWhatChanged)
{
    const TemporaryFolder folder;
    const ResultTable results = growing().run(cost);
    (void)ChartsReport().write(results, fakeProvenance(), folder.path());
    const auto figures = folder.path() / "figures";
    const std::string kept = readFile(figures / "overall-cactus-time.svg");
    writeFile(figures / "overall-cactus-time.svg", kept + "<!-- still the old one -->");
    const std::string changed = readFile(figures / "overall-profile-time.svg");
    writeFile(figures / "overall-profile-time.svg", changed + "<!-- drawn again -->");
    writeFile(figures / "overall-profile-time.gp",
              readFile(figures / "overall-profile-time.gp") + "# edited\n");
    (void)ChartsReport().write(results, fakeProvenance(), folder.path());
    EXPECT_NE(readFile(figures / "overall-cactus-time.svg"), kept);
    EXPECT_EQ(readFile(figures / "overall-profile-time.svg"), changed);
}

} // namespace
} // namespace mrpp
