/// The reader and writer of libMultiRobotPlanning's schedules.

#include "problems/formats/FormatId.h"
#include "problems/formats/LibMrpVertices.h"
#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/TextReader.h"
#include "problems/formats/support/TextWriter.h"
#include "problems/formats/support/YamlTree.h"

namespace mrpp
{

namespace
{

std::optional<Cells> cellsOf(const Graph &graph)
{
    try
    {
        return Cells(graph);
    }
    catch (const InputError &)
    {
        return std::nullopt;
    }
}

/// Whether a node is missing, or is `true` in one of its spellings or 1 (as the programs write it).
bool mayBeTrue(const Config *flag)
{
    return flag == nullptr || !flag->isScalar() ||
           (flag->text() != "0" && flag->text() != "false" && flag->text() != "False");
}

class ScheduleReader
{
public:
    ScheduleReader(std::string_view text, const std::string &file, const Instance &instance,
                   std::span<const std::string> vertexNames, std::span<const std::string> robotNames)
        : tree_(text, file), instance_(instance), vertices_(instance.graph->vertexCount(), vertexNames),
          cells_(cellsOf(*instance.graph))
    {
        for (const std::string &name : robotNames)
            robots_.emplace(name, robots_.size());
    }

    SolutionRows read()
    {
        const Config *statistics = tree_.root().find("statistics");
        const bool failed =
            statistics != nullptr && statistics->isMap() && !mayBeTrue(statistics->find("success"));
        if (failed && tree_.root().find("schedule") == nullptr)
            throw NoSolution({tree_.file()}, "the file says that there is no solution (success: false)");
        const Config &schedule = tree_.get(tree_.root(), "schedule");
        if (!schedule.isMap() && instance_.robotCount() > 0)
            tree_.fail(schedule, "expected a map of robots, 'agent0: …'");
        std::vector<std::vector<Stay>> stays(instance_.robotCount());
        for (const Config::Entry &entry : schedule.entries())
        {
            const std::size_t robot = robotOf(entry);
            if (!stays[robot].empty())
                tree_.fail(entry.where, "robot " + std::to_string(robot) + " has a path already");
            stays[robot] = readStates(entry);
        }
        return rowsOfStays(tree_.file(), instance_, stays);
    }

private:
    std::vector<Stay> readStates(const Config::Entry &entry) const
    {
        const auto &states = tree_.items(entry.value, "states");
        if (states.empty())
            throw NoSolution({tree_.file(), entry.where.line, entry.where.column},
                             inQuotes(entry.key) + " has no path: the program found none for this robot");
        std::vector<Stay> stays;
        for (const Config &state : states)
        {
            const Config &time = tree_.get(state, "t");
            const std::int64_t at = tree_.integer(time, "time");
            if (stays.empty() ? at != 0 : at <= stays.back().time)
                tree_.fail(time, stays.empty()
                                     ? std::string("expected the time 0; a path begins at the start")
                                     : "expected a time after " + std::to_string(stays.back().time) +
                                           "; times ascend");
            stays.push_back({at, vertexOf(state), static_cast<std::uint32_t>(state.where().line)});
        }
        return stays;
    }

    /// By the robot's own name, or by its number: where both name robots, whose start the path begins at.
    std::size_t robotOf(const Config::Entry &entry) const
    {
        const std::string prefix = "agent";
        const std::int64_t number =
            entry.key.starts_with(prefix) ? parseInteger(entry.key.substr(prefix.size())).value_or(-1) : -1;
        const bool isNumber = number >= 0 && static_cast<std::uint64_t>(number) < instance_.robotCount();
        const auto named = robots_.find(entry.key);
        if (named == robots_.end() && !isNumber)
            tree_.fail(entry.where,
                       inQuotes(entry.key) + " is none of the instance's " +
                           counted(instance_.robotCount(), "robot", "robots") +
                           (robots_.empty() ? ", agent0, agent1, …" : ", neither by name nor number"));
        if (named == robots_.end())
            return static_cast<std::size_t>(number);
        if (!isNumber || named->second == static_cast<std::size_t>(number))
            return named->second;
        const auto &states = tree_.items(entry.value, "states");
        const bool byNumber =
            !states.empty() && vertexOf(states.front()) == instance_.starts[static_cast<std::size_t>(number)];
        return byNumber ? static_cast<std::size_t>(number) : named->second;
    }

    Vertex vertexOf(const Config &state) const
    {
        if (const Config *name = state.find("v"))
        {
            const Vertex v = name->isScalar() ? vertices_.vertex(name->text()) : kNoVertex;
            if (v == kNoVertex)
                tree_.fail(*name, name->isScalar() ? "there is no vertex " + inQuotes(name->text())
                                                   : "expected a vertex's name");
            return v;
        }
        const std::int64_t x = tree_.integer(tree_.get(state, "x"), "column");
        const std::int64_t y = tree_.integer(tree_.get(state, "y"), "row");
        const Vertex v = cells_ ? cells_->vertexAt(x, y) : kNoVertex;
        if (v == kNoVertex)
            tree_.fail(state, "the graph has no vertex on the cell " + cellName(x, y));
        return v;
    }

    YamlDocument tree_;
    const Instance &instance_;
    LibMrpVertices vertices_;
    std::optional<Cells> cells_;
    std::unordered_map<std::string, std::size_t> robots_; ///< by their own names
};

} // namespace

SolutionRows parseLibMrpSchedule(std::string_view text, const std::string &file, const Instance &instance,
                                 std::span<const std::string> vertexNames,
                                 std::span<const std::string> robotNames)
{
    return readAs(FormatId::libMrpSchedule, text, file,
                  [&] { return ScheduleReader(text, file, instance, vertexNames, robotNames).read(); });
}

std::string formatLibMrpSchedule(const Instance &instance, const Schedule &schedule,
                                 std::span<const std::string> vertexNames,
                                 std::span<const std::string> robotNames)
{
    const auto map = vertexNames.empty() ? gridMapIfOne(*instance.graph) : std::nullopt;
    const LibMrpVertices vertices(instance.graph->vertexCount(), vertexNames);
    std::vector<std::vector<std::pair<std::size_t, Vertex>>> moves(instance.robotCount()); // (time, vertex)
    std::uint64_t cost = 0;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
        for (const Move &move : schedule.step(step))
            moves[move.robot].emplace_back(step + 1, move.to);
    for (const auto &path : moves)
        cost += path.empty() ? 0 : path.back().first;

    TextWriter out;
    out.line("statistics:");
    out.line("  cost: ", cost);
    out.line("  makespan: ", std::uint64_t{schedule.makespan()});
    out.line(instance.robotCount() > 0 ? "schedule:" : "schedule: {}");
    const auto writeState = [&](std::size_t time, Vertex v)
    {
        if (map)
        {
            const Point &cell = instance.graph->coordinate(v);
            out.line("    - x: ", static_cast<std::uint64_t>(cell.x));
            out.line("      y: ", static_cast<std::uint64_t>(cell.y));
        }
        else
            out.line("    - v: ", vertices.text(v));
        out.line("      t: ", std::uint64_t{time});
    };
    for (std::size_t robot = 0; robot < instance.robotCount(); ++robot)
    {
        out.line("  ", libMrpRobot(robot, robotNames), ':');
        Vertex at = instance.starts[robot];
        std::size_t time = 0;
        writeState(time, at);
        for (const auto &[arrival, vertex] : moves[robot])
        {
            while (++time < arrival)
                writeState(time, at);
            at = vertex;
            writeState(time, at);
        }
    }
    return out.take();
}

} // namespace mrpp
