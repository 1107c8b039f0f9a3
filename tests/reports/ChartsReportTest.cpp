#include "reports/ChartsReport.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/PdfReport.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/EnvironmentVariable.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <map>
#include <pugixml.hpp>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

FakeCampaign sweep(std::size_t planners)
{
    FakeCampaign campaign("demo", 3);
    campaign.planners(planners).sweep("fg_vr", "grid", "robots", {1, 2, 3},
                                      [](double) { return treeInstance(); });
    return campaign;
}

std::map<std::string, std::string> contents(const std::filesystem::path &folder)
{
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(folder).string()] = readFile(entry.path());
    return files;
}

void expectWellFormed(const std::filesystem::path &svg)
{
    pugi::xml_document document;
    const auto result = document.load_file(svg.c_str());
    EXPECT_TRUE(result) << svg << ": " << result.description();
    EXPECT_STREQ(document.document_element().name(), "svg") << svg;
}

TEST(ChartsReport, WritesEveryFigureInFiveFiles)
{
    const TemporaryFolder folder;
    const auto files = ChartsReport().write(sweep(3).run(solveSmoothly), fakeProvenance(), folder.path());
    EXPECT_EQ(files.size(), 66U); // thirteen figures, and why planners are not ranked
    for (const auto &file : files)
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    expectWellFormed(folder.path() / "figures" / "fg_vr-grid-time.svg");
    EXPECT_TRUE(readFile(folder.path() / "figures" / "fg_vr-grid-time.png").starts_with("\x89PNG"));
    EXPECT_TRUE(readFile(folder.path() / "figures" / "fg_vr-grid-time.pdf").starts_with("%PDF-"));
}

TEST(ChartsReport, WritesTheSameBytesAgain)
{
    const ResultTable results = sweep(2).run(solveSmoothly);
    const TemporaryFolder first;
    const TemporaryFolder second;
    (void)ChartsReport().write(results, fakeProvenance(), first.path());
    (void)ChartsReport().write(results, fakeProvenance(), second.path());
    EXPECT_EQ(contents(first.path()), contents(second.path()));
}

TEST(ChartsReport, NamesNeitherBreakItNorRunAnything)
{
    const TemporaryFolder folder;
    const std::string marker = (folder.path() / "MARKER").string();
    const std::vector<std::string> names = {
        "`touch " + marker + "`",
        "$(touch " + marker + ")",
        "\"`touch " + marker + "`\"",
        "it's 'quoted' ''twice''",
        "a\nsystem('touch " + marker + "')\n!touch " + marker,
        "\\\\ \\n %d %s 100% {/Bold x} _a^b @file_name",
        "<b>&amp;</b> ]]> <!--",
        "e\n\xFF\xC3 \xE2\x80\xAE",
        "'; system('touch " + marker + "'); '",
        "''; system(\"touch " + marker + "\"); ''",
        "'''; system(\"touch " + marker + "\"); x = '''",
        "\\'; system(\"touch " + marker + "\"); x = \\'",
        "'",
    };
    FakeCampaign campaign("`touch " + marker + "`", 2);
    for (const std::string &name : names)
        campaign.planner(name);
    campaign.sweep("fg_vr", names[0], "robots", {1, 2}, [](double) { return treeInstance(); });
    for (const std::string &name : names)
        campaign.problem("small_benchmark", name, treeInstance());
    const ResultTable results = campaign.run(solveSmoothly);

    const auto files = ChartsReport().write(results, fakeProvenance(), folder.path() / "out");
    EXPECT_EQ(files.size(), 115U) // 23 figures, no complaint
        << (files.back().extension() == ".txt" ? readFile(files.back()) : "");
    for (const auto &file : files)
        if (file.extension() == ".svg")
            expectWellFormed(file);
    EXPECT_FALSE(std::filesystem::exists(marker));
    const std::string svg = readFile(folder.path() / "out" / "figures" / "small_benchmark-time.svg");
    EXPECT_NE(svg.find("`touch "), std::string::npos); // shown as it is
}

TEST(ChartsReport, WithoutGnuplotKeepsScriptsAndSaysWhy)
{
    const TemporaryFolder folder;
    const EnvironmentVariable path("PATH", folder.path().string());
    const ResultTable results = sweep(1).run(solveSmoothly);
    const auto files = ChartsReport().write(results, fakeProvenance(), folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "figures" / "fg_vr-grid-time.gp"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "figures" / "fg_vr-grid-time.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "figures" / "fg_vr-grid-time.pdf"));
    ASSERT_EQ(files.back().filename(), "NOT_DRAWN.txt");
    EXPECT_NE(readFile(files.back()).find("gnuplot cannot be started; install it"), std::string::npos);

    (void)PdfReport().write(results, fakeProvenance(), folder.path());
    EXPECT_TRUE(readFile(folder.path() / "report.pdf").starts_with("%PDF-"));
}

TEST(ChartsReport, TakesOldComplaintsBack)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / "figures" / "NOT_DRAWN.txt", "old");
    (void)ChartsReport().write(sweep(1).run(solveSmoothly), fakeProvenance(), folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "figures" / "NOT_DRAWN.txt"));
}

TEST(ChartsReport, OfNothingWritesNothing)
{
    const TemporaryFolder folder;
    const ResultTable results(FakeCampaign("empty").planners(1).plan(), {}, {});
    EXPECT_TRUE(ChartsReport().write(results, fakeProvenance(), folder.path()).empty());
}

TEST(ChartsReport, ThrowsWhereItCannotWrite)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / "file", "");
    EXPECT_THROW(
        (void)ChartsReport().write(sweep(1).run(solveSmoothly), fakeProvenance(), folder.path() / "file"),
        FileError);
}

} // namespace
} // namespace mrpp
