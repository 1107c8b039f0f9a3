#include "reports/LayoutsReport.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/layouts/CampaignLayouts.h"
#include "reports/layouts/GraphvizGraph.h"
#include "reports/layouts/LayoutPicture.h"
#include "tests/reports/Campaigns.h"

#include <cmath>
#include <gtest/gtest.h>
#include <pugixml.hpp>
#include <thread>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;

Picture drawInstance(const Instance &instance, const Solution *solution, const std::string &title)
{
    return mrpp::drawInstance(instance, solution, placeGraph(*instance.graph), title);
}

/// The element of that id; also asserts that the SVG is well-formed.
pugi::xml_node element(pugi::xml_document &document, const std::string &svg, const std::string &id)
{
    EXPECT_TRUE(document.load_string(svg.c_str()));
    return document.find_node([&](const pugi::xml_node &node) { return node.attribute("id").value() == id; });
}

/// Where Graphviz drew a vertex.
std::pair<double, double> center(const std::string &svg, Vertex v)
{
    pugi::xml_document document;
    const auto node =
        element(document, svg, "vertex" + std::to_string(v))
            .find_node([](const pugi::xml_node &child) { return std::string(child.name()) == "ellipse"; });
    return {node.attribute("cx").as_double(), node.attribute("cy").as_double()};
}

std::string text(const pugi::xml_node &node)
{
    std::string words;
    for (const pugi::xml_node &child : node.children())
        words += std::string(child.value()) + text(child);
    return words;
}

const Solution kTreeRoutes({{0, 1, 0},
                            {1, 4, 3},
                            {1, 3, 1},
                            {1, 1, 2},
                            {0, 0, 1},
                            {0, 1, 3},
                            {2, 6, 4},
                            {2, 4, 5},
                            {0, 3, 4},
                            {0, 4, 6},
                            {1, 2, 1},
                            {2, 5, 4}});

TEST(DrawInstance, KeepsCoordinatesAndTheirDirection)
{
    Instance instance = treeInstance(); // vertex 0 at (0, 0), 6 at (1, 3), y downwards
    const std::string svg = drawInstance(instance, nullptr, "tree").svg;
    EXPECT_NEAR(center(svg, 0).second, center(svg, 2).second, 0.1);
    EXPECT_GT(center(svg, 6).second, center(svg, 0).second + 100); // SVG's y grows downwards
    EXPECT_NEAR(center(svg, 1).first, center(svg, 6).first, 0.1);

    std::vector<Point> coordinates(instance.graph->coordinates().begin(),
                                   instance.graph->coordinates().end());
    instance.graph = Graph::fromEdges(7, instance.graph->edges(), coordinates, YAxis::up);
    const std::string turned = drawInstance(instance, nullptr, "tree").svg;
    EXPECT_LT(center(turned, 6).second, center(turned, 0).second - 100);
}

TEST(DrawInstance, ShowsStartsGoalsAndRoutes)
{
    const std::string svg = drawInstance(treeInstance(), &kTreeRoutes, "tree").svg;
    pugi::xml_document document;
    // Robot 0 starts on vertex 1, which is robot 1's goal.
    const std::string vertex = text(element(document, svg, "vertex1"));
    EXPECT_NE(vertex.find("⚑1"), std::string::npos) << vertex;
    EXPECT_NE(svg.find("vertex 1, start of robot 0, goal of robot 1"), std::string::npos);
    EXPECT_NE(svg.find("robots 2, 0"), std::string::npos); // both used some edge
    EXPECT_NE(svg.find("goal, ⚑ with the robot&#39;s number"), std::string::npos);
    EXPECT_TRUE(element(document, svg, "edge1-3"));
}

TEST(DrawInstance, ArrangesGraphsWithoutCoordinates)
{
    const std::string svg = drawInstance(gridInstance(5, 3, false), nullptr, "grid").svg;
    double nearest = 1e9;
    for (Vertex a = 0; a < 25; ++a)
        for (Vertex b = a + 1; b < 25; ++b)
            nearest = std::min(nearest, std::hypot(center(svg, a).first - center(svg, b).first,
                                                   center(svg, a).second - center(svg, b).second));
    EXPECT_GT(nearest, 31); // no two discs overlap
}

TEST(DrawInstance, ArrangesGraphsWhoseCoordinatesCoincide)
{
    const std::vector<Graph::Edge> edges = {{0, 1}, {1, 2}};
    const Instance instance{Graph::fromEdges(3, edges, {{0, 0}, {0, 0}, {1, 0}}), {0}, {2}};
    EXPECT_EQ(placeByCoordinates(*instance.graph, 50), std::nullopt);
    const std::string svg = drawInstance(instance, nullptr, "").svg;
    EXPECT_NE(center(svg, 0), center(svg, 1));
}

