#include "problems/formats/Kei18.h"

#include "framework/support/Config.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"

#include <algorithm>
#include <optional>

namespace mrpp
{

namespace
{

constexpr std::string_view kAgentForm = "3,4,10,11";
constexpr std::string_view kTimeForm = "0:(3,4),(5,5),";

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

Kei18Instance::Number readNumber(const TextReader &reader, LineCursor &cursor, const char *what)
{
    const std::size_t column = cursor.column();
    return {expectInteger(reader, cursor, what), column};
}

/// `(x,y)` or `(x,y,X_PLUS)`, with a direction that matters nowhere here.
std::pair<std::int64_t, std::int64_t> readCell(const TextReader &reader, LineCursor &cursor)
{
    expectText(reader, cursor, "(", kTimeForm);
    const std::int64_t x = expectInteger(reader, cursor, "column");
    expectText(reader, cursor, ",", kTimeForm);
    const std::int64_t y = expectInteger(reader, cursor, "row");
    if (cursor.take(","))
        (void)cursor.until(")");
    expectText(reader, cursor, ")", kTimeForm);
    return {x, y};
}

Kei18Instance readInstance(std::string_view text, const std::string &file)
{
    TextReader reader(text, file);
    Kei18Instance instance;
    instance.file = file;
    std::optional<Kei18Instance::Number> count;
    std::size_t countLine = 0;
    const auto readSetting = [&](LineCursor &cursor, std::string_view key, std::size_t keyColumn)
    {
        expectText(reader, cursor, "=", "agents=10");
        const std::size_t column = cursor.column();
        if (key == "map_file")
        {
            if (!instance.map.empty())
                reader.fail(keyColumn, "the map is named a second time");
            instance.map = cursor.until("");
            return;
        }
        if (key == "agents")
        {
            if (count)
                reader.fail(keyColumn, "the number of agents is given a second time");
            count = readNumber(reader, cursor, "number of agents");
            countLine = reader.line();
            expectEnd(reader, cursor, "agents=10");
            return;
        }
        const std::string_view value = cursor.until("");
        if (key == "random_problem" && value != "0")
            reader.fail(column,
                        "a random problem has other robots in every program; set random_problem=0 and "
                        "write the robots out");
        if (!isOneOf(key, {"seed", "random_problem", "max_timestep", "max_comp_time", "well_formed"}))
            reader.fail(keyColumn, inQuotes(key) + " is no key of a problem of one goal a robot; known: "
                                                   "map_file, agents, seed, random_problem, max_timestep, "
                                                   "max_comp_time, well_formed");
    };
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (cursor.atEnd() || cursor.take("#"))
            continue;
        if (line->find('=') != std::string_view::npos)
        {
            const std::size_t keyColumn = cursor.column();
            const std::string_view key = cursor.until("=");
            readSetting(cursor, key, keyColumn);
            continue;
        }
        Kei18Instance::Agent agent;
        agent.line = reader.line();
        agent.startX = readNumber(reader, cursor, "start's column");
        expectText(reader, cursor, ",", kAgentForm);
        agent.startY = readNumber(reader, cursor, "start's row");
        expectText(reader, cursor, ",", kAgentForm);
        agent.goalX = readNumber(reader, cursor, "goal's column");
        expectText(reader, cursor, ",", kAgentForm);
        agent.goalY = readNumber(reader, cursor, "goal's row");
        (void)cursor.take(",");
        expectEnd(reader, cursor, kAgentForm);
        instance.agents.push_back(agent);
    }
    if (!count)
        reader.fail(1, 1, "there is no line 'agents=<number of robots>'");
    if (count->value < 0 || count->value > static_cast<std::int64_t>(instance.agents.size()))
        reader.fail(countLine, count->column,
                    "there should be " + std::to_string(count->value) + " agents, but " +
                        std::to_string(instance.agents.size()) + " lines '" + std::string(kAgentForm) +
                        "' follow");
    instance.agents.resize(static_cast<std::size_t>(count->value)); // as the original programs do
    return instance;
}

} // namespace

Kei18Instance parseKei18Instance(std::string_view text, const std::string &file)
{
    return readAs(FormatId::kei18Instance, text, file, [&] { return readInstance(text, file); });
}

Instance kei18Instance(const Kei18Instance &text, const GridMap &map)
{
    InstanceBuilder builder(map.graph, text.file);
    const auto cell = [&](const Kei18Instance::Number &x, const Kei18Instance::Number &y, std::size_t line,
                          const std::string &role)
    {
        if (!map.contains(x.value, y.value))
            throw ParseError({text.file, line, x.column}, "the " + role + " " + cellName(x.value, y.value) +
                                                              " is outside the map of " +
                                                              std::to_string(map.width) + " columns and " +
                                                              std::to_string(map.height) + " rows");
        const Vertex v = map.vertexAt(static_cast<std::size_t>(x.value), static_cast<std::size_t>(y.value));
        if (v == kNoVertex)
            throw ParseError({text.file, line, x.column},
                             "the " + role + " " + cellName(x.value, y.value) + " is an obstacle");
        return v;
    };
    for (const Kei18Instance::Agent &agent : text.agents)
    {
        builder.addStart(cell(agent.startX, agent.startY, agent.line, "start"), agent.line,
                         agent.startX.column);
        builder.addGoal(cell(agent.goalX, agent.goalY, agent.line, "goal"), agent.line, agent.goalX.column);
    }
    return builder.take();
}

