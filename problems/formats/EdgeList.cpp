/// Lists of edges, also those with a header of Matrix Market or KONECT.

#include "problems/formats/FormatId.h"
#include "problems/formats/GraphText.h"
#include "problems/formats/support/ForeignFormats.h"

#include "framework/support/Config.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace mrpp
{

namespace
{

constexpr std::string_view kForm = "0 1";

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

bool isComment(LineCursor cursor)
{
    return cursor.take("#") || cursor.take("%");
}

/// An edge as the file says it; its ends may be numbers or names.
struct Row
{
    std::int64_t a = 0;
    std::int64_t b = 0;
    double weight = 1;
};

class EdgeListReader
{
public:
    EdgeListReader(std::string_view text, const std::string &file) : reader_(text, file), text_(text) {}

    GraphText read()
    {
        try
        {
            readLines();
        }
        catch (const ParseError &)
        {
            if (const std::string other = tableOfNumbers(text_); !other.empty())
                reader_.fail(1, 1, "this looks like " + other + ", not like a list of edges");
            throw;
        }
        if (rows_.empty() && !promised_)
            reader_.fail(1, 1,
                         "the file holds no edges; expected two vertices a line, as in '" +
                             std::string(kForm) + "'");
        if (!promised_ && !isKonect_)
            refuseOtherMeanings();
        return isNumbered() ? graphOfLines(vertexCount(), edgesBy([](std::int64_t v) { return v; }), false)
                            : graphOfNames();
    }

private:
    void readLines()
    {
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd())
                continue;
            if (isComment(cursor))
                readComment(cursor);
            else
                readRow(cursor);
        }
    }

    void readComment(LineCursor cursor)
    {
        if (reader_.line() == 1 && cursor.take("%%MatrixMarket"))
            reader_.fail(1, "this is a Matrix Market file, which is read apart");
        LineCursor behind = cursor;
        if (!rows_.empty() && bareLine_ == 0 && behind.take("#") && behind.atEnd())
        {
            bareLine_ = reader_.line();
            rowsBeforeBareLine_ = rows_.size();
        }
        if (rows_.empty() && reader_.line() == 1 && cursor.take("%"))
            readKonect(cursor);
        else if (isKonect_ && !promised_ && rows_.empty() && cursor.take("%"))
            readKonectSizes(cursor);
        else if (!promised_)
            readPromise(cursor);
    }

    /// `% sym unweighted`: a network of the KONECT collection, whose vertices count from 1.
    void readKonect(LineCursor cursor)
    {
        const std::size_t column = cursor.column();
        const std::string_view kind = cursor.word();
        if (kind == "bip")
            reader_.fail(column,
                         "this is a bipartite network of KONECT, whose two sides have numbers of their "
                         "own; it is not read");
        isKonect_ = kind == "sym" || kind == "asym";
        if (!isKonect_)
            readPromise(cursor);
    }

    /// `% 3 4 4`: edges, and vertices twice.
    void readKonectSizes(LineCursor cursor)
    {
        const std::size_t column = cursor.column();
        const auto edges = parseInteger(cursor.word());
        const auto vertices = parseInteger(cursor.word());
        if (edges && vertices)
            promise(*vertices, column);
    }

    /// The number behind `Nodes:`.
    void readPromise(LineCursor cursor)
    {
        (void)(cursor.take("#") || cursor.take("%"));
        const std::size_t column = cursor.column();
        while (!cursor.atEnd())
            if (cursor.word() == "Nodes:" && !cursor.atEnd())
                return promise(expectInteger(reader_, cursor, "number of vertices"), column);
    }

    void promise(std::int64_t vertices, std::size_t column)
    {
        promised_ = vertices;
        if (vertices < 0 || vertices > mostVertices(reader_))
            reader_.fail(column, std::to_string(vertices) + " vertices do not fit a file of this size");
    }

    std::int64_t readVertex(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t v = expectInteger(reader_, cursor, "vertex");
        if (v < 0 || (isKonect_ && v < 1))
            reader_.fail(column, "there can be no vertex " + std::to_string(v) + "; they count from " +
                                     (isKonect_ ? "1" : "0"));
        return v;
    }

    void readRow(LineCursor &cursor)
    {
        Row row;
        row.a = readVertex(cursor);
        (void)cursor.take(",");
        row.b = readVertex(cursor);
        (void)cursor.take(",");
        bool isWeighted = false;
        if (cursor.take("{"))
            row.weight = readAttributes(reader_, cursor);
        else if (!cursor.atEnd() && !isComment(cursor))
        {
            isWeighted = true;
            row.weight = expectNumber(reader_, cursor, "weight");
        }
        if (!isComment(cursor))
            expectEnd(reader_, cursor,
                      isKonect_ ? "1 2 (KONECT's weights are read, its times are not)" : kForm);
        if (!rows_.empty() && isWeighted != isWeighted_ && !hasMixedRows_)
        {
            hasMixedRows_ = true;
            mixedLine_ = reader_.line();
        }
        if (rows_.empty())
        {
            isWeighted_ = isWeighted;
            firstLine_ = reader_.line();
        }
        rows_.push_back(row);
    }

    /// Throws where the rows may as well be something else than edges.
    void refuseOtherMeanings() const
    {
        const std::string help = "; if these are edges, write '# Nodes: <vertices>' in front";
        const auto count = static_cast<std::int64_t>(rows_.size());
        const bool mayBeMetis = rows_.front().a >= count - 1; // a vertex without neighbours has a blank line
        const bool mayBeMatrix = isWeighted_ && count == 3;
        if (mayBeMetis || mayBeMatrix)
            if (const std::string other = tableOfNumbers(text_); !other.empty())
                reader_.fail(firstLine_, 1, "this looks like " + other + ", not like a list of edges" + help);
        if (hasMixedRows_)
            reader_.fail(mixedLine_, 1,
                         std::string("this line has ") + (isWeighted_ ? "no" : "a") +
                             " weight, but those before have " + (isWeighted_ ? "one" : "none") +
                             ": these look like counts in front, or adjacency lists, which are not read" +
                             help);
        if (bareLine_ > 0 && rowsBeforeBareLine_ < rows_.size())
            reader_.fail(bareLine_, 1,
                         "this line looks like the one between the vertices and the edges of a graph as TGF, "
                         "which is not read" +
                             help);
        if (const std::string other = countsInFront(); !other.empty())
            reader_.fail(firstLine_, 1, other + help);
    }

    /// `3 2` in front of two edges of three vertices, or `2 3`.
    [[nodiscard]] std::string countsInFront() const
    {
        if (rows_.size() < 2 || isWeighted_)
            return {};
        std::int64_t least = rows_[1].a;
        std::int64_t largest = 0;
        for (auto row = rows_.begin() + 1; row != rows_.end(); ++row)
        {
            least = std::min({least, row->a, row->b});
            largest = std::max({largest, row->a, row->b});
        }
        const auto edges = static_cast<std::int64_t>(rows_.size()) - 1;
        const auto areCounts = [&](std::int64_t vertices, std::int64_t others)
        { return others == edges && (vertices > largest || (least > 0 && vertices == largest)); };
        const Row &first = rows_.front();
        if (!areCounts(first.a, first.b) && (edges < 2 || !areCounts(first.b, first.a)))
            return {};
        return "this line looks like counts of vertices and edges (" + std::to_string(edges) +
               " edges follow), not like an edge; delete it, or write '# Nodes: " +
               std::to_string(areCounts(first.a, first.b) ? first.a : first.b) + "' instead";
    }

    template <class Numbering>
    std::vector<Graph::Edge> edgesBy(Numbering &&vertexOf) const
    {
        std::vector<Graph::Edge> edges;
        edges.reserve(rows_.size());
        for (const Row &row : rows_)
            edges.push_back(
                {static_cast<Vertex>(vertexOf(row.a)), static_cast<Vertex>(vertexOf(row.b)), row.weight});
        return edges;
    }

    [[nodiscard]] std::int64_t largest() const
    {
        std::int64_t most = -1;
        for (const Row &row : rows_)
            most = std::max({most, row.a, row.b});
        return most;
    }

    [[nodiscard]] std::size_t vertexCount() const
    {
        return static_cast<std::size_t>(promised_.value_or(largest() + 1));
    }

    /// Whether the vertices are called 0, 1, 2, … without gaps, as far as the file says.
    [[nodiscard]] bool isNumbered() const
    {
        const std::int64_t most = largest();
        if (isKonect_)
            return false;
        if (promised_)
            return most < *promised_;
        if (static_cast<std::uint64_t>(most) >= 2 * rows_.size())
            return false; // more numbers than ends
        std::vector<bool> occurs(static_cast<std::size_t>(most) + 1, false);
        for (const Row &row : rows_)
            occurs[static_cast<std::size_t>(row.a)] = occurs[static_cast<std::size_t>(row.b)] = true;
        return std::find(occurs.begin(), occurs.end(), false) == occurs.end();
    }

    /// The numbers that occur, ascending; all of a KONECT file that says how many there are.
    [[nodiscard]] std::vector<std::int64_t> names() const
    {
        std::vector<std::int64_t> names;
        if (isKonect_ && promised_ && largest() <= *promised_)
        {
            for (std::int64_t v = 1; v <= *promised_; ++v)
                names.push_back(v);
            return names;
        }
        names.reserve(2 * rows_.size());
        for (const Row &row : rows_)
        {
            names.push_back(row.a);
            names.push_back(row.b);
        }
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        return names;
    }

    GraphText graphOfNames() const
    {
        const std::vector<std::int64_t> names = this->names();
        if (names.empty())
            return graphOfLines(0, {}, false);
        if (promised_ && names.size() > static_cast<std::size_t>(*promised_))
            reader_.fail(1, 1,
                         "there are " + std::to_string(names.size()) +
                             " different numbers of vertices, but " + "a comment promises " +
                             std::to_string(*promised_));
        GraphText result =
            graphOfLines(names.size(),
                         edgesBy([&names](std::int64_t v)
                                 { return std::lower_bound(names.begin(), names.end(), v) - names.begin(); }),
                         false);
        const bool countsFrom1 =
            names.front() == 1 && names.back() == static_cast<std::int64_t>(names.size());
        result.warnings.insert(result.warnings.begin(),
                               (countsFrom1
                                    ? "the vertices are counted from 1 in the file, as there is no 0"
                                    : "the file's numbers have gaps (" + std::to_string(names.size()) +
                                          " different ones, up to " + std::to_string(names.back()) + ")") +
                                   "; they are kept as names: vertex 0 is '" + std::to_string(names.front()) +
                                   "', the last, vertex " + std::to_string(names.size() - 1) + ", is '" +
                                   std::to_string(names.back()) + "'");
        if (promised_ && names.size() < static_cast<std::size_t>(*promised_))
            result.warnings.push_back("only " + std::to_string(names.size()) + " of the " +
                                      std::to_string(*promised_) +
                                      " vertices have an edge; the others have no name and are left out");
        result.vertexNames.reserve(names.size());
        for (const std::int64_t name : names)
            result.vertexNames.push_back(std::to_string(name));
        return result;
    }

    TextReader reader_;
    std::string_view text_;
    std::vector<Row> rows_;
    std::optional<std::int64_t> promised_;
    bool isKonect_ = false;
    bool isWeighted_ = false; ///< as the first row is
    bool hasMixedRows_ = false;
    std::size_t mixedLine_ = 0;
    std::size_t firstLine_ = 0;
    std::size_t bareLine_ = 0; ///< a line of nothing but `#` amid the rows
    std::size_t rowsBeforeBareLine_ = 0;
};

