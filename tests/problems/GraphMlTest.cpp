#include "problems/formats/GraphMl.h"

#include "framework/support/Error.h"
#include "problems/formats/MovingAiMap.h"

#include <cmath>
#include <ctime>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpp
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

GraphMl parse(const std::string &text)
{
    return parseGraphMl(text, "test.graphml");
}

std::vector<std::pair<Vertex, Vertex>> edgesOf(const Graph &graph)
{
    std::vector<std::pair<Vertex, Vertex>> edges;
    for (const Graph::Edge &edge : graph.edges())
        edges.emplace_back(edge.a, edge.b);
    return edges;
}

using Edges = std::vector<std::pair<Vertex, Vertex>>;

TEST(GraphMl, ReadsThePapersFormWithItsMistakesMended)
{
    const GraphMl read = parse(R"xml(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns"
xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns
http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">
<key id="key0" for="node" attr.name="Coordinate" attr.type="string" />
<key id="key1" for="edge" attr.name="Weight" attr.type="double" />
<graph id="G" edgedefault="undirected" parse.nodeids="canonical" parse.edgeids="canonical" parse.order="nodesfirst">
<node id="n0"><data key="key0">0.0 0.0 0.0</data></node>
<node id="n1"><data key="key0">1.0 0.0 0.0</data></node>
<node id="n2"><data key="key0">2.0 0.5 0.25</data></node>
<edge id="e0" source="n0" target="n1"><data key="key1">1</data></edge>
<edge id="e2" source="n1" target="n2"><data key="key1">1</data></edge>
<edge id="e3" source="n2" target="n0"><data key="key1">1</data></edge>
</graph>
</graphml>)xml");
    EXPECT_EQ(read.graph->vertexCount(), 3);
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{0, 1}, {0, 2}, {1, 2}}));
    EXPECT_EQ(read.graph->coordinate(2), (Point{2, 0.5, 0.25}));
    EXPECT_EQ(read.graph->yAxis(), YAxis::up);
    EXPECT_FALSE(read.graph->isWeighted());
    EXPECT_THAT(read.warnings, IsEmpty());
}

TEST(GraphMl, VerticesAreNumberedByPositionNotById)
{
    const GraphMl read = parse(R"xml(<graphml><graph edgedefault="undirected">
<node id="n5"/><edge source="n3" target="(0, 1)"/><node id="(0, 1)"/><node id="n3"/>
</graph></graphml>)xml");
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{1, 2}}));
    EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("the node with id 'n5' is vertex 0")));
}

TEST(GraphMl, NamespacePrefixesDoNotMatter)
{
    const GraphMl read = parse(R"xml(<g:graphml xmlns:g="http://graphml.graphdrawing.org/xmlns">
<g:key id="w" for="edge" attr.name="weight"/>
<g:graph edgedefault="undirected"><g:node id="a"/><g:node id="b"/><other:node id="c"/>
<g:edge source="a" target="b"><g:data key="w">2.5</g:data></g:edge></g:graph></g:graphml>)xml");
    EXPECT_EQ(read.graph->vertexCount(), 2);
    EXPECT_EQ(read.graph->weight(0, 1), 2.5);
    EXPECT_THAT(
        read.warnings,
        ElementsAre(HasSubstr("1 element is skipped: called as GraphML's are, but of another namespace"),
                    HasSubstr("weight other than 1")));
}

TEST(GraphMl, NamespacesAreKnownByTheirAddresses)
{
    const GraphMl read = parse(R"xml(<graphml xmlns="urn:g" xmlns:g="urn:g" xmlns:y="urn:y">
<graph edgedefault="undirected"><node id="a"/><g:node id="b"/><y:node id="c"/>
<h:node xmlns:h="urn:g" id="d"/><node xmlns="urn:y" id="e"><node id="f"/></node>
<edge source="a" target="b"/><g:edge source="b" target="d"/></graph></graphml>)xml");
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{0, 1}, {1, 2}}));
    EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("2 elements are skipped")));
}

