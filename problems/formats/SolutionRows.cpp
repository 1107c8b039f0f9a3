#include "problems/formats/SolutionRows.h"

#include "framework/support/Error.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// Throws unless there is a path for each robot, and it begins at the robot's start.
template <class Path>
void checkPaths(const std::string &file, const Instance &instance, const std::vector<Path> &paths)
{
    if (paths.size() != instance.robotCount())
        throw ParseError({file}, "there are paths of " + std::to_string(paths.size()) +
                                     " robots, but the instance has " +
                                     std::to_string(instance.robotCount()));
    for (std::size_t robot = 0; robot < paths.size(); ++robot)
    {
        if (paths[robot].empty())
            throw ParseError({file}, "robot " + std::to_string(robot) + " has no path");
        if (paths[robot].front().vertex != instance.starts[robot])
            throw ParseError({file, paths[robot].front().line},
                             "robot " + std::to_string(robot) + " begins on vertex " +
                                 std::to_string(paths[robot].front().vertex) +
                                 ", but in the instance it starts on vertex " +
                                 std::to_string(instance.starts[robot]));
    }
}

} // namespace

SolutionRows rowsOfStays(const std::string &file, const Instance &instance,
                         const std::vector<std::vector<Stay>> &paths)
{
    checkPaths(file, instance, paths);
    struct Arrival
    {
        std::int64_t time;
        TimedMove move;
        std::uint32_t line;
    };
    std::vector<Arrival> arrivals;
    for (std::size_t robot = 0; robot < paths.size(); ++robot)
        for (std::size_t i = 1; i < paths[robot].size(); ++i)
            if (const Stay &from = paths[robot][i - 1], &to = paths[robot][i]; from.vertex != to.vertex)
                arrivals.push_back(
                    {to.time, {0, static_cast<std::int64_t>(robot), from.vertex, to.vertex}, to.line});
    std::stable_sort(arrivals.begin(), arrivals.end(),
                     [](const Arrival &a, const Arrival &b) { return a.time < b.time; });
    SolutionRows rows;
    rows.file = file;
    std::int64_t step = -1;
    std::int64_t last = 0; // all arrivals are later
    for (Arrival &arrival : arrivals)
    {
        step += arrival.time != last ? 1 : 0;
        last = arrival.time;
        arrival.move.step = step;
        rows.moves.push_back(arrival.move);
        rows.lines.push_back(arrival.line);
    }
    return rows;
}

SolutionRows rowsOfPaths(const std::string &file, const Instance &instance,
                         const std::vector<std::vector<PathPoint>> &paths)
{
    checkPaths(file, instance, paths);
    std::vector<std::size_t> moving; // robots whose path goes on
    for (std::size_t robot = 0; robot < paths.size(); ++robot)
        moving.push_back(robot);

    SolutionRows rows;
    rows.file = file;
    std::int64_t step = 0;
    for (std::size_t time = 1; !moving.empty(); ++time)
    {
        const std::size_t before = rows.moves.size();
        std::erase_if(moving, [&](std::size_t robot) { return paths[robot].size() <= time; });
        for (const std::size_t robot : moving)
        {
            const PathPoint &from = paths[robot][time - 1];
            const PathPoint &to = paths[robot][time];
            if (from.vertex == to.vertex)
                continue;
            rows.moves.push_back({step, static_cast<std::int64_t>(robot), from.vertex, to.vertex});
            rows.lines.push_back(to.line);
        }
        step += rows.moves.size() > before ? 1 : 0;
    }
    return rows;
}

Schedule stepsOf(const SolutionRows &rows)
{
    Schedule schedule;
    std::vector<Move> step;
    for (std::size_t row = 0; row < rows.moves.size(); ++row)
    {
        const TimedMove &move = rows.moves[row];
        step.push_back(
            {static_cast<Robot>(move.robot), static_cast<Vertex>(move.from), static_cast<Vertex>(move.to)});
        if (row + 1 == rows.moves.size() || rows.moves[row + 1].step != move.step)
        {
            schedule.appendStep(step);
            step.clear();
        }
    }
    return schedule;
}

Schedule scheduleOf(const SolutionRows &rows, const Instance &instance)
{
    const Verdict verdict = validate(instance, rows.moves, MotionRule::rotation);
    if (!verdict.legal)
        throw ParseError({rows.file, rows.moves.empty() ? 0 : rows.lineOf(verdict.badMove)},
                         verdict.violation);
    return stepsOf(rows);
}

} // namespace mrpp
