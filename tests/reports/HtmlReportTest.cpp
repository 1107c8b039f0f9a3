#include "reports/HtmlReport.h"

#include "framework/store/SolutionCodec.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/explorer/ExplorerPage.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/Unpacked.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;
using Json = nlohmann::json;

const Solution kTreeRoutes({{0, 1, 0}, {1, 4, 3}, {0, 0, 1}, {1, 3, 4}, {2, 6, 4}, {2, 4, 3}});

class HtmlReportTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (!hasExplorer())
            GTEST_SKIP() << "this build has no explorer";
    }

    std::string page(const ResultTable &results)
    {
        const auto files = HtmlReport().write(results, fakeProvenance(), folder_.path());
        EXPECT_EQ(files, std::vector{folder_.path() / "report.html"});
        return readFile(folder_.path() / "report.html");
    }

    static Json about(const std::string &page) { return Json::parse(*dataBlock(page, "explorer")); }
    static Json runs(const std::string &page)
    {
        const auto bytes = unpacked(*dataBlock(page, "runs"));
        return Json::parse(bytes->begin(), bytes->end());
    }
    static std::string absence(const std::string &page, std::size_t run)
    {
        const Json absences = runs(page)["absences"];
        return absences["texts"][absences["rows"][run].get<std::size_t>()];
    }

    TemporaryFolder folder_;
};

FakeCampaign treeCampaign(std::int64_t repetitions = 3)
{
    FakeCampaign campaign("demo", repetitions);
    campaign.planners(2).problem("small_benchmark", "tree", treeInstance()).solution("tree", kTreeRoutes);
    return campaign;
}

TEST_F(HtmlReportTest, CarriesEveryRunWithItsNumbers)
{
    const ResultTable results = treeCampaign().run(solveSmoothly);
    const Json columns = runs(page(results))["columns"];
    ASSERT_EQ(columns.size(), runColumns().size());
    for (std::size_t i = 0; i < columns.size(); ++i)
        EXPECT_EQ(columns[i]["name"], runColumns()[i].name);
    for (const Json &column : columns)
    {
        if (column["name"] == "path_length")
        {
            for (std::size_t run = 0; run < results.records().size(); ++run)
                EXPECT_EQ(column["numbers"][run], *results.records()[run].pathLength);
        }
        if (column["name"] == "planner")
            EXPECT_EQ(column["texts"][column["rows"][1].get<std::size_t>()], "planner_1");
    }
}

TEST_F(HtmlReportTest, SolutionsComeBackAsTheyWere)
{
    const std::string html = page(treeCampaign().run(solveSmoothly));
    const auto bytes = unpacked(*dataBlock(html, "solution0"));
    ASSERT_TRUE(bytes);
    EXPECT_EQ(unpackSolution(*bytes), std::optional(kTreeRoutes));
    EXPECT_EQ(about(html)["cases"][0]["robots"], 3);
}

TEST_F(HtmlReportTest, ThePlanChoosesWhichSolutionsItCarries)
{
    FakeCampaign campaign = treeCampaign();
    const std::string first = page(campaign.run(solveSmoothly));
    EXPECT_EQ(about(first)["playable"].size(), 2U); // of each planner the first repetition
    EXPECT_EQ(absence(first, 0), "");
    EXPECT_EQ(absence(first, 2), "the plan says explorer: {solutions: first}");

    campaign.plan().explorer.solutions = "all";
    EXPECT_EQ(about(page(campaign.run(solveSmoothly)))["playable"].size(), 6U);

    campaign.plan().explorer.solutions = "none";
    const std::string none = page(campaign.run(solveSmoothly));
    EXPECT_TRUE(about(none)["playable"].empty());
    EXPECT_FALSE(dataBlock(none, "graph0"));
    EXPECT_EQ(absence(none, 0), "the plan says explorer: {solutions: none}");
}

TEST_F(HtmlReportTest, KeepsWithinItsSize)
{
    FakeCampaign campaign = treeCampaign();
    campaign.plan().explorer.size = 0.00001; // ten bytes
    const std::string html = page(campaign.run(solveSmoothly));
    EXPECT_TRUE(about(html)["playable"].empty());
    EXPECT_TRUE(absence(html, 0).starts_with("the page would be too large; the plan says explorer: {size: "));
}

TEST_F(HtmlReportTest, SaysWhyARunCannotBePlayed)
{
    const ResultTable results = treeCampaign(1).run(
        [](RunRecord &record, std::size_t planner)
        {
            if (planner == 0)
                record.status = PlannerStatus::timeout;
            else
                solveSmoothly(record, planner);
        });
    const std::string html = page(results);
    EXPECT_EQ(absence(html, 0), "it has no solution");
    EXPECT_EQ(absence(html, 1), "");
    EXPECT_EQ(about(html)["playable"][0]["run"], 1);
}

TEST_F(HtmlReportTest, CarriesOptimizedSolutionsThatAreAsLongAsRecorded)
{
    const Solution shorter({{0, 1, 0}, {0, 0, 1}});
    FakeCampaign campaign = treeCampaign(1);
    campaign.plan().optimizers = {{"shorten", "shorten", {}}};
    const auto html = [&](std::int64_t recorded)
    {
        const ResultTable fake = campaign.run(
            [&](RunRecord &record, std::size_t planner)
            {
                solveSmoothly(record, planner);
                record.optimizedPathLength = recorded;
            });
        return page(ResultTable(
            campaign.plan(), fake.records(), [](const std::string &) { return kTreeRoutes; }, {},
            [&](const Instance &, const Solution &) { return shorter; }));
    };
    const std::string good = html(2);
    EXPECT_TRUE(about(good)["playable"][0]["optimized"]);
    EXPECT_EQ(unpackSolution(*unpacked(*dataBlock(good, "optimized0"))), std::optional(shorter));
    EXPECT_FALSE(about(html(3))["playable"][0]["optimized"]);
}

TEST_F(HtmlReportTest, NoTextOfTheResultsIsPartOfThePage)
{
    const std::string nasty = "</script><script>alert(1)</script><img src=x onerror=alert(1)>";
    FakeCampaign campaign("demo");
    campaign.planner(nasty).problem("small_benchmark", nasty, treeInstance());
    campaign.plan().text = nasty;
    campaign.plan().campaign = nasty;
    const std::string html = page(campaign.run(
        [&](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.reason = nasty;
        }));
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    EXPECT_EQ(about(html)["planners"][0]["name"], nasty);
    EXPECT_EQ(about(html)["plan"], nasty);
}

TEST_F(HtmlReportTest, AsksForNothingFromOutside)
{
    const std::string html = page(treeCampaign().run(solveSmoothly));
    EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
    for (const char *forbidden :
         {"unsafe-inline", "unsafe-eval", "<script src", "<link rel=\"stylesheet\"", "@import"})
        EXPECT_EQ(html.find(forbidden), std::string::npos) << forbidden;
}

TEST_F(HtmlReportTest, KeepsWholeNumbersThatBrowsersWouldRound)
{
    const ResultTable results = treeCampaign(1).run(
        [](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, planner);
            record.extra["huge"] = std::int64_t{9007199254740993};
        });
    const Json columns = runs(page(results))["columns"];
    EXPECT_EQ(columns.back()["texts"][0], "9007199254740993");
}

TEST_F(HtmlReportTest, IsTheSameForTheSameResults)
{
    const ResultTable results = treeCampaign().run(solveSmoothly);
    EXPECT_EQ(page(results), page(results));
}

} // namespace
} // namespace mrpp