TEST(GraphMl, TrueIsSpeltWithLargeLettersToo)
{
    const GraphMl read = parse(R"xml(<graphml><graph edgedefault="Undirected"><node id="a"/><node id="b"/>
<edge source="a" target="b" directed="True"/></graph></graphml>)xml");
    EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("1 directed edge has no opposite")));
}

TEST(GraphMl, OppositeDirectionsOfDifferentWeightsAreSaid)
{
    const GraphMl read = parse(R"xml(<graphml><key id="w" for="edge" attr.name="weight"/>
<graph edgedefault="directed"><node id="a"/><node id="b"/>
<edge source="a" target="b"><data key="w">2</data></edge>
<edge source="b" target="a"><data key="w">3</data></edge></graph></graphml>)xml");
    EXPECT_EQ(read.graph->weight(0, 1), 2);
    EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("1 edge has another weight in the opposite direction"),
                                           HasSubstr("weight other than 1")));
}

TEST(GraphMl, DirectedFilesThatListBothDirectionsAreFolded)
{
    const GraphMl read = parse(R"xml(<graphml><key id="c" for="node" attr.name="coords"/>
<graph edgedefault="directed"><node id="0"><data key="c">1.5,2</data></node><node id="1"><data key="c">3,-4e1</data></node>
<node id="2"><data key="c">(0, 0)</data></node>
<edge source="0" target="1"/><edge source="1" target="0"/><edge source="1" target="2"/><edge source="2" target="1"/>
</graph></graphml>)xml");
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{0, 1}, {1, 2}}));
    EXPECT_EQ(read.graph->coordinate(1), (Point{3, -40, 0}));
    EXPECT_THAT(read.warnings, IsEmpty());
}

TEST(GraphMl, LoopsParallelAndOneWayEdgesAreReported)
{
    const GraphMl read =
        parse(R"xml(<graphml><graph edgedefault="undirected"><node id="a"/><node id="b"/><node id="c"/>
<edge source="a" target="a"/><edge source="a" target="b"/><edge source="b" target="a"/><edge source="a" target="b"/>
<edge source="b" target="c" directed="true"/></graph></graphml>)xml");
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{0, 1}, {1, 2}}));
    EXPECT_THAT(read.warnings, ElementsAre("1 loop is dropped", HasSubstr("1 directed edge has no opposite"),
                                           HasSubstr("2 parallel edges are merged")));
}

TEST(GraphMl, CoordinatesMayBeSeparateKeys)
{
    const GraphMl read = parse(R"xml(<graphml><key id="d0" for="node" attr.name="X" attr.type="double"/>
<key id="d1" for="node" attr.name="y" attr.type="double"><default>7</default></key>
<graph edgedefault="undirected"><node id="0"><data key="d0">1</data><data key="d1">2</data></node>
<node id="1"><data key="d0"> 3 </data></node></graph></graphml>)xml");
    EXPECT_THAT(read.graph->coordinates(), ElementsAre(Point{1, 2, 0}, Point{3, 7, 0}));
}

TEST(GraphMl, ReadsTheGeometryOfYEd)
{
    const GraphMl read = parse(R"xml(<graphml xmlns:y="http://www.yworks.com/xml/graphml">
<key id="d6" for="node" yfiles.type="nodegraphics"/><key id="d10" for="edge" yfiles.type="edgegraphics"/>
<graph edgedefault="directed" id="G"><node id="n0"><data key="d6"><y:ShapeNode>
<y:Geometry height="30.0" width="40.0" x="100.0" y="-15.0"/><y:NodeLabel>start</y:NodeLabel></y:ShapeNode></data></node>
<node id="n1"><data key="d6"><y:ShapeNode><y:Geometry height="30" width="30" x="0" y="0"/></y:ShapeNode></data></node>
<edge id="e0" source="n0" target="n1"><data key="d10"><y:PolyLineEdge/></data></edge>
</graph><data key="d6"><y:Resources/></data></graphml>)xml");
    EXPECT_THAT(read.graph->coordinates(), ElementsAre(Point{120, 0, 0}, Point{15, 15, 0}));
    EXPECT_EQ(read.graph->yAxis(), YAxis::down);
    EXPECT_EQ(edgesOf(*read.graph), (Edges{{0, 1}}));
}

