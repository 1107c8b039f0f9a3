#include "reports/layouts/GraphvizGraph.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/LayoutsReport.h"
#include "tests/reports/Campaigns.h"
#include "tests/reports/EnvironmentVariable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

/// What a drawing complains of where `neato` is this shell script.
std::string complaintWith(const std::string &script)
{
    const TemporaryFolder folder;
    const std::filesystem::path neato = folder.path() / "neato";
    writeFile(neato, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(neato, std::filesystem::perms::owner_all);
    const EnvironmentVariable path("PATH", folder.path().string() + ":/usr/bin:/bin");
    GraphvizGraph graph{std::chrono::milliseconds(500)};
    graph.addNode();
    try
    {
        (void)graph.renderPinned(72);
    }
    catch (const DrawingError &error)
    {
        return error.what();
    }
    return "";
}

TEST(GraphvizGraph, SurvivesItsProgramsCrash)
{
    EXPECT_THAT(complaintWith("kill -SEGV $$"), ::testing::HasSubstr("failed (it crashed)"));
}

TEST(GraphvizGraph, SurvivesItsProgramsHang)
{
    EXPECT_EQ(complaintWith("exec sleep 600"), "Graphviz' program neato did not end in time");
}

TEST(GraphvizGraph, SaysWhatWentWrong)
{
    EXPECT_EQ(complaintWith("echo no memory; exit 1"), "Graphviz' program neato failed: no memory ");
    EXPECT_EQ(complaintWith("exit 0"), "Graphviz wrote no picture: there is no such file");
}

TEST(GraphvizGraph, MissingCostsThePicturesAlone)
{
    const TemporaryFolder folder;
    const EnvironmentVariable path("PATH", folder.path().string());
    FakeCampaign campaign("missing");
    campaign.planner("a").problem("m", "tree", treeInstance());
    const auto files = LayoutsReport().write(campaign.run(solveSmoothly), fakeProvenance(), folder.path());
    ASSERT_EQ(files.size(), 1U);
    EXPECT_THAT(readFile(files[0]),
                ::testing::HasSubstr("neato cannot be started; install it (Debian: graphviz)"));
}

TEST(GraphvizGraph, LabelsMeanThemselves)
{
    GraphvizGraph graph;
    graph.setDefault(GraphvizGraph::Kind::graph, "label", GraphvizGraph::escaped("\\N \"x\" & <b>\\"));
    graph.setDefault(GraphvizGraph::Kind::node, "pos", "0,0");
    graph.addNode();
    EXPECT_THAT(graph.renderPinned(72).svg,
                ::testing::HasSubstr(">\\N &quot;x&quot; &amp; &lt;b&gt;\\</text>"));
}

} // namespace
} // namespace mrpp
