#include "problems/formats/PlanViz.h"

#include "problems/formats/support/Directions.h"
#include "problems/formats/support/TextWriter.h"

#include <cctype>

namespace mrpp
{

namespace
{

/// A JSON list of what `write(robot)` writes for each robot.
template <class Write>
void writeList(TextWriter &out, const char *key, std::size_t robots, Write &&write)
{
    out.add('"', std::string_view(key), "\":[");
    for (std::size_t robot = 0; robot < robots; ++robot)
    {
        out.add(std::string_view(robot == 0 ? "" : ","));
        write(robot);
    }
    out.add(']');
}

} // namespace

std::string formatPlanViz(const Instance &instance, const Schedule &schedule, PlanVizVersion version)
{
    const Cells cells(*instance.graph);
    const std::size_t robots = instance.robotCount();
    const std::vector<std::string> paths = directionsOf(instance, schedule, cells);
    std::vector<Vertex> ends = instance.starts;
    for (const Move &move : schedule.moves())
        ends[move.robot] = move.to;
    std::uint64_t finished = 0;
    std::uint64_t costs = 0;
    for (std::size_t robot = 0; robot < robots; ++robot)
    {
        finished += ends[robot] == instance.goals[robot] ? 1 : 0;
        costs += paths[robot].size();
    }

    const auto actionOf = [version](char letter)
    {
        if (version == PlanVizVersion::current && (letter == 'u' || letter == 'd'))
            return letter == 'u' ? 'D' : 'U';
        return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    };
    TextWriter out;
    const auto writePath = [&](std::size_t robot)
    {
        out.add('"');
        for (std::size_t step = 0; step < schedule.makespan(); ++step)
        {
            const char letter = step < paths[robot].size() ? paths[robot][step] : 'w';
            out.add(std::string_view(step == 0 ? "" : ","), actionOf(letter));
        }
        out.add('"');
    };
    const auto writeCell = [&](Vertex v) { out.add(cells.cellOf(v).second, ',', cells.cellOf(v).first); };
    out.add(R"({"actionModel":"MAPF","AllValid":"Yes","teamSize":)", std::uint64_t{robots}, ',');
    writeList(out, "start", robots,
              [&](std::size_t robot)
              {
                  out.add('[');
                  writeCell(instance.starts[robot]);
                  out.add(",\"N/A\"]");
              });
    out.add(",\"numTaskFinished\":", finished, ",\"sumOfCost\":", costs,
            ",\"makespan\":", std::uint64_t{schedule.makespan()}, ',');
    writeList(out, "actualPaths", robots, writePath);
    out.add(',');
    writeList(out, "plannerPaths", robots, writePath);
    out.add(",\"errors\":[],");
    writeList(out, "events", robots,
              [&](std::size_t robot)
              {
                  out.add("[[", std::uint64_t{robot}, ",0,\"assigned\"]");
                  if (ends[robot] == instance.goals[robot])
                      out.add(",[", std::uint64_t{robot}, ',', std::uint64_t{paths[robot].size()},
                              ",\"finished\"]");
                  out.add(']');
              });
    out.add(',');
    writeList(out, "tasks", robots,
              [&](std::size_t robot)
              {
                  out.add('[', std::uint64_t{robot}, ',');
                  writeCell(instance.goals[robot]);
                  out.add(']');
              });
    out.line('}');
    return out.take();
}

} // namespace mrpp
