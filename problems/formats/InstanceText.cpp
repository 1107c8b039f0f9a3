#include "problems/formats/InstanceText.h"

#include "framework/support/Config.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr const char *kForm = "expected 'graph = <file>' or 'agent: start = <vertex>, goal = <vertex>'";

void expect(const TextReader &reader, LineCursor &cursor, std::string_view token)
{
    if (!cursor.take(token))
        reader.fail(cursor.column(), "expected '" + std::string(token) +
                                         "' here, as in 'agent: start = <vertex>, goal = <vertex>'");
}

InstanceText::Number readVertex(const TextReader &reader, LineCursor &cursor, const char *role)
{
    expect(reader, cursor, role);
    expect(reader, cursor, "=");
    const std::size_t column = cursor.column();
    const std::string_view text = cursor.until(", \t");
    const auto value = parseInteger(text);
    if (text.empty())
        reader.fail(column, std::string("the ") + role + " lacks its number; expected a vertex from 0 on");
    if (!value || text.front() == '+')
        reader.fail(column, inQuotes(text) + " is no vertex; vertices are whole numbers from 0 on");
    return {*value, column};
}

void readGraphLine(const TextReader &reader, LineCursor &cursor, InstanceText &instance)
{
    if (instance.graphLine != 0)
        reader.fail(1, "the graph is named a second time; line " + std::to_string(instance.graphLine) +
                           " names " + inQuotes(instance.graph));
    expect(reader, cursor, "=");
    const std::size_t column = cursor.column();
    std::string_view path = cursor.until("");
    if (path.substr(0, 2) == "//")
        path.remove_prefix(2);
    if (path.empty())
        reader.fail(column, "the graph's file is missing; expected 'graph = <file>'");
    instance.graph = path;
    instance.graphLine = reader.line();
}

} // namespace

std::filesystem::path InstanceText::graphPath() const
{
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    std::filesystem::path named = folder / graph; // an absolute path stands alone
    std::error_code error;
    if (std::filesystem::exists(named, error))
        return named;
    std::filesystem::path beside = folder / fileNameIn(graph);
    return std::filesystem::exists(beside, error) ? beside : named;
}

InstanceText readInstanceText(const std::filesystem::path &file)
{
    return parseInstanceText(readFile(file), file.string());
}

namespace
{

InstanceText readLines(std::string_view text, const std::string &file)
{
    TextReader reader(text, file);
    InstanceText instance;
    instance.file = file;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd())
            continue;
        const std::size_t column = cursor.column();
        const std::string_view word = cursor.until(":= \t");
        if (word == "graph")
        {
            readGraphLine(reader, cursor, instance);
        }
        else if (word == "agent")
        {
            InstanceText::Agent agent;
            agent.line = reader.line();
            expect(reader, cursor, ":");
            agent.start = readVertex(reader, cursor, "start");
            expect(reader, cursor, ",");
            agent.goal = readVertex(reader, cursor, "goal");
            if (!cursor.atEnd())
                reader.fail(cursor.column(), "there is something behind the goal; expected the line's end");
            instance.agents.push_back(agent);
        }
        else
        {
            reader.fail(column, inQuotes(trimmed(*line)) + " is no line of an instance; " + kForm);
        }
    }
    if (instance.graphLine == 0 && instance.agents.empty())
        reader.fail(1, 1, std::string("the file is empty; ") + kForm);
    return instance;
}

} // namespace

InstanceText parseInstanceText(std::string_view text, const std::string &file)
{
    return readAs(FormatId::instanceText, text, file, [&] { return readLines(text, file); });
}

Instance textInstance(const InstanceText &text, std::shared_ptr<const Graph> graph)
{
    const std::size_t count = graph->vertexCount();
    std::vector<Robot> startOwner(count, kNoRobot);
    std::vector<Robot> goalOwner(count, kNoRobot);
    Instance instance{std::move(graph), {}, {}};
    const auto place = [&](const InstanceText::Number &number, std::size_t line, const std::string &role,
                           std::vector<Robot> &owner, std::vector<Vertex> &vertices)
    {
        const auto fail = [&](const std::string &what) {
            throw ParseError({text.file, line, number.column}, what);
        };
        if (number.value < 0 || static_cast<std::uint64_t>(number.value) >= count)
            fail("there is no vertex " + std::to_string(number.value) + " for this " + role + "; " +
                 (count == 0 ? std::string("the graph is empty")
                             : "the graph has vertices 0 to " + std::to_string(count - 1)));
        const auto v = static_cast<Vertex>(number.value);
        if (owner[v] != kNoRobot)
            fail("vertex " + std::to_string(v) + " is the " + role + " of the agent in line " +
                 std::to_string(text.agents[owner[v]].line) + " too; robots need distinct " + role + "s");
        owner[v] = static_cast<Robot>(vertices.size());
        vertices.push_back(v);
    };
    for (const InstanceText::Agent &agent : text.agents)
    {
        place(agent.start, agent.line, "start", startOwner, instance.starts);
        place(agent.goal, agent.line, "goal", goalOwner, instance.goals);
    }
    return instance;
}

std::string formatInstanceText(const Instance &instance, const std::string &graphFile)
{
    std::string text = graphFile.empty() ? "" : "graph = " + graphFile + "\n";
    for (std::size_t r = 0; r < instance.robotCount(); ++r)
        text += "agent: start = " + std::to_string(instance.starts[r]) +
                ", goal = " + std::to_string(instance.goals[r]) + "\n";
    return text;
}

} // namespace mrpp
