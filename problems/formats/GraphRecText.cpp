/// The reader of GraphRec's text form.

#include "framework/support/Config.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/GraphRecBuilder.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>
#include <cctype>

namespace mrpp
{

namespace
{

constexpr std::string_view kVertexForm = "(1:0)[1:0:0]";
constexpr std::string_view kEdgeForm = "{1,2} (0)";
constexpr std::string_view kMoveForm = "1 ---> 2 (0)";
constexpr std::string_view kPositionForm = "1:X0:Y40";

class Reader
{
public:
    Reader(std::string_view text, const std::string &file) : reader_(text, file), builder_(file) {}

    GraphRecFile read()
    {
        bool ended = false;
        std::string lower; // GraphRec does not tell small letters from large ones
        while (const auto line = reader_.next())
        {
            lower.assign(*line);
            std::transform(lower.begin(), lower.end(), lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            LineCursor cursor(lower);
            const std::size_t column = cursor.column();
            if (cursor.atEnd())
                continue;
            if (ended)
                reader_.fail(column, "there is something behind 'Length:'; a file holds one graph here");
            if (cursor.take("("))
                readVertex(cursor);
            else if (cursor.take("v") && cursor.take("="))
                hasBegun_ = true;
            else if (cursor.take("{"))
                readEdge(cursor);
            else if (cursor.take("id:"))
                readId(column);
            else if (cursor.take("length:"))
                ended = readLength(cursor);
            else if (const char first = lower[column - 1]; first == '-' || (first >= '0' && first <= '9'))
                readNumbered(cursor);
        }
        if (!ended)
            reader_.fail(reader_.line() + 1, 1,
                         "the file ends without a line 'Length:<number>', at which GraphRec ends a graph");
        if (!hasBegun_)
            reader_.fail(1, 1, "there is neither a line 'id:1' nor 'V =', behind which the vertices stand");
        return builder_.take();
    }

private:
    /// Refuses, at a column, what the builder refuses.
    void check(const std::optional<std::string> &complaint, std::size_t column) const
    {
        if (complaint)
            reader_.fail(column, *complaint);
    }

    void readId(std::size_t column)
    {
        if (hasId_)
            reader_.fail(column, "a second graph begins here; a file holds one graph here");
        hasId_ = hasBegun_ = true;
    }

    bool readLength(LineCursor &cursor)
    {
        (void)expectInteger(reader_, cursor, "length");
        expectEnd(reader_, cursor, "Length:3");
        return true;
    }

    void readVertex(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t id = expectInteger(reader_, cursor, "vertex");
        check(builder_.addVertex(id), column);
        hasBegun_ = true;
        expectText(reader_, cursor, ":", kVertexForm);
        (void)expectInteger(reader_, cursor, "cycle");
        expectText(reader_, cursor, ")", kVertexForm);
        expectText(reader_, cursor, "[", kVertexForm);
        const std::size_t robotColumn = cursor.column();
        check(builder_.setStart(id, expectInteger(reader_, cursor, "robot")), robotColumn);
        expectText(reader_, cursor, ":", kVertexForm);
        (void)expectInteger(reader_, cursor, "goal");
        expectText(reader_, cursor, ":", kVertexForm);
        const std::size_t goalColumn = cursor.column();
        check(builder_.setGoal(id, expectInteger(reader_, cursor, "goal")), goalColumn);
        expectText(reader_, cursor, "]", kVertexForm);
        while (!cursor.digits().empty())
            continue;
        expectEnd(reader_, cursor, kVertexForm);
    }

    void readEdge(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t a = expectInteger(reader_, cursor, "vertex");
        expectText(reader_, cursor, ",", kEdgeForm);
        const std::int64_t b = expectInteger(reader_, cursor, "vertex");
        expectText(reader_, cursor, "}", kEdgeForm);
        expectText(reader_, cursor, "(", kEdgeForm);
        (void)expectInteger(reader_, cursor, "cycle");
        expectText(reader_, cursor, ")", kEdgeForm);
        expectEnd(reader_, cursor, kEdgeForm);
        check(builder_.addEdge(a, b), column);
    }

    /// A move, a position, or a hint for the layout, which is skipped: all begin with a number.
    void readNumbered(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t first = expectInteger(reader_, cursor, "vertex");
        if (cursor.take("("))
            return;
        if (cursor.take(":"))
        {
            expectText(reader_, cursor, "x", kPositionForm);
            const double x = readCoordinate(cursor);
            expectText(reader_, cursor, ":y", kPositionForm);
            const double y = readCoordinate(cursor);
            expectEnd(reader_, cursor, kPositionForm);
            check(builder_.setPosition(first, x, y), column);
            return;
        }
        expectText(reader_, cursor, "-", kMoveForm);
        while (cursor.take("-"))
            continue;
        expectText(reader_, cursor, ">", kMoveForm);
        const std::int64_t to = expectInteger(reader_, cursor, "vertex");
        (void)cursor.until("("); // GraphRec allows numbers, arrows and brackets here
        expectText(reader_, cursor, "(", kMoveForm);
        const std::int64_t step = expectInteger(reader_, cursor, "step");
        expectText(reader_, cursor, ")", kMoveForm);
        expectEnd(reader_, cursor, kMoveForm);
        check(builder_.addMove(step, first, to, reader_.line()), column);
    }

    double readCoordinate(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::string_view text = cursor.until(": \t");
        const auto value = parseNumber(text);
        if (!value)
            reader_.fail(column, inQuotes(text) + " is no coordinate; expected a number");
        return *value;
    }

    TextReader reader_;
    GraphRecBuilder builder_;
    bool hasId_ = false;
    bool hasBegun_ = false;
};

} // namespace

GraphRecFile parseGraphRec(std::string_view text, const std::string &file)
{
    return readAs(FormatId::graphRec, text, file, [&] { return Reader(text, file).read(); });
}

} // namespace mrpp
