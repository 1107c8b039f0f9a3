#include "problems/formats/Surynek.h"

#include "framework/support/Config.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

namespace mrpp
{

namespace
{

constexpr std::string_view kVertexForm = "(0:-1)[1:0:0]";
constexpr std::string_view kShortVertexForm = "(0,1,0)";
constexpr std::string_view kEdgeForm = "{0,1} (-1)";
constexpr std::string_view kMoveForm = "1 # 0 ---> 1 (0)";

/// A robot's start or goal, and where the file says it.
struct Place
{
    Vertex vertex = kNoVertex;
    std::size_t line = 0;
};

class CpfReader
{
public:
    CpfReader(std::string_view text, const std::string &file) : reader_(text, file), file_(file) {}

    CpfProblem read()
    {
        skipToVertices();
        readVertices();
        readEdges();
        CpfProblem problem{{Graph::fromEdges(vertexCount_, edges_), {}, {}}, {}};
        if (problem.instance.graph->edgeCount() < edges_.size())
            problem.warnings.push_back(counted(edges_.size() - problem.instance.graph->edgeCount(),
                                               "loop or repeated edge is", "loops or repeated edges are") +
                                       " left out");
        if (starts_.size() != goals_.size())
            starts_.resize(std::max(starts_.size(), goals_.size()));
        goals_.resize(starts_.size());
        for (std::size_t robot = 0; robot < starts_.size(); ++robot)
        {
            if (starts_[robot].vertex == kNoVertex || goals_[robot].vertex == kNoVertex)
                refuseHalf(robot);
            problem.instance.starts.push_back(starts_[robot].vertex);
            problem.instance.goals.push_back(goals_[robot].vertex);
        }
        return problem;
    }

private:
    /// The line `V =` ends whatever stands in front of it.
    void skipToVertices()
    {
        while (const auto line = reader_.next())
            if (LineCursor cursor(*line); cursor.take("V") && cursor.take("=") && cursor.atEnd())
                return;
        reader_.fail(reader_.line() + 1, 1,
                     "the file ends without a line 'V =', behind which vertices stand");
    }

    void readVertices()
    {
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd())
                continue;
            if (cursor.take("E"))
            {
                expectText(reader_, cursor, "=", "E =");
                expectEnd(reader_, cursor, "E =");
                return;
            }
            readVertex(cursor);
        }
        reader_.fail(reader_.line() + 1, 1, "the file ends without a line 'E =', behind which edges stand");
    }

    void readVertex(LineCursor &cursor)
    {
        if (!cursor.take("("))
            reader_.fail(cursor.column(), "expected a vertex, '" + std::string(kVertexForm) +
                                              "', or 'E =' behind the last vertex");
        const std::size_t column = cursor.column();
        const std::int64_t id = expectInteger(reader_, cursor, "vertex");
        if (id != static_cast<std::int64_t>(vertexCount_))
            reader_.fail(column, "this is vertex " + std::to_string(id) +
                                     ", but vertices are numbered 0, 1, "
                                     "2, … in their order; expected " +
                                     std::to_string(vertexCount_));
        ++vertexCount_;
        if (cursor.take(","))
            readShortVertex(cursor);
        else
            readLongVertex(cursor);
    }

    /// Behind `(vertex,`: robot and goal, or capacity, robot and goal.
    void readShortVertex(LineCursor &cursor)
    {
        const std::size_t firstColumn = cursor.column();
        std::int64_t first = expectInteger(reader_, cursor, "robot");
        expectText(reader_, cursor, ",", kShortVertexForm);
        std::size_t robotColumn = firstColumn;
        std::size_t goalColumn = cursor.column();
        std::int64_t second = expectInteger(reader_, cursor, "goal");
        if (cursor.take(","))
        {
            checkCapacity(first, firstColumn);
            first = second;
            robotColumn = goalColumn;
            goalColumn = cursor.column();
            second = expectInteger(reader_, cursor, "goal");
        }
        expectText(reader_, cursor, ")", kShortVertexForm);
        place(starts_, first, robotColumn, "starts");
        place(goals_, second, goalColumn, "ends");
        readConflicts(cursor);
        expectEnd(reader_, cursor, kShortVertexForm);
    }