class MatrixMarketReader
{
public:
    MatrixMarketReader(std::string_view text, const std::string &file) : reader_(text, file) {}

    GraphText read()
    {
        readHeader();
        readSizes();
        std::vector<Graph::Edge> edges;
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd() || isComment(cursor))
                continue;
            Graph::Edge edge;
            edge.a = readIndex(cursor);
            edge.b = readIndex(cursor);
            if (!isPattern_)
                edge.weight = expectNumber(reader_, cursor, "entry");
            expectEnd(reader_, cursor, isPattern_ ? "1 2" : "1 2 2.5");
            edges.push_back(edge);
        }
        if (static_cast<std::int64_t>(edges.size()) != entries_)
            reader_.fail(sizeLine_, 1,
                         "there should be " + std::to_string(entries_) + " entries, but there are " +
                             std::to_string(edges.size()));
        return graphOfLines(static_cast<std::size_t>(rows_), edges, !isSymmetric_);
    }

private:
    void readHeader()
    {
        LineCursor cursor(reader_.next().value_or(""));
        std::string lower;
        while (!cursor.atEnd())
        {
            for (const char c : cursor.word())
                lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            lower += ' ';
        }
        const std::string begin = "%%matrixmarket matrix coordinate ";
        const std::string kind = lower.starts_with(begin) ? lower.substr(begin.size()) : "";
        isPattern_ = kind.starts_with("pattern ");
        isSymmetric_ = kind.ends_with(" symmetric ");
        const bool isKnown = isPattern_ || kind.starts_with("real ") || kind.starts_with("integer ");
        if (!isKnown || (!isSymmetric_ && !kind.ends_with(" general ")))
            reader_.fail(1, 1,
                         "this kind of Matrix Market file is not read; expected '%%MatrixMarket matrix "
                         "coordinate pattern symmetric', or real or integer, or general");
    }

    void readSizes()
    {
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd() || isComment(cursor))
                continue;
            sizeLine_ = reader_.line();
            const std::size_t column = cursor.column();
            rows_ = expectInteger(reader_, cursor, "number of rows");
            const std::int64_t columns = expectInteger(reader_, cursor, "number of columns");
            entries_ = expectInteger(reader_, cursor, "number of entries");
            expectEnd(reader_, cursor, "4 4 3");
            if (rows_ != columns)
                reader_.fail(column, "the matrix has " + std::to_string(rows_) + " rows and " +
                                         std::to_string(columns) + " columns; only a square one is a graph");
            if (rows_ < 0 || rows_ > mostVertices(reader_))
                reader_.fail(column, std::to_string(rows_) + " rows do not fit a file of this size");
            return;
        }
        reader_.fail(reader_.line() + 1, 1, "the file ends without its sizes, 'rows columns entries'");
    }

    Vertex readIndex(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t index = expectInteger(reader_, cursor, "row or column");
        if (index < 1 || index > rows_)
            reader_.fail(column, "there is no row or column " + std::to_string(index) + "; there are " +
                                     std::to_string(rows_) + ", counted from 1");
        return static_cast<Vertex>(index - 1);
    }

    TextReader reader_;
    bool isPattern_ = false;
    bool isSymmetric_ = false;
    std::int64_t rows_ = 0;
    std::int64_t entries_ = 0;
    std::size_t sizeLine_ = 1;
};

} // namespace

