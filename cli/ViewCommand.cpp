#include "cli/Commands.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Metrics.h"
#include "framework/evaluation/Validator.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/formats/Formats.h"
#include "reports/explorer/ExplorerPage.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace mrpp
{

namespace
{

void warn(const std::vector<std::string> &warnings)
{
    for (const std::string &warning : warnings)
        std::cerr << "warning: " << warning << '\n';
}

/// Throws ParseError for robots and vertices that do not exist: those cannot be drawn.
void checkNumbers(const SolutionRows &rows, const Instance &instance)
{
    const auto vertices = static_cast<std::int64_t>(instance.graph->vertexCount());
    const auto robots = static_cast<std::int64_t>(instance.robotCount());
    for (std::size_t row = 0; row < rows.moves.size(); ++row)
    {
        const auto check = [&](const char *what, std::int64_t number, std::int64_t count)
        {
            if (number < 0 || number >= count)
                throw ParseError({rows.file, rows.lineOf(row)},
                                 std::string(what) + " " + std::to_string(number) +
                                     " does not exist; there are " + std::to_string(count));
        };
        const TimedMove &move = rows.moves[row];
        check("robot", move.robot, robots);
        check("vertex", move.from, vertices);
        check("vertex", move.to, vertices);
    }
}

/// What the moves say themselves where there is no instance: robots start where they first move from, and
/// mean to go where they last move to.
Instance instanceOf(const SolutionRows &rows, std::shared_ptr<const Graph> graph)
{
    constexpr std::int64_t kMostRobots = std::numeric_limits<std::int32_t>::max();
    std::int64_t robots = 0;
    for (const TimedMove &move : rows.moves)
        if (move.robot < kMostRobots)
            robots = std::max(robots, move.robot + 1);
    const auto unknown = static_cast<std::int64_t>(kNoVertex);
    std::vector<std::int64_t> starts(static_cast<std::size_t>(robots), unknown);
    std::vector<std::int64_t> goals = starts;
    for (const TimedMove &move : rows.moves)
    {
        if (move.robot < 0 || move.robot >= robots)
            continue;
        const auto robot = static_cast<std::size_t>(move.robot);
        if (starts[robot] == unknown)
            starts[robot] = move.from;
        goals[robot] = move.to;
    }
    Instance instance{std::move(graph), {}, {}};
    for (const auto &[from, to] : {std::pair(&starts, &instance.starts), std::pair(&goals, &instance.goals)})
        to->assign(from->begin(), from->end());
    if (const auto defect = instance.defect())
        throw ParseError({rows.file}, "the moves alone do not say where every robot starts and has to go (" +
                                          *defect + "); give --instance");
    return instance;
}

struct Loaded
{
    Instance instance;
    std::string name;
    std::vector<SolutionRows> solutions;
};

std::vector<SolutionRows> loadSolutions(const ViewArguments &arguments, const LoadedInstance &loaded)
{
    std::vector<SolutionRows> solutions;
    for (const std::filesystem::path &file : arguments.solutions)
    {
        solutions.push_back(loadSolution(file, loaded));
        warn(solutions.back().warnings);
    }
    return solutions;
}

Loaded load(const ViewArguments &arguments)
{
    if (arguments.instance)
    {
        const auto robots =
            arguments.robots ? std::optional(static_cast<std::size_t>(*arguments.robots)) : std::nullopt;
        LoadedInstance loaded =
            loadInstance({*arguments.instance, arguments.graph, robots, arguments.passability});
        warn(loaded.warnings);
        auto solutions = loadSolutions(arguments, loaded);
        return {std::move(loaded.instance), arguments.instance->filename().string(), std::move(solutions)};
    }
    if (!arguments.graph)
        throw InputError("view needs --instance or --graph, to know where the robots are");
    LoadedGraph loaded = loadGraph(*arguments.graph, passability(arguments.passability));
    warn(loaded.warnings);
    std::vector<SolutionRows> solutions;
    try
    {
        solutions = loadSolutions(arguments, {Instance{loaded.graph, {}, {}}, {}, loaded.vertexNames});
    }
    catch (const InputError &error)
    {
        throw InputError(error.where(), error.complaint() + " (such a file may need --instance)");
    }
    Instance instance = instanceOf(solutions.front(), std::move(loaded.graph));
    return {std::move(instance), arguments.graph->filename().string(), std::move(solutions)};
}

RunRecord describe(const Instance &instance, const Verdict &verdict, const Schedule &schedule)
{
    RunRecord record;
    record.model = "view";
    record.vertices = static_cast<std::int64_t>(instance.graph->vertexCount());
    record.edges = static_cast<std::int64_t>(instance.graph->edgeCount());
    record.robots = static_cast<std::int64_t>(instance.robotCount());
    record.free = static_cast<std::int64_t>(instance.freeCount());
    record.occupancy = instance.occupancy();
    if (const auto bounds = lowerBounds(instance))
    {
        record.pathLengthLowerBound = static_cast<std::int64_t>(bounds->pathLength);
        record.makespanLowerBound = static_cast<std::int64_t>(bounds->makespan);
    }
    record.status = verdict.valid() ? PlannerStatus::solved
                    : verdict.legal ? PlannerStatus::partial
                                    : PlannerStatus::invalid;
    record.reason = verdict.violation;
    record.pathLength = static_cast<std::int64_t>(schedule.pathLength());
    record.makespan = static_cast<std::int64_t>(schedule.makespan());
    record.completed = instance.robotCount() == 0
                           ? 1
                           : static_cast<double>(verdict.atGoal) / static_cast<double>(instance.robotCount());
    return record;
}

} // namespace

ExitCode view(const ViewArguments &arguments)
{
    const Loaded loaded = load(arguments);
    const Instance &instance = loaded.instance;
    std::vector<RunRecord> records;
    PlayableRuns playable(std::numeric_limits<std::size_t>::max());
    ExplorerContents contents;
    contents.title = loaded.name;
    for (const SolutionRows &rows : loaded.solutions)
    {
        const Verdict verdict = validate(instance, rows.moves, *motionRule(arguments.motion));
        checkNumbers(rows, instance);
        const Schedule schedule = stepsOf(rows);
        RunRecord record = describe(instance, verdict, schedule);
        record.caseId = record.problem = loaded.name;
        record.planner = std::filesystem::path(rows.file).filename().string();
        record.motion = arguments.motion;
        std::cout << rows.file << ": " << schedule.pathLength() << " moves in " << schedule.makespan()
                  << " steps, " << (verdict.valid() ? "valid" : verdict.violation) << '\n';
        const std::size_t run = records.size();
        const Solution solution =
            verdict.legal ? schedule.toSolution(instance.graph->vertexCount()) : Solution();
        // A schedule of several actions at once is shown as it is; moves one after another can be condensed.
        if (verdict.legal && solution.actionCount() == schedule.makespan())
            playable.add(run, loaded.name, instance, solution);
        else
            playable.add(run, loaded.name, instance, schedule);
        contents.planners.push_back(record.planner);
        records.push_back(std::move(record));
    }
    contents.records = records;
    contents.absences.resize(records.size());
    contents.playable = &playable;
    contents.provenance = {{"graph and robots", loaded.name}, {"motion rule", arguments.motion}};
    writeFile(arguments.output, explorerPage(contents));
    std::cout << "page: " << arguments.output.string() << '\n';
    return ExitCode::done;
}

} // namespace mrpp