TEST(DrawInstance, GivesTheSameBytesAgain)
{
    for (const Instance &instance : {treeInstance(), gridInstance(18, 5, false), gridInstance(75, 40)})
    {
        const Picture first = drawInstance(instance, nullptr, "same");
        const Picture second = drawInstance(instance, nullptr, "same");
        EXPECT_EQ(first.svg, second.svg);
        EXPECT_EQ(first.png, second.png);
        EXPECT_EQ(first.pdf, second.pdf);
    }
}

TEST(DrawInstance, DrawsMapsOfLargerGraphs)
{
    const Instance instance = gridInstance(80, 6);
    Solution solution;
    solution.append({0, 0, 80});
    const Picture picture = drawInstance(instance, &solution, "map & <b>");
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(picture.svg.c_str()));
    EXPECT_TRUE(picture.pdf.starts_with("%PDF-"));
    EXPECT_LT(picture.svg.size(), 200'000U); // rows of cells, not single ones
}

TEST(DrawInstance, ShowsWhereManyRobotsWentAsHeat)
{
    const Instance instance = gridInstance(80, 70);
    Solution solution;
    for (Vertex v = 0; v < 70; ++v)
        for (int turn = 0; turn < 3; ++turn)
        {
            solution.append({v, v, v + 80});
            solution.append({v, v + 80, v});
        }
    const Picture picture = drawInstance(instance, &solution, "crowded");
    EXPECT_NE(picture.svg.find("rgb(99.607843%,90.980392%,78.431373%)"),
              std::string::npos); // the scale's first colour
    const Picture again = drawInstance(instance, &solution, "crowded");
    EXPECT_EQ(picture.pdf, again.pdf);
    EXPECT_EQ(picture.svg, again.svg);
}

TEST(DrawInstance, RefusesWhatIsTooLarge)
{
    EXPECT_THROW((void)placeGraph(*gridInstance(71, 1, false).graph), DrawingError); // 5041 vertices
    EXPECT_THROW((void)placeGraph(*gridInstance(55, 1, false).graph), DrawingError); // 3025 vertices
    EXPECT_THROW((void)placeGraph(Graph()), DrawingError);
}

TEST(DrawInstance, DrawsTheLargestGraphThatGraphvizGets)
{
    const Picture picture = drawInstance(gridInstance(70, 200), nullptr, "4900 vertices");
    EXPECT_NE(picture.svg.find("vertex4899"), std::string::npos);
}

TEST(DrawInstance, TakesTitlesLiterally)
{
    const std::string svg = drawInstance(treeInstance(), nullptr, "\\G \\N &lt; <b> \\").svg;
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(svg.c_str()));
    EXPECT_NE(text(document).find("\\G \\N &lt; <b> \\"), std::string::npos) << text(document);
}

TEST(DrawInstance, MayBeCalledFromSeveralThreads)
{
    std::vector<std::string> drawings(4);
    {
        std::vector<std::jthread> threads;
        for (std::string &drawing : drawings)
            threads.emplace_back([&drawing]
                                 { drawing = drawInstance(treeInstance(), &kTreeRoutes, "threads").svg; });
    }
    for (const std::string &drawing : drawings)
        EXPECT_EQ(drawing, drawings[0]);
    EXPECT_FALSE(drawings[0].empty());
}

TEST(EdgeUsers, ListsEachRobotOnceInOrderOfUse)
{
    const auto users = edgeUsers(*treeInstance().graph, kTreeRoutes, 2);
    // Edges in order: 0-1, 1-2, 1-3, 3-4, 4-5, 4-6.
    const std::vector<std::vector<Robot>> expected = {{0}, {1}, {1, 0}, {1, 0}, {2}, {2, 0}};
    EXPECT_EQ(users, expected);
}

TEST(PlaceByCoordinates, PutsNeighboursAtTheAskedDistance)
{
    const auto placement = placeByCoordinates(*gridInstance(3, 1).graph, 60);
    ASSERT_TRUE(placement);
    EXPECT_EQ(placement->spacing, 60);
    EXPECT_EQ(placement->positions[0], (Point{0, 120, 0}));
    EXPECT_EQ(placement->positions[8], (Point{120, 0, 0}));
}

TEST(PlannedLayouts, TakeTheEndsOfASweepAndOneOfEachProblem)
{
    const ResultTable results =
        FakeCampaign("layouts", 3)
            .planners(2)
            .problem("small_benchmark", "tree", treeInstance())
            .sweep("fg_vr", "grid", "robots", {3, 1, 2},
                   [](double robots) { return gridInstance(4, static_cast<std::size_t>(robots)); })
            .run(solveSmoothly);
    std::string names;
    for (const LayoutPlan &plan : plannedLayouts(results))
    {
        names += plan.name + " ";
        EXPECT_EQ(plan.runs.size(), 2U); // both planners, the first repetition
        EXPECT_EQ(plan.showsStructure, plan.name != "fg_vr-grid-robots-3"); // the graph of the plan before
    }
    EXPECT_EQ(names, "small_benchmark-tree fg_vr-grid-robots-1 fg_vr-grid-robots-3 ");
}