    /// Behind `(vertex`: a cycle, perhaps a capacity, and the brackets.
    void readLongVertex(LineCursor &cursor)
    {
        expectText(reader_, cursor, ":", kVertexForm);
        (void)expectInteger(reader_, cursor, "cycle");
        if (cursor.take(":"))
        {
            const std::size_t column = cursor.column();
            checkCapacity(expectInteger(reader_, cursor, "capacity"), column);
        }
        expectText(reader_, cursor, ")", kVertexForm);
        expectText(reader_, cursor, "[", kVertexForm);
        const std::size_t robotColumn = cursor.column();
        place(starts_, expectInteger(reader_, cursor, "robot"), robotColumn, "starts");
        expectText(reader_, cursor, ":", kVertexForm);
        refuseSet(cursor);
        const std::int64_t goal = expectInteger(reader_, cursor, "goal");
        expectText(reader_, cursor, ":", kVertexForm);
        refuseSet(cursor);
        const std::size_t goalColumn = cursor.column();
        const std::int64_t again = expectInteger(reader_, cursor, "goal");
        if (std::max<std::int64_t>(goal, 0) != std::max<std::int64_t>(again, 0))
            reader_.fail(goalColumn, "the goal is " + std::to_string(goal) + " first and " +
                                         std::to_string(again) + " then; it has to be the same twice");
        place(goals_, again, goalColumn, "ends");
        expectText(reader_, cursor, "]", kVertexForm);
        readConflicts(cursor);
        while (!cursor.digits().empty()) // BIBOX repeats the neighbours here
            continue;
        expectEnd(reader_, cursor, kVertexForm);
    }

    void checkCapacity(std::int64_t capacity, std::size_t column)
    {
        if (capacity != 1)
            reader_.fail(column, "the capacity is " + std::to_string(capacity) +
                                     ", but here one vertex holds one robot; expected 1");
    }

    void refuseSet(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        if (cursor.take("{"))
            reader_.fail(column, "this is a set of goals; robots have one goal each here");
    }

    /// `< >`, with nothing in it.
    void readConflicts(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        if (cursor.take("<") && !cursor.take(">"))
            reader_.fail(column, "this is a list of conflicts, which are not known here");
    }

    /// \param robot as in the file: from 1, nobody below
    void place(std::vector<Place> &places, std::int64_t robot, std::size_t column, const std::string &verb)
    {
        if (robot <= 0)
            return;
        const auto index = static_cast<std::size_t>(robot - 1);
        if (index >= reader_.size())
            reader_.fail(column, "robot " + std::to_string(robot) +
                                     " is more than the file can hold; robots "
                                     "are numbered 1, 2, 3, … without gaps");
        if (index >= places.size())
            places.resize(index + 1);
        if (places[index].vertex != kNoVertex)
            reader_.fail(column, "robot " + std::to_string(robot) + " " + verb + " in line " +
                                     std::to_string(places[index].line) + " too");
        places[index] = {static_cast<Vertex>(vertexCount_ - 1), reader_.line()};
    }

    void readEdges()
    {
        while (const auto line = reader_.next())
        {
            LineCursor cursor(*line);
            if (cursor.atEnd())
                continue;
            if (cursor.take("C"))
            {
                expectText(reader_, cursor, "=", "C =");
                return; // BIBOX's cycles: how the graph came to be
            }
            expectText(reader_, cursor, "{", kEdgeForm);
            const Vertex a = readEnd(cursor);
            expectText(reader_, cursor, ",", kEdgeForm);
            const Vertex b = readEnd(cursor);
            expectText(reader_, cursor, "}", kEdgeForm);
            if (cursor.take("("))
            {
                (void)expectInteger(reader_, cursor, "cycle");
                expectText(reader_, cursor, ")", kEdgeForm);
            }
            readConflicts(cursor);
            expectEnd(reader_, cursor, kEdgeForm);
            edges_.push_back({a, b});
        }
    }

    Vertex readEnd(LineCursor &cursor)
    {
        const std::size_t column = cursor.column();
        const std::int64_t end = expectInteger(reader_, cursor, "vertex");
        if (end < 0 || static_cast<std::uint64_t>(end) >= vertexCount_)
            reader_.fail(column, "there is no vertex " + std::to_string(end) + "; there are " +
                                     std::to_string(vertexCount_) + ", counted from 0");
        return static_cast<Vertex>(end);
    }

    [[noreturn]] void refuseHalf(std::size_t robot) const
    {
        const std::string name = "robot " + std::to_string(robot + 1);
        if (starts_[robot].vertex != kNoVertex)
            reader_.fail(starts_[robot].line, 1, name + " starts here, but ends nowhere");
        if (goals_[robot].vertex != kNoVertex)
            reader_.fail(goals_[robot].line, 1, name + " ends here, but starts nowhere");
        throw ParseError({file_}, name + " is missing; robots are numbered 1, 2, 3, … without gaps");
    }

