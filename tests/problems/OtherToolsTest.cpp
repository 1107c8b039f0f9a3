/// Files as other tools write them, with all that their writers add, read through the one door.

#include "problems/formats/Conversion.h"
#include "problems/formats/Formats.h"

#include "framework/evaluation/Validator.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

class OtherTools : public testing::Test
{
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::path(testing::TempDir()) / ("mrpp_tools_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(const std::string &name, const std::string &text) const
    {
        writeFile(folder_ / name, text);
        return folder_ / name;
    }

    LoadedInstance instance(const std::string &name, const std::string &text) const
    {
        return loadInstance({file(name, text), std::nullopt, std::nullopt});
    }

    /// Whether a solution's file takes the robots to their goals.
    bool solves(const LoadedInstance &loaded, const std::string &name, const std::string &text) const
    {
        const SolutionRows rows = loadSolution(file(name, text), loaded);
        return validate(loaded.instance, rows.moves, MotionRule::rotation).valid();
    }

    template <class Work>
    std::string complaint(Work &&work) const
    {
        try
        {
            (void)work();
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "nothing was wrong";
    }

    std::filesystem::path folder_;
};

/// yEd's file of three boxes, two of them in a group; `edges` go behind.
std::string yEd(const std::string &edges)
{
    const auto box = [](const std::string &id, const char *x)
    {
        return "<node id=\"" + id + "\"><data key=\"d5\" xml:space=\"preserve\"><![CDATA[]]></data>" +
               "<data key=\"d6\"><y:ShapeNode><y:Geometry height=\"30.0\" width=\"30.0\" x=\"" + x +
               "\" y=\"50.0\"/><y:NodeLabel>" + id +
               "</y:NodeLabel></y:ShapeNode></data><port name=\"p\"/></node>";
    };
    return "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\r\n"
           "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" "
           "xmlns:y=\"http://www.yworks.com/xml/graphml\">"
           "<!--Created by yEd--><key for=\"port\" id=\"d1\" yfiles.type=\"portgraphics\"/>"
           "<key attr.name=\"description\" attr.type=\"string\" for=\"node\" id=\"d5\"/>"
           "<key for=\"node\" id=\"d6\" yfiles.type=\"nodegraphics\"/>"
           "<key for=\"graphml\" id=\"d7\" yfiles.type=\"resources\"/>\r\n"
           "<graph edgedefault=\"directed\" id=\"G\"><node id=\"n0\" yfiles.foldertype=\"group\">"
           "<data key=\"d6\"><y:ProxyAutoBoundsNode><y:Realizers "
           "active=\"0\"/></y:ProxyAutoBoundsNode></data>"
           "<graph edgedefault=\"directed\" id=\"n0:\">" +
           box("n0::n0", "100.0") + box("n0::n1", "160.0") +
           "<edge id=\"n0::e0\" source=\"n0::n0\" target=\"n0::n1\"/></graph></node>" + box("n1", "220.0") +
           edges + "</graph><data key=\"d7\"><y:Resources/></data></graphml>";
}

TEST_F(OtherTools, YEdsGroupsAreDissolved)
{
    const LoadedGraph read = loadGraph(
        file("y.graphml", yEd("<edge id=\"e0\" source=\"n0::n1\" target=\"n1\" sourceport=\"p\"/>")));
    ASSERT_EQ(read.graph->vertexCount(), 3U);
    EXPECT_TRUE(read.graph->hasEdge(0, 1));
    EXPECT_TRUE(read.graph->hasEdge(1, 2));
    EXPECT_EQ(read.graph->coordinate(2), (Point{235, 65, 0}));
    EXPECT_THAT(read.warnings, testing::Contains(HasSubstr("1 group is dissolved")));
    EXPECT_THAT(
        complaint([this]
                  { return loadGraph(file("y.graphml", yEd("<edge source=\"n1\" target=\"n0\"/>"))); }),
        HasSubstr("y.graphml:3:"));
    EXPECT_THAT(
        complaint([this]
                  { return loadGraph(file("y.graphml", yEd("<edge source=\"n1\" target=\"n0\"/>"))); }),
        HasSubstr("the edge's target is the group 'n0'"));
    EXPECT_THAT(complaint([this] { return loadGraph(file("y.graphml", yEd("<node id=\"n0\"/>"))); }),
                HasSubstr("the id 'n0' belongs to the node in line 3 already"));
}

TEST_F(OtherTools, TextInGraphMlIsReadWholeOrNotAtAll)
{
    const auto graph = [](const std::string &data)
    {
        return "<graphml><key id=\"k\" for=\"node\" attr.name=\"pos\"><!-- a --><default>7 8</default></key>"
               "<graph edgedefault=\"undirected\"><node id=\"a\">" +
               data + "</node></graph></graphml>";
    };
    const auto point = [&](const std::string &data)
    { return loadGraph(file("g.graphml", graph(data))).graph->coordinate(0); };
    EXPECT_EQ(point(""), (Point{7, 8, 0}));
    EXPECT_EQ(point("<data key='k'>\n <![CDATA[(1, 2)]]>\n</data>"), (Point{1, 2, 0}));
    EXPECT_THAT(complaint([&] { return point("<data key='k'>1 2<!-- and --> 3</data>"); }),
                HasSubstr("something stands amid the text"));
    EXPECT_THAT(complaint([this] { return loadGraph(file("u.graphml", std::string("\xFF\xFE<\0g\0", 6))); }),
                HasSubstr("this is a text in UTF-16"));
}

TEST_F(OtherTools, NetworkXsEdgesMayHaveAnyData)
{
    const LoadedGraph read =
        loadGraph(file("x.edgelist", "#/usr/bin/x.py\n# GMT Mon Nov 23 2026\n#\n"
                                     "0 1 {'pos': (1, [2]), 'n': \"it's }\", 'weight': 2.5}\n"
                                     "1 2 {'a': 'b\\'}, c', 'd': {'e': 1}}\n"));
    EXPECT_EQ(read.graph->edgeCount(), 2U);
    EXPECT_EQ(read.graph->edges()[0].weight, 2.5);
    EXPECT_THAT(complaint([this] { return loadGraph(file("x.edgelist", "0 1 {'a': (1, 2}\n")); }),
                HasSubstr("x.edgelist:1:17: expected '}' here"));
}

constexpr const char *kRoadmap = "agents:\n- goal: C\n  name: agent0\n  start: A\n"
                                 "roadmap:\n  allow_wait_actions: true\n"
                                 "  edges: [[A, B], [B, C], [\"0\", C]]\n  undirected: true\n"
                                 "  vertices: {A: [0, 0], B: [1, 0], C: [2, 0], \"0\": [3, 1]}\n";

TEST_F(OtherTools, RoadmapsNameTheirVertices)
{
    const LoadedInstance loaded = instance("r.yaml", kRoadmap);
    EXPECT_THAT(loaded.vertexNames, ElementsAre("A", "B", "C", "0"));
    const std::string schedule =
        "statistics:\n  cost: 2\n  makespan: 2\n  runtime: 0.001\nschedule:\n  agent0:\n"
        "    - v: A\n      t: 0\n    - v: B\n      t: 1\n    - v: C\n      t: 2\n";
    EXPECT_TRUE(solves(loaded, "s.yaml", schedule));
    EXPECT_THAT(
        complaint([&] { return solves(loaded, "t.yaml", "schedule:\n  agent0:\n    - v: 1\n      t: 0\n"); }),
        HasSubstr("t.yaml:3:10: there is no vertex '1'"));

    const auto again = folder_ / "again.yaml";
    EXPECT_THAT(convertFile({folder_ / "r.yaml", again, {}, {}, {}}).notes, testing::IsEmpty());
    EXPECT_EQ(loadInstance({again, {}, {}}).vertexNames, loaded.vertexNames);
    (void)convertFile({folder_ / "s.yaml", folder_ / "u.yaml", {}, again, "libmrp_schedule"});
    EXPECT_THAT(readFile(folder_ / "u.yaml"), HasSubstr("- v: \"B\"\n      t: 1\n"));
    EXPECT_THAT(convertFile({folder_ / "r.yaml", folder_ / "r.cpf", {}, {}, {}}).notes,
                ElementsAre("lost: the vertices' coordinates", "lost: the vertices' names"));
}

TEST_F(OtherTools, YamlInOneLineIsKnownByItsExtension)
{
    EXPECT_EQ(
        instance("f.yaml", "{agents: [{name: a, start: [0,0], goal: [1,0]}], map: {dimensions: [2,1]}}\n")
            .instance.robotCount(),
        1U);
}

TEST_F(OtherTools, TrackersDownloadsHoldAPlanForEachNumberOfRobots)
{
    (void)file("room.map", "type octile\nheight 1\nwidth 4\nmap\n....");
    const LoadedInstance two = instance("room.scen", "version 1.0\r\n0 room.map 4 1 0 0 1 0 1.0\r\n"
                                                     "0 maps/room.map 4 1 3 0 2 0 1.0");
    EXPECT_TRUE(solves(two, "new.csv",
                       "\xEF\xBB\xBFmap_name,scen_type,type_id,agents,solution_plan\r\n"
                       "room,even,1,1,\"r\"\r\nroom,even,1,2,\"r\nl\"\r\n"));
    EXPECT_TRUE(solves(two, "old",
                       "agents,lower_cost,lower_date,solution_cost,solution_date,path\n"
                       "1,1,2021-01-01,1,2021-02-02,r\n2,2,2021-01-01,2,2021-02-02,\"r\nl\"\n"));
    EXPECT_TRUE(solves(two, "s.json",
                       R"([{"agents":1,"solution_plan":["r"]},{"agents":"2","solution_plan":"r\nl"}])"));
    EXPECT_THAT(complaint([&] { return solves(two, "x.csv", "agents,solution_plan\n1,r\n3,r\n"); }),
                HasSubstr("there are 2 plans, but none of 2 robots"));
    EXPECT_THAT(complaint([&] { return solves(two, "x.csv", "agents,solution_plan\n2,r\n2,r\n"); }),
                HasSubstr("x.csv:3:1: a second plan of 2 robots"));
}

TEST_F(OtherTools, AScenarioNeedsNeitherVersionNorExtension)
{
    (void)file("a.map", "type tile\nwidth 2\nheight 1\nmap\n..\n\n");
    EXPECT_EQ(instance("records", "0\ta.map\t2\t1\t0\t0\t1\t0\t1\n").instance.robotCount(), 1U);
}

TEST_F(OtherTools, GraphRecMindsNoCase)
{
    const std::string text = "ID:-\nv =\n(0:-1)[1:0:0]\n(1:-1)[0:1:1]\ne =\n{0,1} (-1)\nB_SCN:A:#ffffff\n"
                             "MATRIX:1:0:0:1:0:0\nANGLE:3\n1 (0,1): 1 2 [3] {4}\nPOS =\n0:x0:y0\n1:X80:Y.5\n"
                             "Solution\n0 ------> 1 [0 ---> 0] (0)\nLENGTH:1";
    const LoadedInstance loaded = instance("g.txt", text);
    EXPECT_EQ(loaded.instance.graph->coordinate(1), (Point{80, .5, 0}));
    EXPECT_TRUE(solves(loaded, "g.txt", text));
}

TEST_F(OtherTools, GraphRecsXmlIsBlamedAtTheMovesLine)
{
    const LoadedInstance loaded = instance("p.cpf", "V =\n(0:-1)[1:0:0]\n(1:-1)[0:1:1]\nE =\n{0,1} (-1)\n");
    EXPECT_THAT(complaint(
                    [&]
                    {
                        return solves(
                            loaded, "g.xml",
                            "<!DOCTYPE graphrec>\n<graphrec version=\"1.0\"><solution id=\"1\"><graph>"
                            "<entity id=\"1\"/>\n<node id=\"1\" ent=\"1\"/><node id=\"2\"/>"
                            "<edge n1=\"1\" n2=\"2\"/></graph>\n<scenario validator=\"Pebble\">\n"
                            "<move tms=\"0\" src=\"1\" dst=\"2\"/>\n<move tms=\"1\" src=\"1\" dst=\"2\"/>"
                            "</scenario></solution></graphrec>\n");
                    }),
                HasSubstr("g.xml:6: nobody stands on vertex 0 in step 1"));
}

} // namespace
} // namespace mrpp
