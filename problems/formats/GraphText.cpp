#include "problems/formats/GraphText.h"

#include "framework/support/Config.h"
#include "problems/formats/TextReader.h"
#include "problems/formats/TextWriter.h"

#include <algorithm>
#include <optional>

namespace mrpp
{

namespace
{

constexpr std::string_view kEdgeForm = "e 1 2";
constexpr std::string_view kArcForm = "a 1 2 7";
constexpr std::string_view kProblemForm = "p edge 3 2";

/// A vertex without edges needs no bytes, so a number alone could ask for any memory.
std::int64_t mostVertices(const TextReader &reader)
{
    constexpr std::int64_t always = 1000000;
    return std::max(always, static_cast<std::int64_t>(reader.size()));
}

double readWeight(const TextReader &reader, LineCursor &cursor)
{
    const std::size_t column = cursor.column();
    const std::string_view text = cursor.until(", \t");
    const auto weight = parseNumber(text);
    if (!weight)
        reader.fail(column, inQuotes(text) + " is no weight; expected a number");
    return *weight;
}

/// A value of Python: everything up to the comma or brace behind it, which may stand in its own brackets and
/// quotes, too. Stops at the line's end at the latest.
void skipValue(LineCursor &cursor)
{
    std::size_t depth = 0;
    for (;;)
    {
        (void)cursor.until("()[]{},'\"");
        if (cursor.atEnd())
            return;
        LineCursor behind = cursor;
        const char c = behind.takeCharacter();
        if (depth == 0 && (c == ',' || c == '}'))
            return;
        cursor = behind;
        if (c == '(' || c == '[' || c == '{')
            ++depth;
        else if (c == ')' || c == ']' || c == '}')
            depth -= depth > 0 ? 1 : 0;
        else if (c != ',')
            for (char inside = cursor.takeCharacter(); inside != '\0' && inside != c;
                 inside = cursor.takeCharacter())
                if (inside == '\\')
                    (void)cursor.takeCharacter();
    }
}

/// Behind a `{`: what NetworkX writes, `{}` or `{'weight': 2.5, …}`.
double readAttributes(const TextReader &reader, LineCursor &cursor)
{
    double weight = 1;
    while (!cursor.take("}"))
    {
        const std::string_view key = cursor.until(":}");
        expectText(reader, cursor, ":", "0 1 {'weight': 2.5}");
        if (key == "'weight'" || key == "\"weight\"")
        {
            const std::size_t column = cursor.column();
            const std::string_view text = cursor.until(",}");
            const auto value = parseNumber(text);
            if (!value)
                reader.fail(column, inQuotes(text) + " is no weight; expected a number");
            weight = *value;
        }
        else
            skipValue(cursor);
        if (cursor.atEnd())
            reader.fail(cursor.column(), "expected '}' here, as in '0 1 {}'");
        (void)cursor.take(",");
    }
    return weight;
}

std::string counted(std::size_t count, const char *what)
{
    return std::to_string(count) + " " + what;
}

GraphText build(std::size_t vertexCount, const std::vector<Graph::Edge> &edges, bool bothWays)
{
    GraphText result{Graph::fromEdges(vertexCount, edges), {}};
    const auto loops = static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const Graph::Edge &e) { return e.a == e.b; }));
    const std::size_t kept = result.graph->edgeCount() * (bothWays ? 2 : 1);
    if (loops > 0)
        result.warnings.push_back(counted(loops, "loops are left out"));
    if (edges.size() - loops > kept)
        result.warnings.push_back(counted(edges.size() - loops - kept, "parallel edges are left out"));
    if (bothWays && edges.size() - loops < kept)
        result.warnings.push_back("some arcs have no opposite; robots may go both ways along every edge");
    if (result.graph->isWeighted())
        result.warnings.push_back("some edges have a weight other than 1; it is kept, but every move takes "
                                  "one unit of time");
    return result;
}

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
        GraphText result = build(static_cast<std::size_t>(*vertexCount_), edges_, isArcs_);
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
            reader_.fail(kindColumn, inQuotes(kind) + " is no kind of graph that is read here; expected "
                                                      "edge, col or sp");
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
            edge.weight = readWeight(reader_, cursor);
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

/// The number behind `Nodes:` in a comment, if there is one.
std::optional<std::int64_t> promisedVertices(const TextReader &reader, LineCursor cursor)
{
    while (!cursor.atEnd())
        if (cursor.word() == "Nodes:" && !cursor.atEnd())
            return expectInteger(reader, cursor, "number of vertices");
    return std::nullopt;
}

} // namespace

GraphText parseDimacs(std::string_view text, const std::string &file)
{
    return DimacsReader(text, file).read();
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

GraphText parseEdgeList(std::string_view text, const std::string &file)
{
    constexpr std::string_view form = "0 1";
    TextReader reader(text, file);
    const std::int64_t most = mostVertices(reader);
    std::vector<Graph::Edge> edges;
    std::int64_t vertexCount = 0;
    std::optional<std::int64_t> promised;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd())
            continue;
        if (cursor.take("#") || cursor.take("%"))
        {
            const std::size_t column = cursor.column();
            if (!promised)
                promised = promisedVertices(reader, cursor);
            if (promised && (*promised < 0 || *promised > most))
                reader.fail(column, std::to_string(*promised) + " vertices do not fit a file of this size");
            continue;
        }
        const auto readVertex = [&]
        {
            const std::size_t column = cursor.column();
            const std::int64_t v = expectInteger(reader, cursor, "vertex");
            if (v < 0 || v >= promised.value_or(most))
                reader.fail(column, "there can be no vertex " + std::to_string(v) + "; expected 0 to " +
                                        std::to_string(promised.value_or(most) - 1));
            vertexCount = std::max(vertexCount, v + 1);
            return static_cast<Vertex>(v);
        };
        Graph::Edge edge;
        edge.a = readVertex();
        (void)cursor.take(",");
        edge.b = readVertex();
        (void)cursor.take(",");
        if (cursor.take("{"))
            edge.weight = readAttributes(reader, cursor);
        else if (!cursor.atEnd())
            edge.weight = readWeight(reader, cursor);
        expectEnd(reader, cursor, form);
        edges.push_back(edge);
    }
    if (edges.empty() && !promised)
        reader.fail(
            1, 1, "the file holds no edges; expected two vertices a line, as in '" + std::string(form) + "'");
    return build(static_cast<std::size_t>(promised.value_or(vertexCount)), edges, false);
}

std::string formatEdgeList(const Graph &graph)
{
    TextWriter out;
    out.line("# Nodes: ", std::uint64_t{graph.vertexCount()}, " Edges: ", std::uint64_t{graph.edgeCount()});
    for (const Graph::Edge &edge : graph.edges())
    {
        out.add(edge.a, ' ', edge.b);
        if (graph.isWeighted())
        {
            out.add(' ');
            out.addShortest(edge.weight);
        }
        out.line();
    }
    return out.take();
}

} // namespace mrpp
