/// Every malformed file is refused at its place, with a message that says what would be right.

#include "framework/support/Error.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/InstanceText.h"
#include "problems/formats/MovingAiScenario.h"
#include "problems/formats/SolutionCsv.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpp
{
namespace
{

enum class Kind
{
    map,
    scenario,
    graphMl,
    instance,
    solution,
};

struct Malformed
{
    const char *name;
    Kind kind;
    std::string contents;
    std::size_t line;
    std::size_t column;
    const char *fragment; ///< of the message
};

void PrintTo(const Malformed &file, std::ostream *out)
{
    *out << file.name;
}

constexpr const char *kMap = "type octile\nheight 4\nwidth 6\nmap\n......\n.@@.T.\n.@S.T.\n......\n";

void read(Kind kind, const std::string &text)
{
    switch (kind)
    {
    case Kind::map:
        (void)parseMovingAiMap(text, "bad");
        return;
    case Kind::scenario: {
        const Scenario scenario = parseMovingAiScenario(text, "bad");
        (void)scenarioInstance(scenario, parseMovingAiMap(kMap, "map"), scenario.records.size());
        return;
    }
    case Kind::graphMl:
        (void)parseGraphMl(text, "bad");
        return;
    case Kind::instance:
        (void)textInstance(parseInstanceText(text, "bad"), Graph::fromEdges(3, {{0, 1}, {1, 2}}));
        return;
    case Kind::solution:
        (void)parseSolutionCsv(text, "bad");
        return;
    }
}

/// A GraphML file of two nodes around what is tested; the contents begin in line 4.
std::string graphMl(const std::string &contents)
{
    return "<graphml>\n<key id=\"c\" for=\"node\" attr.name=\"Coordinate\"/>"
           "<key id=\"w\" for=\"edge\" attr.name=\"Weight\"/>\n"
           "<graph edgedefault=\"undirected\"><node id=\"n0\"/><node id=\"n1\"/>\n" +
           contents + "\n</graph>\n</graphml>\n";
}

/// Fig. 1 of the MRPPSim paper as it is printed, with its two mistakes.
constexpr const char *kFigure1 = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns"
xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns
http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">
<key id="key0" for="node" attr.name="Coordinate"
attr.type="string" />
<key id="key1" for="edge" attr.name="Weight"
attr.type="double" />
<graph id="G" edgedefault="undirected"
parse.nodeids="canonical" parse.edgeids="canonical"
parse.order="nodesfirst">
<node id="n0">
<data key="key0">0.0 0.0 0.0</data>
</node>
<node id="n1">
<data key="key0">1.0 0.0 0.0</data>
</node>
<node id="n2">
<data key="key0">2.0 0.0 0.0</data>
</node>
<edge id="e0" source="n0" target="n1">
<data key="key1">1</data>
</edge>
<edge id="e2" source="n1" target="n2">
<data key="key1">1</data>
</edge>
</edge>
<edge id="e3 source="n2" target="n0">
<data key="key1">1</data>
</edge>
</graph>
</graphml>
)";

const std::vector<Malformed> kFiles = {
    // Maps
    {"MapEmpty", Kind::map, "", 1, 1, "ends within the header"},
    {"MapOfAnotherFormat", Kind::map, "hello\n", 1, 1, "'hello' is no line of a map's header"},
    {"MapWithoutHeight", Kind::map, "type octile\nwidth 2\nmap\n..\n", 3, 1, "lacks a line 'height <rows>'"},
    {"MapWithoutWidth", Kind::map, "type octile\nheight 1\nmap\n..\n", 3, 1,
     "lacks a line 'width <columns>'"},
    {"MapWithoutMapLine", Kind::map, "type octile\nheight 1\nwidth 2\n..\n", 4, 1, "'..' is no line"},
    {"MapEndsInHeader", Kind::map, "type octile\nheight 1\n", 3, 1, "ends within the header"},
    {"MapHeightIsAWord", Kind::map, "type octile\nheight four\nwidth 2\nmap\n..\n", 2, 8,
     "'four' is no height"},
    {"MapHeightIsZero", Kind::map, "type octile\nheight 0\nwidth 2\nmap\n", 2, 8, "from 1 on"},
    {"MapWidthIsNegative", Kind::map, "type octile\nheight 1\nwidth -2\nmap\n..\n", 3, 7, "'-2' is no width"},
    {"MapWidthIsHuge", Kind::map, "type octile\nheight 1\nwidth 99999999999999999999\nmap\n..\n", 3, 7,
     "is no width"},
    {"MapHeightIsHuge", Kind::map, "type octile\nheight 9000000000000000000\nwidth 2\nmap\n..\n", 6, 1,
     "ends after 1 rows"},
    {"MapWidthTwice", Kind::map, "type octile\nheight 1\nwidth 2\nwidth 2\nmap\n..\n", 4, 1, "a second time"},
    {"MapRowTooShort", Kind::map, "type octile\nheight 2\nwidth 3\nmap\n...\n..\n", 6, 3,
     "the row has 2 cells, but the header says width 3"},
    {"MapRowTooLong", Kind::map, "type octile\nheight 2\nwidth 3\nmap\n....\n...\n", 5, 4,
     "the row has 4 cells"},
    {"MapRowBlank", Kind::map, "type octile\nheight 2\nwidth 3\nmap\n...\n\n...\n", 6, 1,
     "the row has 0 cells"},
    {"MapTooFewRows", Kind::map, "type octile\nheight 3\nwidth 2\nmap\n..\n..\n", 7, 1, "ends after 2 rows"},
    {"MapTooManyRows", Kind::map, "type octile\nheight 1\nwidth 2\nmap\n..\n..\n", 6, 1,
     "behind the last row"},
    {"MapUnknownSymbol", Kind::map, "type octile\nheight 1\nwidth 3\nmap\n.x.\n", 5, 2, "unknown symbol 'x'"},
    {"MapNulByte", Kind::map, std::string("type octile\nheight 1\nwidth 3\nmap\n.") + '\0' + ".\n", 5, 2,
     "unknown symbol '?'"},

    // Scenarios, on a map of 6 x 4
    {"ScenarioEmpty", Kind::scenario, "", 1, 1, "the file is empty"},
    {"ScenarioVersion2", Kind::scenario, "version 2\n", 1, 9, "version '2' is not known"},
    {"ScenarioTooFewFields", Kind::scenario, "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\n", 2, 20,
     "too few fields"},
    {"ScenarioTooManyFields", Kind::scenario, "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\t3\t9\n", 2, 9,
     "too many fields"},
    {"ScenarioGarbage", Kind::scenario, "version 1\nhello\n", 2, 6, "too few fields"},
    {"ScenarioBucketIsAWord", Kind::scenario, "version 1\nx\tm.map\t6\t4\t0\t0\t3\t0\t3\n", 2, 1,
     "'x' is no bucket"},
    {"ScenarioStartIsAWord", Kind::scenario, "version 1\n0\tm.map\t6\t4\tzero\t0\t3\t0\t3\n", 2, 13,
     "'zero' is no start x"},
    {"ScenarioGoalIsAFraction", Kind::scenario, "version 1\n0 m.map 6 4 0 0 3 0.5 3\n", 2, 19,
     "'0.5' is no goal y"},
    {"ScenarioLengthIsAWord", Kind::scenario, "version 1\n0 m.map 6 4 0 0 3 0 far\n", 2, 21,
     "'far' is no length"},
    {"ScenarioStartOutside", Kind::scenario, "version 1\n0\tm.map\t6\t4\t6\t0\t3\t0\t3\n", 2, 13,
     "the start's x is 6, but the map's width is 6"},
    {"ScenarioGoalOutside", Kind::scenario, "version 1\n0\tm.map\t6\t4\t0\t0\t3\t4\t3\n", 2, 19,
     "the goal's y is 4, but the map's height is 4"},
    {"ScenarioNegative", Kind::scenario, "version 1\n0\tm.map\t6\t4\t-1\t0\t3\t0\t3\n", 2, 13,
     "'-1' is no start x"},
    {"ScenarioOfAnotherMap", Kind::scenario, "version 1\n0\tm.map\t4\t6\t0\t0\t3\t0\t3\n", 2, 9,
     "width 4 and height 6, but this map has width 6 and height 4"},
    {"ScenarioOfTwoMaps", Kind::scenario,
     "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\t3\n0\tm.map\t6\t5\t1\t0\t2\t0\t3\n", 3, 9,
     "a scenario has one map"},
    {"ScenarioStartOnObstacle", Kind::scenario, "version 1\n0\tm.map\t6\t4\t1\t1\t3\t0\t3\n", 2, 13,
     "the start (1, 1) is an obstacle ('@')"},
    {"ScenarioGoalOnObstacle", Kind::scenario, "version 1\n0\tm.map\t6\t4\t0\t0\t4\t2\t3\n", 2, 17,
     "the goal (4, 2) is an obstacle ('T')"},
    {"ScenarioStartTwice", Kind::scenario,
     "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\t3\n0\tm.map\t6\t4\t0\t0\t2\t0\t3\n", 3, 13,
     "is the start of the record in line 2 too"},
    {"ScenarioGoalTwice", Kind::scenario,
     "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\t3\n0\tm.map\t6\t4\t1\t0\t3\t0\t3\n", 3, 17,
     "is the goal of the record in line 2 too"},

    // GraphML
    {"GraphMlEmpty", Kind::graphMl, "", 1, 1, "not XML"},
    {"GraphMlBlank", Kind::graphMl, "\n  \n", 3, 1, "not XML"},
    {"GraphMlNoXml", Kind::graphMl, "graph [\n node [ id 0 ]\n]\n", 1, 1,
     "this is GML (the bracketed format), but expected GraphML"},
    {"GraphMlTextInFront", Kind::graphMl, "hello <graphml/>", 1, 1, "not XML"},
    {"GraphMlFigure1AsPrinted", Kind::graphMl, kFigure1, 28, 3, "an end tag that does not fit"},
    {"GraphMlMissingQuote", Kind::graphMl, graphMl("<edge id=\"e3 source=\"n0\" target=\"n1\"/>"), 4, 22,
     "is a quotation mark missing?"},
    {"GraphMlCutShort", Kind::graphMl, "<graphml>\n<graph>\n<node id=\"n0\"/>\n", 3, 16,
     "not well-formed XML"},
    {"GraphMlCutWithinTag", Kind::graphMl, "<graphml>\n<graph>\n<node id=", 3, 9, "not well-formed XML"},
    {"GraphMlOpenComment", Kind::graphMl, "<graphml>\n<!-- never closed\n</graphml>", 3, 10,
     "a comment that is not"},
    {"GraphMlOtherRoot", Kind::graphMl, "<?xml version=\"1.0\"?>\n<svg/>", 1, 1,
     "this is an SVG picture, but expected GraphML"},
    {"GraphMlTwoRoots", Kind::graphMl, "<graphml><graph/></graphml>\n<graphml/>", 2, 1,
     "second outermost element"},
    {"GraphMlNoGraph", Kind::graphMl, "<graphml>\n</graphml>", 1, 1, "has no <graph>"},
    {"GraphMlTwoGraphs", Kind::graphMl, "<graphml>\n<graph/>\n<graph/>\n</graphml>", 3, 1,
     "a second <graph>"},
    {"GraphMlNestedGraph", Kind::graphMl, graphMl("<node id=\"g\">\n<graph/></node>"), 5, 1,
     "a graph within a node"},
    {"GraphMlHyperedge", Kind::graphMl, graphMl("<hyperedge/>"), 4, 1, "only <edge> is known"},
    {"GraphMlMisspeltElement", Kind::graphMl, graphMl("  <egde source=\"n0\" target=\"n1\"/>"), 4, 3,
     "did you mean 'edge'?"},
    {"GraphMlDirection", Kind::graphMl, "<graphml>\n<graph edgedefault=\"both\"/></graphml>", 2, 1,
     "edgedefault is 'both'"},
    {"GraphMlNodeWithoutId", Kind::graphMl, graphMl("<node/>"), 4, 1, "needs an attribute 'id'"},
    {"GraphMlNodeTwice", Kind::graphMl, graphMl("<node id=\"n1\"/>"), 4, 1,
     "the id 'n1' belongs to the node in line 3 already"},
    {"GraphMlAttributeTwice", Kind::graphMl, graphMl("<node id=\"n2\" id=\"n3\"/>"), 4, 1,
     "'id' stands twice"},
    {"GraphMlDanglingSource", Kind::graphMl, graphMl("<edge source=\"n7\" target=\"n1\"/>"), 4, 1,
     "the edge's source is 'n7', but there is no <node> with that id"},
    {"GraphMlDanglingTarget", Kind::graphMl, graphMl("\n <edge source=\"n1\" target=\"N0\"/>"), 5, 2,
     "the edge's target is 'N0'"},
    {"GraphMlEdgeWithoutTarget", Kind::graphMl, graphMl("<edge source=\"n0\"/>"), 4, 1,
     "needs an attribute 'target'"},
    {"GraphMlKeyTwice", Kind::graphMl, "<graphml>\n<key id=\"k\"/>\n<key id=\"k\"/><graph/></graphml>", 3, 1,
     "a key 'k' is declared already"},
    {"GraphMlUndeclaredKey", Kind::graphMl, graphMl("<node id=\"n2\"><data key=\"z\">1</data></node>"), 4, 15,
     "no <key> with the id 'z'"},
    {"GraphMlCoordinateIsAWord", Kind::graphMl, graphMl("<node id=\"n2\"><data key=\"c\">here</data></node>"),
     4, 15, "'here' is no coordinate"},
    {"GraphMlCoordinateOfOneNumber", Kind::graphMl,
     graphMl("<node id=\"n2\"><data key=\"c\">1</data></node>"), 4, 15, "two or three numbers"},
    {"GraphMlCoordinateOfFourNumbers", Kind::graphMl,
     graphMl("<node id=\"n2\"><data key=\"c\">1 2 3 4</data></node>"), 4, 15, "two or three numbers"},
    {"GraphMlCoordinateIsHuge", Kind::graphMl,
     graphMl("<node id=\"n2\"><data key=\"c\">1e999 0</data></node>"), 4, 15, "'1e999 0' is no coordinate"},
    {"GraphMlCoordinateIsNan", Kind::graphMl, graphMl("<node id=\"n2\"><data key=\"c\">nan 0</data></node>"),
     4, 15, "'nan 0' is no coordinate"},
    {"GraphMlWeightIsAWord", Kind::graphMl,
     graphMl("<edge source=\"n0\" target=\"n1\"><data key=\"w\">heavy</data></edge>"), 4, 31,
     "'heavy' is no number, but the weight must be one"},
    {"GraphMlDefaultWeightIsAWord", Kind::graphMl,
     "<graphml>\n<key id=\"w\" for=\"edge\" attr.name=\"weight\"><default>x</default></key>\n<graph>"
     "<node id=\"a\"/><node id=\"b\"/><edge source=\"a\" target=\"b\"/></graph></graphml>",
     2, 1, "'x' is no number"},

    {"GraphMlAxisIsAWord", Kind::graphMl,
     "<graphml>\n<key id=\"k\" for=\"graph\" attr.name=\"YAxis\"/>\n<graph>\n<data "
     "key=\"k\">left</data></graph></graphml>",
     4, 1, "the graph's YAxis is 'left'"},
    {"GraphMlGeometryIsAWord", Kind::graphMl,
     "<graphml>\n<key id=\"k\" for=\"node\" yfiles.type=\"nodegraphics\"/>\n<graph><node id=\"a\"><data "
     "key=\"k\">"
     "<y:S>\n <y:Geometry x=\"left\" y=\"0\" width=\"1\" "
     "height=\"1\"/></y:S></data></node></graph></graphml>",
     4, 2, "'left' is no number, but the x must be one"},

    // Instances, on a path of three vertices
    {"InstanceEmpty", Kind::instance, "\n\n", 1, 1, "the file is empty"},
    {"InstanceUnknownLine", Kind::instance, "graph = g.xml\nrobot: start = 0, goal = 1\n", 2, 1,
     "'robot: start = 0, goal = 1' is no line of an instance"},
    {"InstanceComment", Kind::instance, "graph = g.xml\n  # two robots\n", 2, 3, "is no line of an instance"},
    {"InstanceTwoGraphs", Kind::instance, "graph = g.xml\ngraph = h.xml\n", 2, 1, "line 1 names 'g.xml'"},
    {"InstanceGraphWithoutFile", Kind::instance, "graph = //\n", 1, 9, "the graph's file is missing"},
    {"InstanceGraphWithoutSign", Kind::instance, "graph g.xml\n", 1, 7, "expected '='"},
    {"InstanceWithoutColon", Kind::instance, "agent start = 0, goal = 1\n", 1, 7, "expected ':'"},
    {"InstanceWithoutComma", Kind::instance, "agent: start = 0 goal = 1\n", 1, 18, "expected ','"},
    {"InstanceWithoutGoal", Kind::instance, "agent: start = 0\n", 1, 17, "expected ','"},
    {"InstanceGoalLacksNumber", Kind::instance, "agent: start = 0, goal =\n", 1, 25,
     "the goal lacks its number"},
    {"InstanceStartLacksNumber", Kind::instance, "agent: start = , goal = 1\n", 1, 16,
     "the start lacks its number"},
    {"InstanceStartIsAFraction", Kind::instance, "agent: start = 0.5, goal = 1\n", 1, 16,
     "'0.5' is no vertex"},
    {"InstanceStartIsAnId", Kind::instance, "agent: start = n0, goal = 1\n", 1, 16, "'n0' is no vertex"},
    {"InstanceStartIsHuge", Kind::instance, "agent: start = 99999999999999999999, goal = 1\n", 1, 16,
     "is no vertex"},
    {"InstanceStartIsNegative", Kind::instance, "agent: start = -1, goal = 1\n", 1, 16,
     "there is no vertex -1"},
    {"InstanceGoalOutside", Kind::instance, "agent: start = 0, goal = 2\nagent: start = 2, goal = 3\n", 2, 26,
     "there is no vertex 3 for this goal; the graph has vertices 0 to 2"},
    {"InstanceGoalWraps32Bits", Kind::instance, "agent: start = 0, goal = 4294967297\n", 1, 26,
     "there is no vertex 4294967297"},
    {"InstanceStartTwice", Kind::instance, "agent: start = 0, goal = 1\n\nagent: start = 0, goal = 2\n", 3,
     16, "vertex 0 is the start of the agent in line 1 too"},
    {"InstanceGoalTwice", Kind::instance, "agent: start = 0, goal = 1\nagent: start = 1, goal = 1\n", 2, 26,
     "vertex 1 is the goal of the agent in line 1 too"},
    {"InstanceTrailingText", Kind::instance, "agent: start = 0, goal = 1 # first\n", 1, 28,
     "behind the goal"},

    // Solutions
    {"SolutionEmpty", Kind::solution, "", 1, 1, "expected the heading 'step,robot,from,to'"},
    {"SolutionWithoutHeading", Kind::solution, "0,0,1,2\n", 1, 1, "expected the heading"},
    {"SolutionOtherHeading", Kind::solution, "step,agent,from,to\n", 1, 6, "expected the heading"},
    {"SolutionLongHeading", Kind::solution, "step,robot,from,to,cost\n", 1, 19, "expected nothing behind"},
    {"SolutionCellIsAWord", Kind::solution, "step,robot,from,to\n0,0,1,2\n1,r2d2,2,1\n", 3, 3,
     "'r2d2' is no robot"},
    {"SolutionCellIsAFraction", Kind::solution, "step,robot,from,to\n0,0,1,2.0\n", 2, 7, "'2.0' is no to"},
    {"SolutionCellIsEmpty", Kind::solution, "step,robot,from,to\n0,,1,2\n", 2, 3, "'' is no robot"},
    {"SolutionCellIsHuge", Kind::solution, "step,robot,from,to\n0,0,1,99999999999999999999\n", 2, 7,
     "is no to"},
    {"SolutionThreeCells", Kind::solution, "step,robot,from,to\n0,0,1\n", 2, 6, "the row has 3 cells"},
    {"SolutionFiveCells", Kind::solution, "step,robot,from,to\n0,0,1,2,3\n", 2, 8, "more than four cells"},
    {"SolutionBlankLineBetween", Kind::solution, "step,robot,from,to\n0,0,1,2\n\n1,0,2,1\n", 3, 1,
     "a blank line"},
};

class MalformedFile : public testing::TestWithParam<Malformed>
{};

TEST_P(MalformedFile, IsRefusedAtItsPlace)
{
    const Malformed &file = GetParam();
    try
    {
        read(file.kind, file.contents);
        FAIL() << "was accepted";
    }
    catch (const ParseError &error)
    {
        EXPECT_EQ(error.where().toString(),
                  "bad:" + std::to_string(file.line) + ":" + std::to_string(file.column))
            << error.what();
        EXPECT_THAT(error.what(), testing::HasSubstr(file.fragment));
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
    }
}

INSTANTIATE_TEST_SUITE_P(All, MalformedFile, testing::ValuesIn(kFiles),
                         [](const auto &row) { return std::string(row.param.name); });

TEST(MalformedFile, HugeNestingIsRefusedWithoutACrash)
{
    constexpr std::size_t depth = 300000;
    std::string open = "<graphml>";
    std::string close;
    for (std::size_t i = 0; i < depth; ++i)
    {
        open += "<node>";
        close += "</node>";
    }
    EXPECT_THROW((void)parseGraphMl(open + close + "</graphml>", "deep"), ParseError);
    EXPECT_THROW((void)parseGraphMl(open, "deep and open"), ParseError);

    std::string foreign = "<graphml><graph><node id=\"a\"/></graph>";
    for (std::size_t i = 0; i < depth; ++i)
        foreign += "<x:y>";
    for (std::size_t i = 0; i < depth; ++i)
        foreign += "</x:y>";
    EXPECT_EQ(parseGraphMl(foreign + "</graphml>", "deep").graph->vertexCount(), 1);
}

const std::vector<std::pair<Kind, std::string>> kGoodFiles = {
    {Kind::map, kMap},
    {Kind::scenario, "version 1\n0\tm.map\t6\t4\t0\t0\t3\t0\t3\n0 my map 6 4 1 0 2 0 1.5\n"},
    {Kind::graphMl, graphMl("<node id=\"n2\"><data key=\"c\">1 2 3</data></node>"
                            "<edge source=\"n0\" target=\"n1\"><data key=\"w\">2</data></edge>")},
    {Kind::instance, "graph = //g.xml\nagent: start = 0, goal = 1\nagent: start = 1, goal = 2\n"},
    {Kind::solution, "step,robot,from,to\n0,0,1,2\n1,0,2,1\n"},
};

/// Whatever happens to a file, it is read or refused at a place within it (or at the line that is missing
/// behind it), and nothing else.
RC_GTEST_PROP(DamagedFile, IsReadOrRefused, ())
{
    auto [kind, text] = *rc::gen::elementOf(kGoodFiles);
    const auto damages = *rc::gen::inRange(1, 4);
    for (int i = 0; i < damages && !text.empty(); ++i)
    {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        switch (*rc::gen::inRange(0, 4))
        {
        case 0:
            text.resize(at);
            break;
        case 1:
            text[at] = *rc::gen::arbitrary<char>();
            break;
        case 2:
            text.erase(at, *rc::gen::inRange<std::size_t>(1, 9));
            break;
        default:
            text.insert(at, text.substr(*rc::gen::inRange<std::size_t>(0, text.size()), 9));
        }
    }
    try
    {
        read(kind, text);
    }
    catch (const ParseError &error)
    {
        const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
        RC_ASSERT(error.where().line >= 1U);
        RC_ASSERT(error.where().line <= lines + 1);
        RC_ASSERT(error.where().column >= 1U);
        RC_ASSERT(error.where().column <= text.size() + 1);
    }
}

} // namespace
} // namespace mrpp