TEST(GraphMl, CoordinatesOfSomeVerticesAreNoDrawing)
{
    const GraphMl read = parse(R"xml(<graphml><key id="c" for="node" attr.name="pos"/><graph>
<node id="a"><data key="c">1 2</data></node><node id="b"/></graph></graphml>)xml");
    EXPECT_FALSE(read.graph->hasCoordinates());
    EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("only 1 of 2 vertices have coordinates")));
}

TEST(GraphMl, AnUndeclaredEndMakesNoPhantomVertex)
{
    EXPECT_THROW((void)parse(R"xml(<graphml><graph edgedefault="undirected"><node id="n0"/><node id="n1"/>
<edge source="n0" target="n1"/><edge source="n1" target="n2"/></graph></graphml>)xml"),
                 ParseError);
}

TEST(GraphMl, TheEmptyGraphIsAGraph)
{
    EXPECT_EQ(parse("<graphml><graph/></graphml>").graph->vertexCount(), 0);
}

TEST(GraphMl, WritesThePapersForm)
{
    const auto graph = Graph::fromEdges(2, std::vector<Graph::Edge>{{1, 0, 1}}, {{0, 0, 0}, {0.5, -1, 2}});
    const std::string text = formatGraphMl(*graph);
    EXPECT_THAT(text,
                HasSubstr("<key id=\"key0\" for=\"node\" attr.name=\"Coordinate\" attr.type=\"string\"/>"));
    EXPECT_THAT(text, HasSubstr("<key id=\"key1\" for=\"edge\" attr.name=\"Weight\" attr.type=\"double\"/>"));
    EXPECT_THAT(text, HasSubstr("<node id=\"n1\"><data key=\"key0\">0.5 -1 2</data></node>"));
    EXPECT_THAT(text,
                HasSubstr("<edge id=\"e0\" source=\"n0\" target=\"n1\"><data key=\"key1\">1</data></edge>"));
}

RC_GTEST_PROP(GraphMl, ComesBackExactly, (bool down, bool weighted, bool placed))
{
    const auto count = *rc::gen::inRange<std::size_t>(1, 20);
    const auto finite =
        rc::gen::suchThat(rc::gen::arbitrary<double>(), [](double x) { return std::isfinite(x); });
    const auto end = rc::gen::inRange<Vertex>(0, static_cast<Vertex>(count));
    std::vector<Graph::Edge> edges;
    for (const auto &[a, b, weight] : *rc::gen::container<std::vector<std::tuple<Vertex, Vertex, double>>>(
             rc::gen::tuple(end, end, finite)))
        edges.push_back({a, b, weighted ? weight : 1});
    std::vector<Point> points;
    if (placed)
        for (std::size_t v = 0; v < count; ++v)
            points.push_back({*finite, *finite, *finite});
    const auto graph = Graph::fromEdges(count, edges, points, down && placed ? YAxis::down : YAxis::up);

    const auto again = parse(formatGraphMl(*graph)).graph;
    RC_ASSERT(again->fingerprint() == graph->fingerprint());
    RC_ASSERT(std::equal(again->coordinates().begin(), again->coordinates().end(),
                         graph->coordinates().begin(), graph->coordinates().end()));
    RC_ASSERT(again->yAxis() == graph->yAxis());
}

TEST(GraphMl, ReadsALargeMapFast)
{
    std::string cells = "type octile\nheight 240\nwidth 242\nmap\n";
    for (std::size_t y = 0; y < 240; ++y)
        cells += std::string(242, '.') + "\n";
    const auto graph = parseMovingAiMap(cells, "m").graph;
    ASSERT_EQ(graph->vertexCount(), 58080);
    const std::string text = formatGraphMl(*graph);
    const std::clock_t begin = std::clock(); // the processor's time: other programs do not count
    const auto again = parse(text).graph;
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_EQ(again->fingerprint(), graph->fingerprint());
    RecordProperty("milliseconds", static_cast<int>(seconds * 1000));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(seconds, 0.6); // 0.15 s on a free machine
#endif
}

} // namespace
} // namespace mrpp