std::string formatKei18Instance(const Instance &instance, const std::string &mapName)
{
    const Cells cells(*instance.graph);
    TextWriter out;
    out.line("map_file=", mapName);
    out.line("agents=", std::uint64_t{instance.robotCount()});
    out.line("random_problem=0");
    for (std::size_t r = 0; r < instance.robotCount(); ++r)
    {
        const auto [startX, startY] = cells.cellOf(instance.starts[r]);
        const auto [goalX, goalY] = cells.cellOf(instance.goals[r]);
        out.line(startX, ',', startY, ',', goalX, ',', goalY);
    }
    return out.take();
}

namespace
{

SolutionRows readResult(std::string_view text, const std::string &file, const Instance &instance)
{
    const Cells cells(*instance.graph);
    TextReader reader(text, file);
    std::vector<std::vector<PathPoint>> paths;
    std::int64_t time = 0;
    bool begun = false;
    bool failed = false;
    while (const auto line = reader.next())
    {
        LineCursor cursor(*line);
        if (!begun)
        {
            failed = failed || trimmed(*line) == "solved=0";
            begun = cursor.take("solution") && cursor.take("=") && cursor.atEnd();
            continue;
        }
        if (cursor.atEnd())
            continue;
        const std::size_t timeColumn = cursor.column();
        if (expectInteger(reader, cursor, "time") != time)
            reader.fail(timeColumn, "expected the time " + std::to_string(time) +
                                        "; times are 0, 1, 2, … in their order");
        expectText(reader, cursor, ":", kTimeForm);
        std::size_t robot = 0;
        for (; !cursor.atEnd(); ++robot)
        {
            const std::size_t column = cursor.column();
            if (time > 0 && robot == paths.size())
                reader.fail(column, "there are more robots than at time 0, " + std::to_string(robot));
            const auto [x, y] = readCell(reader, cursor);
            const Vertex v = cells.vertexAt(x, y);
            if (v == kNoVertex)
                reader.fail(column, "robot " + std::to_string(robot) + " stands on " + cellName(x, y) +
                                        ", where the graph has no vertex");
            if (!cursor.atEnd())
                expectText(reader, cursor, ",", kTimeForm);
            if (time == 0)
                paths.emplace_back();
            paths[robot].push_back({v, static_cast<std::uint32_t>(reader.line())});
        }
        if (robot < paths.size())
            reader.fail(line->size() + 1, "there are " + std::to_string(robot) + " robots, fewer than the " +
                                              std::to_string(paths.size()) + " at time 0");
        ++time;
    }
    if (!begun)
        reader.fail(1, 1, "there is no line 'solution=', behind which the robots' places stand");
    if (time == 0)
        throw ParseError({file}, "there is no solution behind the line 'solution='");
    return rowsOfPaths(file, instance, paths);
}

} // namespace

SolutionRows parseKei18Result(std::string_view text, const std::string &file, const Instance &instance)
{
    return readAs(FormatId::kei18Result, text, file, [&] { return readResult(text, file, instance); });
}

std::string formatKei18Result(const Instance &instance, const Schedule &schedule, const std::string &mapName)
{
    const Cells cells(*instance.graph);
    std::vector<std::uint64_t> arrival(instance.robotCount(), 0); // the step after which it stays
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        for (const Move &move : schedule.step(step))
            arrival[move.robot] = step + 1;
    std::uint64_t costs = 0;
    for (const std::uint64_t time : arrival)
        costs += time;

    TextWriter out;
    const auto addCells = [&](const std::vector<Vertex> &vertices)
    {
        for (const Vertex v : vertices)
            out.add('(', cells.cellOf(v).first, ',', cells.cellOf(v).second, "),");
        out.line();
    };
    out.line("agents=", std::uint64_t{instance.robotCount()});
    out.line("map_file=", mapName);
    out.line("solver=mrppsim");
    out.line("solved=1");
    out.line("soc=", costs);
    out.line("makespan=", std::uint64_t{schedule.makespan()});
    out.line("comp_time=0");
    out.add("starts=");
    addCells(instance.starts);
    out.add("goals=");
    addCells(instance.goals);
    out.line("solution=");
    std::uint64_t time = 0;
    forEachTime(instance, schedule,
                [&](const std::vector<Vertex> &positions)
                {
                    out.add(time++, ':');
                    addCells(positions);
                });
    return out.take();
}

} // namespace mrpp