GraphText parseEdgeList(std::string_view text, const std::string &file)
{
    return readAs(FormatId::edgeList, text, file, [&] { return EdgeListReader(text, file).read(); });
}

GraphText parseMatrixMarket(std::string_view text, const std::string &file)
{
    return readAs(FormatId::matrixMarket, text, file, [&] { return MatrixMarketReader(text, file).read(); });
}

bool fitsEdgeList(const Graph &graph, const std::vector<std::string> &vertexNames)
{
    std::int64_t last = -1;
    for (Vertex v = 0; v < vertexNames.size(); ++v)
    {
        const auto number = parseInteger(vertexNames[v]);
        if (!number || *number <= last || graph.neighbors(v).empty() ||
            std::to_string(*number) != vertexNames[v])
            return false;
        last = *number;
    }
    return last >= static_cast<std::int64_t>(vertexNames.size());
}

std::string formatEdgeList(const Graph &graph, const std::vector<std::string> &vertexNames)
{
    TextWriter out;
    out.line("# Nodes: ", std::uint64_t{graph.vertexCount()}, " Edges: ", std::uint64_t{graph.edgeCount()});
    const auto addVertex = [&](Vertex v)
    {
        if (vertexNames.empty())
            out.add(v);
        else
            out.add(std::string_view(vertexNames[v]));
    };
    for (const Graph::Edge &edge : graph.edges())
    {
        addVertex(edge.a);
        out.add(' ');
        addVertex(edge.b);
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
