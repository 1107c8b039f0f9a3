/// DIMACS and lists of edges.

#include "problems/formats/GraphText.h"

#include "tests/problems/FormatCases.h"

namespace mrpp
{
namespace
{

TEST(Dimacs, ReadsEdgesFrom1)
{
    const GraphText text = parseDimacs("c a comment\np edge 4 3\ne 1 2\ne 2 3\ne 1 3\n", "f");
    EXPECT_EQ(text.graph->vertexCount(), 4);
    EXPECT_EQ(text.graph->edgeCount(), 3);
    EXPECT_TRUE(text.graph->hasEdge(0, 2));
    EXPECT_TRUE(text.warnings.empty());
    EXPECT_EQ(formatDimacs(*text.graph), "p edge 4 3\ne 1 2\ne 1 3\ne 2 3\n");
}

TEST(Dimacs, FoldsArcsAndKeepsWeights)
{
    const GraphText text = parseDimacs("p sp 3 3\r\na 1 2 2.5\r\na 2 1 2.5\r\na 2 3 1\r\n", "f");
    EXPECT_EQ(text.graph->edgeCount(), 2);
    EXPECT_EQ(text.graph->weight(0, 1), 2.5);
    EXPECT_THAT(text.warnings, testing::ElementsAre(testing::HasSubstr("no opposite"),
                                                    testing::HasSubstr("weight other than 1")));
}

TEST(Dimacs, SaysWhatItLeavesOut)
{
    const GraphText text = parseDimacs("p col 3 9\nn 1 4\ne 1 1\ne 1 2\ne 2 1\n", "f");
    EXPECT_EQ(text.graph->edgeCount(), 1);
    EXPECT_THAT(text.warnings, testing::ElementsAre("1 loop is left out", "1 parallel edge is left out",
                                                    testing::HasSubstr("promises 9 edges and has 3")));
}

TEST(Dimacs, RefusesWhatIsMalformed)
{
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "no line 'p edge"},
        {"EdgesFirst", "e 1 2\n", "bad:1:1", "before the edges"},
        {"TwoProblems", "p edge 1 0\np edge 1 0\n", "bad:2:1", "a second line 'p'"},
        {"OtherKind", "p max 1 0\n", "bad:1:3", "'max' is no kind"},
        {"HugeCount", "p edge 4000000000 0\n", "bad:1:8", "do not fit a file of this size"},
        {"NegativeCount", "p edge -1 0\n", "bad:1:8", "do not fit"},
        {"Vertex0", "p edge 2 1\ne 0 1\n", "bad:2:3", "counted from 1"},
        {"VertexOutside", "p edge 2 1\ne 1 3\n", "bad:2:5", "there is no vertex 3"},
        {"ArcAmongEdges", "p edge 2 1\na 1 2 1\n", "bad:2:1", "'e 1 2'"},
        {"WeightMissing", "p sp 2 1\na 1 2\n", "bad:2:6", "'' is no weight"},
        {"UnknownLine", "p edge 2 1\nhello\n", "bad:2:1", "'hello' begins no line"},
        {"TextBehind", "p edge 2 1\ne 1 2 x\n", "bad:2:7", "expected the line's end"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal,
                      [](const std::string &text, const char *file) { (void)parseDimacs(text, file); });
}

TEST(EdgeList, ReadsWhatOthersWrite)
{
    for (const char *text :
         {"0 1\n1 2\n", "# comment\n0\t1\n1\t2", "% x\r\n0,1\r\n1, 2\r\n",
          "# Nodes: 3 Edges: 2\n0 1 1\n1 2 1.0\n", "0 1 {}\n1 2 {'x': 'a', 'weight': 1}\n"})
    {
        const GraphText read = parseEdgeList(text, "f");
        EXPECT_EQ(read.graph->vertexCount(), 3) << text;
        EXPECT_EQ(read.graph->edgeCount(), 2) << text;
        EXPECT_TRUE(read.warnings.empty()) << text;
    }
    EXPECT_EQ(parseEdgeList("0 1 # one\n1 2 % two\n", "f").graph->edgeCount(), 2);
    EXPECT_EQ(parseEdgeList("0 1 {'weight': 2.5}\n", "f").graph->weight(0, 1), 2.5);
    EXPECT_EQ(parseEdgeList("# Nodes: 5\n", "f").graph->vertexCount(), 5);
}

TEST(EdgeList, NumbersWithGapsAreKeptAsNames)
{
    for (const char *comment : {"# Nodes: 4 Edges: 3\n", ""})
    {
        const GraphText read = parseEdgeList(std::string(comment) + "17\t4\n17\t902\n902\t30011\n", "f");
        EXPECT_EQ(read.graph->vertexCount(), 4);
        EXPECT_THAT(read.vertexNames, testing::ElementsAre("4", "17", "902", "30011"));
        EXPECT_TRUE(read.graph->hasEdge(2, 3));
        EXPECT_THAT(read.warnings, testing::ElementsAre(testing::HasSubstr(
                                       "kept as names: vertex 0 is '4', the last, vertex 3, is '30011'")));
        const GraphText again = parseEdgeList(formatEdgeList(*read.graph, read.vertexNames), "f");
        EXPECT_EQ(again.vertexNames, read.vertexNames);
        EXPECT_EQ(again.graph->fingerprint(), read.graph->fingerprint());
    }
}

TEST(EdgeList, AListWithout0IsSaidToCountFrom1)
{
    const GraphText read = parseEdgeList("1 2\n2 3\n3 4\n", "f");
    EXPECT_EQ(read.graph->vertexCount(), 4);
    EXPECT_THAT(read.warnings, testing::ElementsAre(testing::HasSubstr("counted from 1")));
}

TEST(EdgeList, OnlySomeVerticesWithEdgesIsSaid)
{
    const GraphText read = parseEdgeList("# Nodes: 4\n0 9\n", "f");
    EXPECT_EQ(read.graph->vertexCount(), 2);
    EXPECT_THAT(read.warnings,
                testing::Contains(testing::HasSubstr("only 2 of the 4 vertices have an edge")));
}

TEST(EdgeList, KonectsNetworksCountFrom1AsTheirHeaderSays)
{
    const GraphText read = parseEdgeList("% sym unweighted\n% 2 4 4\n1 2\n2 3\n", "f");
    EXPECT_EQ(read.graph->vertexCount(), 4);
    EXPECT_EQ(read.graph->edgeCount(), 2);
    EXPECT_TRUE(read.graph->hasEdge(0, 1));
}

TEST(EdgeList, EdgesThatLookLikeCountsAreReadBehindTheNumberOfVertices)
{
    const GraphText read = parseEdgeList("# Nodes: 4\n3 2\n0 1\n1 2\n", "f");
    EXPECT_EQ(read.graph->edgeCount(), 3);
    EXPECT_TRUE(read.warnings.empty());
}

TEST(MatrixMarket, ASquareMatrixIsTheGraphOfItsEntries)
{
    const GraphText pattern = parseMatrixMarket("%%MatrixMarket matrix coordinate pattern symmetric\n"
                                                "% x\n4 4 3\n2 1\n3 2\n4 3\n",
                                                "f");
    EXPECT_EQ(pattern.graph->vertexCount(), 4);
    EXPECT_EQ(pattern.graph->edgeCount(), 3);
    EXPECT_TRUE(pattern.warnings.empty());
    const GraphText weighted = parseMatrixMarket("%%matrixmarket MATRIX coordinate Real General\r\n"
                                                 "3 3 3\r\n1 2 2.5\r\n2 1 2.5\r\n2 2 1\r\n",
                                                 "f");
    EXPECT_EQ(weighted.graph->edgeCount(), 1);
    EXPECT_EQ(weighted.graph->weight(0, 1), 2.5);
    EXPECT_THAT(weighted.warnings, testing::ElementsAre("1 loop is left out", testing::HasSubstr("weight")));
}

TEST(MatrixMarket, RefusesWhatIsNoGraph)
{
    const std::string header = "%%MatrixMarket matrix coordinate pattern symmetric\n";
    const std::vector<Refusal> refusals = {
        {"Array", "%%MatrixMarket matrix array real general\n1 1\n0\n", "bad:1:1", "is not read"},
        {"Complex", "%%MatrixMarket matrix coordinate complex general\n1 1 0\n", "bad:1:1", "is not read"},
        {"Rectangle", header + "2 3 0\n", "bad:2:1", "only a square one is a graph"},
        {"NoSizes", header, "bad:2:1", "ends without its sizes"},
        {"TooFew", header + "2 2 2\n2 1\n", "bad:2:1", "there should be 2 entries"},
        {"Row0", header + "2 2 1\n0 1\n", "bad:3:1", "counted from 1"},
        {"Value", header + "2 2 1\n2 1 5\n", "bad:3:5", "expected the line's end"},
        {"Huge", header + "4000000000 4000000000 0\n", "bad:2:1", "do not fit"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal,
                      [](const std::string &text, const char *file) { (void)parseMatrixMarket(text, file); });
}

TEST(EdgeList, RefusesWhatIsMalformed)
{
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "holds no edges"},
        {"OneNumber", "0\n", "bad:1:2", "expected a whole number"},
        {"Word", "0 x\n", "bad:1:3", "expected a whole number"},
        {"Weight", "0 1 x\n", "bad:1:5", "'x' is no weight"},
        {"OpenAttributes", "0 1 {'weight': 2\n", "bad:1:17", "expected '}'"},
        {"AttributeWithoutValue", "0 1 {'weight'}\n", "bad:1:14", "expected ':'"},
        {"FourNumbers", "0 1 2 3\n", "bad:1:7", "expected the line's end"},
        {"Negative", "0 -1\n", "bad:1:3", "no vertex -1"},
        {"Huge", "0 40000000000000000000\n", "bad:1:3", "too large"},
        {"BeyondThePromise", "# Nodes: 2\n0 2\n1 3\n", "bad:1:1", "4 different numbers of vertices"},
        {"CountsInFront", "3 2\n0 1\n1 2\n", "bad:1:1",
         "looks like counts of vertices and edges (2 edges follow)"},
        {"EdgesCountedFirst", "2 3\n0 1\n1 2\n", "bad:1:1", "counts"},
        {"CountsFrom1", "# x\n3 2\n1 2\n2 3\n", "bad:2:1", "counts"},
        {"SomeWeights", "0 1\n0 1 5\n", "bad:2:1", "this line has a weight"},
        {"Metis", "4 4\n2 4\n1 3\n2 4\n1 3\n", "bad:1:1", "METIS"},
        {"AdjacencyMatrix", "0 1 0\n1 0 1\n0 1 0\n", "bad:1:1", "an adjacency matrix"},
        {"Bipartite", "% bip unweighted\n1 1\n", "bad:1:1", "KONECT"},
        {"HugePromise", "# Nodes: 4000000000\n0 2\n", "bad:1:3", "do not fit"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal,
                      [](const std::string &text, const char *file) { (void)parseEdgeList(text, file); });
}

RC_GTEST_PROP(GraphText, ComesBackAsItWasWritten, ())
{
    auto graph = randomGraph();
    if (*rc::gen::arbitrary<bool>())
    {
        auto edges = graph->edges();
        for (Graph::Edge &edge : edges)
            edge.weight = static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 7;
        graph = Graph::fromEdges(graph->vertexCount(), edges);
    }
    RC_ASSERT(parseDimacs(formatDimacs(*graph), "f").graph->fingerprint() == graph->fingerprint());
    RC_ASSERT(parseEdgeList(formatEdgeList(*graph), "f").graph->fingerprint() == graph->fingerprint());
}

} // namespace
} // namespace mrpp
