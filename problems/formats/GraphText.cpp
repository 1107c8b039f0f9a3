#include "problems/formats/GraphText.h"

#include "problems/formats/FormatId.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

#include <algorithm>
#include <optional>

namespace mrpp
{

namespace
{

constexpr std::string_view kEdgeForm = "e 1 2";
constexpr std::string_view kArcForm = "a 1 2 7";
constexpr std::string_view kProblemForm = "p edge 3 2";

class DimacsReader
{
public:
    DimacsReader(std::string_view text, const std::string &file) : reader_(text, file) {}

    GraphText read()
    {
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd())
                continue;
            const std::size_t column = cursor.column();
            const std::string_view word = cursor.word();
            if (word == "p")
                readProblem(cursor, column);
            else if (word == "e" || word == "a")
                readEdge(cursor, column, word == "a");
            else if (word != "c" && word != "n" && word != "d" && word != "v" && word != "x")
                reader_.fail(column, inQuotes(word) + " begins no line of a DIMACS graph; expected "
                                                      "'c <comment>', 'p edge <vertices> <edges>', "
                                                      "'e <vertex> <vertex>' or 'a <from> <to> <weight>'");
        }
        if (!vertexCount_)
            reader_.fail(1, 1, "there is no line '" + std::string(kProblemForm) + "'");
        GraphText result = graphOfLines(static_cast<std::size_t>(*vertexCount_), edges_, isArcs_);
        const auto lines = static_cast<std::int64_t>(edges_.size());
        if (promised_ != lines && promised_ != 2 * lines && 2 * promised_ != lines)
            result.warnings.push_back("the file promises " + std::to_string(promised_) + " edges and has " +
                                      std::to_string(lines));
        return result;
    }

private:
    void readProblem(LineCursor &cursor, std::size_t column)
    {
        if (vertexCount_)
            reader_.fail(column, "a second line 'p'; a file holds one graph");
        const std::size_t kindColumn = cursor.column();
        const std::string_view kind = cursor.word();
        if (kind != "edge" && kind != "edges" && kind != "col" && kind != "sp")
            reader_.fail(kindColumn, inQuotes(kind) + " is no kind of DIMACS graph that is read here; "
                                                      "expected edge, col or sp");
        isArcs_ = kind == "sp";
        const std::size_t countColumn = cursor.column();
        vertexCount_ = expectInteger(reader_, cursor, "number of vertices");
        if (*vertexCount_ < 0 || *vertexCount_ > mostVertices(reader_))
            reader_.fail(countColumn,
                         std::to_string(*vertexCount_) + " vertices do not fit a file of this size");
        promised_ = expectInteger(reader_, cursor, "number of edges");
        expectEnd(reader_, cursor, kProblemForm);
    }

    void readEdge(LineCursor &cursor, std::size_t column, bool isArc)
    {
        if (!vertexCount_)
            reader_.fail(column, "expected the line '" + std::string(kProblemForm) + "' before the edges");
        if (isArc != isArcs_)
            reader_.fail(column, std::string("edges are lines '") +
                                     std::string(isArcs_ ? kArcForm : kEdgeForm) + "' in this kind of graph");
        Graph::Edge edge;
        edge.a = readVertex(cursor);
        edge.b = readVertex(cursor);
        if (isArc)
            edge.weight = expectNumber(reader_, cursor, "weight");
        expectEnd(reader_, cursor, isArc ? kArcForm : kEdgeForm);
        edges_.push_back(edge);
    }

    Vertex readVertex(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t v = expectInteger(reader_, cursor, "vertex");
        if (v < 1 || v > *vertexCount_)
            reader_.fail(column, "there is no vertex " + std::to_string(v) + "; there are " +
                                     std::to_string(*vertexCount_) + ", counted from 1");
        return static_cast<Vertex>(v - 1);
    }

    TextReader reader_;
    std::optional<std::int64_t> vertexCount_;
    std::int64_t promised_ = 0;
    bool isArcs_ = false;
    std::vector<Graph::Edge> edges_;
};

} // namespace

std::int64_t mostVertices(const TextReader &reader)
{
    constexpr std::int64_t always = 1000000;
    return std::max(always, static_cast<std::int64_t>(reader.size()));
}

GraphText graphOfLines(std::size_t vertexCount, const std::vector<Graph::Edge> &edges, bool bothWays)
{
    GraphText result{Graph::fromEdges(vertexCount, edges), {}, {}};
    const auto loops = static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const Graph::Edge &e) { return e.a == e.b; }));
    const std::size_t kept = result.graph->edgeCount() * (bothWays ? 2 : 1);
    if (loops > 0)
        result.warnings.push_back(counted(loops, "loop is", "loops are") + " left out");
    if (edges.size() - loops > kept)
        result.warnings.push_back(
            counted(edges.size() - loops - kept, "parallel edge is", "parallel edges are") + " left out");
    if (bothWays && edges.size() - loops < kept)
        result.warnings.push_back("some arcs have no opposite; robots may go both ways along every edge");
    if (result.graph->isWeighted())
        result.warnings.push_back("some edges have a weight other than 1; it is kept, but every move takes "
                                  "one unit of time");
    return result;
}

GraphText parseDimacs(std::string_view text, const std::string &file)
{
    return readAs(FormatId::dimacs, text, file, [&] { return DimacsReader(text, file).read(); });
}

std::string formatDimacs(const Graph &graph)
{
    TextWriter out;
    const auto edges = graph.edges();
    const bool weighted = graph.isWeighted();
    out.line("p ", weighted ? "sp " : "edge ", std::uint64_t{graph.vertexCount()}, ' ',
             std::uint64_t{edges.size() * (weighted ? 2 : 1)});
    for (const Graph::Edge &edge : edges)
    {
        const std::uint64_t a = std::uint64_t{edge.a} + 1;
        const std::uint64_t b = std::uint64_t{edge.b} + 1;
        if (!weighted)
        {
            out.line("e ", a, ' ', b);
            continue;
        }
        for (const auto &[from, to] : {std::pair(a, b), std::pair(b, a)})
        {
            out.add("a ", from, ' ', to, ' ');
            out.addShortest(edge.weight);
            out.line();
        }
    }
    return out.take();
}

} // namespace mrpp
