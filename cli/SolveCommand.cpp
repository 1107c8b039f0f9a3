#include "cli/Commands.h"
#include "cli/Interruption.h"
#include "cli/WorkLine.h"
#include "framework/evaluation/Condense.h"
#include "framework/run/ReadableRecord.h"
#include "framework/run/RunPlanner.h"
#include "framework/support/Config.h"
#include "problems/formats/Formats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iostream>

namespace mrpp
{

namespace
{

std::vector<NamedOptimizer> makeOptimizers(const std::vector<std::string> &names, const Catalog &catalog)
{
    std::vector<NamedOptimizer> optimizers;
    for (const std::string &name : names)
        if (name != "none")
            optimizers.push_back({name, catalog.optimizers.create(name)});
    return optimizers;
}

std::string toJson(const RunRecord &record)
{
    nlohmann::ordered_json object;
    for (const RunColumn &column : runColumns())
    {
        if (!column.inSolveJson)
            continue;
        auto &slot = object[std::string(column.name)];
        std::visit(
            [&slot](const auto &value)
            {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                    slot = nullptr;
                else
                    slot = value;
            },
            column.get(record));
    }
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// "name  value" where there is a value.
template <class T>
void sayLine(const char *name, const std::optional<T> &value, const std::string &more = {})
{
    if (value)
        std::cout << fmt::format("{:<12}{}{}\n", name, *value, more);
}

/// ", optimized 12" where there is such a number.
std::string optimized(const std::optional<std::int64_t> &value)
{
    return value ? fmt::format(", optimized {}", *value) : "";
}

std::string bound(const std::optional<std::int64_t> &value)
{
    return value ? fmt::format(" (at least {})", *value) : "";
}

void say(const RunRecord &record)
{
    std::cout << fmt::format("{:<12}{}\n", "planner", record.planner)
              << fmt::format("{:<12}{} vertices, {} edges, {} robots\n", "instance",
                             record.vertices.value_or(0), record.edges.value_or(0), record.robots.value_or(0))
              << fmt::format("{:<12}{}{}\n", "status", toString(record.status),
                             record.reason.empty() ? "" : ": " + record.reason);
    if (record.time)
        std::cout << fmt::format("{:<12}{:.6f} s (setup {:.6f} s, optimizing {:.6f} s)\n", "time",
                                 *record.time, record.setupTime.value_or(0),
                                 record.optimizationTime.value_or(0));
    if (record.memory)
        std::cout << fmt::format("{:<12}{:.1f} MB\n", "memory", *record.memory);
    sayLine("moves", record.pathLength,
            optimized(record.optimizedPathLength) + bound(record.pathLengthLowerBound));
    sayLine("actions", record.actions, optimized(record.optimizedActions));
    sayLine("makespan", record.makespan,
            optimized(record.optimizedMakespan) + bound(record.makespanLowerBound));
    sayLine("costs", record.sumOfCosts, optimized(record.optimizedSumOfCosts));
}

/// Writes what was asked for and exists, all of it or nothing.
/// \param motion the widest rule that an animation may show
void writeFiles(FileSet &files, const SolveArguments &arguments, const RunResult &result,
                const Instance &instance, MotionRule motion)
{
    if (arguments.json)
        files.add(*arguments.json).write(toJson(result.record));
    const bool anyMoves =
        arguments.solution || arguments.optimizedSolution || arguments.schedule || arguments.animation;
    if (anyMoves && !result.record.solved())
        std::cerr << "no solution, so no file of moves was written\n";
    if (anyMoves && result.record.solved())
    {
        if (arguments.solution)
            saveSolution(files, *arguments.solution, result.solution);
        if (arguments.optimizedSolution)
            saveSolution(files, *arguments.optimizedSolution,
                         result.record.optimizedPathLength ? result.optimized : result.solution);
        if (arguments.schedule)
            saveSolution(files, *arguments.schedule,
                         condense(instance, result.solution, MotionRule::following));
        if (arguments.animation)
            saveAnimation(files, *arguments.animation, instance, condense(instance, result.solution, motion));
    }
    files.commit();
}

std::optional<std::size_t> toSize(const std::optional<std::int64_t> &number)
{
    return number ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
}

} // namespace

ExitCode solve(const SolveArguments &arguments, const Catalog &catalog)
{
    constexpr std::chrono::milliseconds kPatience{100};
    FileSet files;
    WorkLine line;
    Interruption interruption(kPatience, [&files] { files.abandon(); });
    const auto planner = catalog.planners.create(arguments.planner);
    for (const auto &[name, value] : arguments.settings)
        planner->parameters().set(name, value);
    planner->setSeed(arguments.seed);
    const auto optimizers = makeOptimizers(arguments.optimizers, catalog);

    LoadedInstance loaded =
        loadInstance({arguments.instance, arguments.graph, toSize(arguments.robots), arguments.passability});
    for (const std::string &warning : loaded.warnings)
        std::cerr << "warning: " << warning << '\n';
    const auto instance = std::make_shared<const Instance>(std::move(loaded.instance));

    RunSettings settings;
    settings.limits = {arguments.timeLimit, arguments.memoryLimit};
    settings.motion = *motionRule(arguments.motion);
    settings.until = TerminationCondition::after(arguments.timeLimit + preparationTime(arguments.timeLimit));
    const PreparedInstance prepared =
        prepare(instance, preparationTime(arguments.timeLimit),
                {TerminationCondition::when(interruption.token()), line.listener()});
    line.clear();
    RunResult result = runPlanner(*planner, prepared, optimizers, settings, interruption.token());
    if (interruption.happened())
    {
        std::cerr << "interrupted; nothing was written\n";
        return ExitCode::interrupted;
    }
    makeReadable(result.record);
    result.record.planner = arguments.planner;
    say(result.record);
    writeFiles(files, arguments, result, *instance, settings.motion);
    interruption.waitFromNowOn(); // everything is written
    if (result.record.status == PlannerStatus::invalid || result.record.status == PlannerStatus::crash)
        return ExitCode::defect;
    return result.record.solved() ? ExitCode::done : ExitCode::no;
}

} // namespace mrpp