    TextReader reader_;
    std::string file_;
    std::size_t vertexCount_ = 0;
    std::vector<Place> starts_;
    std::vector<Place> goals_;
    std::vector<Graph::Edge> edges_;
};

} // namespace

CpfProblem parseCpf(std::string_view text, const std::string &file)
{
    return readAs(FormatId::cpf, text, file, [&] { return CpfReader(text, file).read(); });
}

std::string formatCpf(const Instance &instance)
{
    const Graph &graph = *instance.graph;
    std::vector<std::uint64_t> robotAt(graph.vertexCount(), 0);
    std::vector<std::uint64_t> goalOf(graph.vertexCount(), 0);
    for (std::size_t r = 0; r < instance.robotCount(); ++r)
    {
        robotAt[instance.starts[r]] = r + 1;
        goalOf[instance.goals[r]] = r + 1;
    }
    TextWriter out;
    out.line("V =");
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
        out.line('(', v, ":-1)[", robotAt[v], ':', goalOf[v], ':', goalOf[v], ']');
    out.line("E =");
    for (const Graph::Edge &edge : graph.edges())
        out.line('{', edge.a, ',', edge.b, "} (-1)");
    return out.take();
}

namespace
{

SolutionRows readMoves(std::string_view text, const std::string &file)
{
    TextReader reader(text, file);
    SolutionRows rows;
    rows.file = file;
    bool begun = false;
    while (!begun)
    {
        const auto line = reader.next();
        if (!line)
            reader.fail(reader.line() + 1, 1, "the file ends without a line 'Fine solution'");
        begun = trimmed(*line) == "Fine solution";
    }
    const auto lengthLine = reader.next();
    if (!lengthLine)
        reader.fail(reader.line() + 1, 1, "expected a line 'Length:<number of moves>'");
    LineCursor lengthCursor(*lengthLine);
    expectText(reader, lengthCursor, "Length", "Length:3");
    expectText(reader, lengthCursor, ":", "Length:3");
    const std::size_t lengthColumn = lengthCursor.column();
    const std::size_t lengthAt = reader.line();
    const std::int64_t length = expectInteger(reader, lengthCursor, "length");
    expectEnd(reader, lengthCursor, "Length:3");

    std::int64_t lastStep = -1;
    std::int64_t step = -1;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd())
            continue;
        TimedMove move;
        move.robot = expectInteger(reader, cursor, "robot");
        if (move.robot < 1)
            reader.fail(1, "robots are counted from 1 here");
        --move.robot;
        expectText(reader, cursor, "#", kMoveForm);
        move.from = expectInteger(reader, cursor, "vertex");
        expectText(reader, cursor, "--->", kMoveForm);
        move.to = expectInteger(reader, cursor, "vertex");
        expectText(reader, cursor, "(", kMoveForm);
        const std::size_t column = cursor.column();
        move.step = expectInteger(reader, cursor, "step");
        expectText(reader, cursor, ")", kMoveForm);
        expectEnd(reader, cursor, kMoveForm);
        if (move.step < 0 || move.step < lastStep)
            reader.fail(column, "step " + std::to_string(move.step) + " comes after step " +
                                    std::to_string(lastStep) + "; steps go up from 0");
        step += move.step > lastStep ? 1 : 0;
        lastStep = move.step;
        move.step = step;
        rows.moves.push_back(move);
        rows.lines.push_back(static_cast<std::uint32_t>(reader.line()));
    }
    if (length != static_cast<std::int64_t>(rows.moves.size()))
        reader.fail(lengthAt, lengthColumn,
                    "the length is " + std::to_string(length) + ", but " + std::to_string(rows.moves.size()) +
                        " moves follow");
    return rows;
}

} // namespace

SolutionRows parseSurynekSolution(std::string_view text, const std::string &file)
{
    return readAs(FormatId::surynekSolution, text, file, [&] { return readMoves(text, file); });
}

std::string formatSurynekSolution(const Schedule &schedule)
{
    TextWriter out;
    out.line("Fine solution");
    out.line("Length:", std::uint64_t{schedule.pathLength()});
    std::uint64_t written = 0; // steps in which everybody waits are left out
    for (std::size_t s = 0; s < schedule.makespan(); ++s)
    {
        for (const Move &move : schedule.step(s))
            out.line(std::uint64_t{move.robot} + 1, " # ", move.from, " ---> ", move.to, " (", written, ')');
        written += schedule.step(s).empty() ? 0 : 1;
    }
    return out.take();
}

} // namespace mrpp