TEST(LayoutsReport, DrawsWhatItCanAndSaysWhatItCannot)
{
    const TemporaryFolder folder;
    const ResultTable results = FakeCampaign("layouts")
                                    .planners(1)
                                    .problem("small_benchmark", "tree", treeInstance())
                                    .problem("public_benchmark", "huge", gridInstance(80, 2, false))
                                    .solution("tree", kTreeRoutes)
                                    .run(solveSmoothly);
    const auto files = LayoutsReport().write(results, fakeProvenance(), folder.path());
    ASSERT_EQ(files.size(), 13U);
    for (const char *name :
         {"small_benchmark-tree", "small_benchmark-tree-structure", "small_benchmark-tree-steps"})
        for (const char *extension : {".svg", ".pdf", ".png", ".txt"})
            EXPECT_TRUE(std::filesystem::exists(folder.path() / "layouts" / (std::string(name) + extension)));
    EXPECT_EQ(
        readFile(folder.path() / "layouts" / "NOT_DRAWN.txt"),
        "public_benchmark-huge: 6400 vertices are too many for Graphviz (at most 5000), and there are no "
        "coordinates to draw a map from\n");
    EXPECT_NE(readFile(folder.path() / "layouts" / "small_benchmark-tree.svg").find("robots 2, 0"),
              std::string::npos);
}

TEST(LayoutsReport, DrawsOnlyWhatHasChanged)
{
    const TemporaryFolder folder;
    const auto campaign = [](const Solution &treeRoutes)
    {
        return FakeCampaign("layouts")
            .planners(1)
            .problem("small_benchmark", "tree", treeInstance())
            .problem("small_benchmark", "grid", gridInstance(3, 2))
            .solution("tree", treeRoutes)
            .run(solveSmoothly);
    };
    const auto report = [&](const Solution &treeRoutes)
    { return LayoutsReport().write(campaign(treeRoutes), fakeProvenance(), folder.path()); };
    const auto path = [&](const char *name) { return folder.path() / "layouts" / name; };
    const auto mark = [&]
    {
        for (const char *name : {"small_benchmark-tree.svg", "small_benchmark-tree-structure.svg",
                                 "small_benchmark-tree-steps.svg", "small_benchmark-grid.svg"})
            writeFile(path(name), "<svg></svg><!-- kept -->");
    };
    const auto isKept = [&](const char *name) { return readFile(path(name)).ends_with("<!-- kept -->"); };

    const auto files = report(kTreeRoutes);
    const std::string tree = readFile(path("small_benchmark-tree.svg"));
    EXPECT_TRUE(readFile(path("small_benchmark-tree-structure.txt"))
                    .starts_with("tree: structure of its graph of 7 vertices, 6 edges: 6 isthmuses"));
    mark();
    EXPECT_EQ(report(kTreeRoutes), files);
    for (const char *name : {"small_benchmark-tree.svg", "small_benchmark-tree-structure.svg",
                             "small_benchmark-tree-steps.svg", "small_benchmark-grid.svg"})
        EXPECT_TRUE(isKept(name)) << name;
    const ResultTable results = campaign(kTreeRoutes);
    const auto forPdf = drawLayouts(results, plannedLayouts(results).front(), folder.path() / "layouts");
    EXPECT_EQ(forPdf.front().picture.svg, "<svg></svg><!-- kept -->");

    Solution longer = kTreeRoutes;
    longer.append({2, 3, 4});
    (void)report(longer);
    EXPECT_FALSE(isKept("small_benchmark-tree.svg"));
    EXPECT_FALSE(isKept("small_benchmark-tree-steps.svg"));
    EXPECT_TRUE(isKept("small_benchmark-grid.svg"));

    (void)report(kTreeRoutes);
    EXPECT_EQ(readFile(path("small_benchmark-tree.svg")), tree);
    std::filesystem::remove(path("small_benchmark-grid.pdf")); // one that is damaged
    (void)report(kTreeRoutes);
    EXPECT_TRUE(std::filesystem::exists(path("small_benchmark-grid.pdf")));
    EXPECT_FALSE(isKept("small_benchmark-grid.svg"));
}

TEST(LayoutsReport, ThrowsWhereItCannotWrite)
{
    const TemporaryFolder folder;
    writeFile(folder.path() / "file", "");
    const ResultTable results =
        FakeCampaign("x").planners(1).problem("m", "tree", treeInstance()).run(solveSmoothly);
    EXPECT_THROW((void)LayoutsReport().write(results, fakeProvenance(), folder.path() / "file"), FileError);
}

} // namespace
} // namespace mrpp
