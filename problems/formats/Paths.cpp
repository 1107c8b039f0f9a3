#include "problems/formats/Paths.h"

#include "problems/formats/FormatId.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

namespace mrpp
{

namespace
{
constexpr std::string_view kForm = "Agent 0: (5,16)->(5,17)->";
}

namespace
{

SolutionRows readPaths(std::string_view text, const std::string &file, const Instance &instance)
{
    TextReader reader(text, file);
    if (const auto begin = trimmed(withoutByteOrderMark(text)); !begin.empty() && !begin.starts_with("Agent"))
        reader.fail(1, 1, "expected 'Agent' here, as in '" + std::string(kForm) + "'");
    const Cells cells(*instance.graph);
    std::vector<std::vector<PathPoint>> paths;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd())
            continue;
        expectText(reader, cursor, "Agent", kForm);
        const std::size_t robotColumn = cursor.column();
        const std::int64_t robot = expectInteger(reader, cursor, "robot");
        if (robot != static_cast<std::int64_t>(paths.size()))
            reader.fail(robotColumn, "expected robot " + std::to_string(paths.size()) +
                                         "; robots are 0, 1, 2, … in their order");
        expectText(reader, cursor, ":", kForm);
        std::vector<PathPoint> &path = paths.emplace_back();
        do
        {
            const std::size_t column = cursor.column();
            expectText(reader, cursor, "(", kForm);
            const std::int64_t row = expectInteger(reader, cursor, "row");
            expectText(reader, cursor, ",", kForm);
            const std::int64_t x = expectInteger(reader, cursor, "column");
            expectText(reader, cursor, ")", kForm);
            const Vertex v = cells.vertexAt(x, row);
            if (v == kNoVertex)
                reader.fail(column, "there is no vertex in row " + std::to_string(row) + ", column " +
                                        std::to_string(x));
            path.push_back({v, static_cast<std::uint32_t>(reader.line())});
        } while (cursor.take("->") && !cursor.atEnd());
        expectEnd(reader, cursor, kForm);
    }
    return rowsOfPaths(file, instance, paths);
}

} // namespace

SolutionRows parsePaths(std::string_view text, const std::string &file, const Instance &instance)
{
    return readAs(FormatId::paths, text, file, [&] { return readPaths(text, file, instance); });
}

std::string formatPaths(const Instance &instance, const Schedule &schedule)
{
    const Cells cells(*instance.graph);
    std::vector<std::vector<Vertex>> paths;
    for (const Vertex start : instance.starts)
        paths.push_back({start});
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        for (const Move &move : schedule.step(step))
        {
            std::vector<Vertex> &path = paths[move.robot];
            path.resize(step + 1, path.back()); // waits
            path.push_back(move.to);
        }
    TextWriter out;
    for (std::size_t robot = 0; robot < paths.size(); ++robot)
    {
        out.add("Agent ", std::uint64_t{robot}, ": ");
        for (const Vertex v : paths[robot])
            out.add('(', cells.cellOf(v).second, ',', cells.cellOf(v).first, ")->");
        out.line();
    }
    return out.take();
}

} // namespace mrpp
