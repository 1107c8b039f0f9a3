#include "framework/campaign/CommandPlanner.h"

#include "framework/support/Config.h"
#include "framework/support/OutsideProgram.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mrpp
{

namespace
{

bool proves(const OutsideCommand &command)
{
    return std::any_of(command.exitCodes.begin(), command.exitCodes.end(),
                       [](const auto &entry) { return entry.second == PlannerStatus::infeasible; });
}

} // namespace

CommandPlanner::CommandPlanner(OutsideCommand command, std::shared_ptr<const FileExchange> files)
    : Planner({.citation = "an outside program",
               .motion = command.motion,
               .completeFor = "what its authors say",
               .provesInfeasibility = proves(command)}),
      command_(std::move(command)), files_(std::move(files))
{
    for (const std::string &property : commandProperties())
        declareParam(property, values_[property], "", "of the command in the plan");
    for (const std::string &place : placesIn(command_.words))
        if (std::find(ownPlaces().begin(), ownPlaces().end(), place) == ownPlaces().end())
            declareParam(place, values_[place], "", "a place of the command");
}

bool CommandPlanner::uses(const std::string &place) const
{
    const auto places = placesIn(command_.words);
    return std::find(places.begin(), places.end(), place) != places.end();
}

std::filesystem::path CommandPlanner::fileOf(const std::string &place) const
{
    const std::string name = place == "graph"      ? "graph" + files_->extensionOf(command_.graphFormat)
                             : place == "instance" ? "instance" + files_->extensionOf(command_.instanceFormat)
                             : place == "map"      ? "graph.map"
                             : place == "scen"     ? "instance.scen"
                                                   : "answer";
    return folder_->path() / name;
}

void CommandPlanner::setup()
{
    folder_ = std::make_unique<TemporaryFolder>();
    const bool instanceNamesMap = uses("instance") && (command_.instanceFormat == "movingai_scenario" ||
                                                       command_.instanceFormat == "kei18_instance");
    try
    {
        if (uses("graph") || (uses("instance") && !instanceNamesMap))
            files_->writeGraph(command_.graphFormat, graph(), fileOf("graph"));
        if (uses("instance"))
            files_->writeInstance(command_.instanceFormat, instance(),
                                  fileOf(instanceNamesMap ? "map" : "graph"), fileOf("instance"));
        if (uses("map") || uses("scen") || instanceNamesMap)
            files_->writeGraph("movingai_map", graph(), fileOf("map"));
        if (uses("scen"))
            files_->writeInstance("movingai_scenario", instance(), fileOf("map"), fileOf("scen"));
    }
    catch (const FileError &)
    {
        throw;
    }
    catch (const InputError &error)
    {
        refusal_ = std::string("the program cannot be told the instance: ") + error.what();
    }
}

std::string CommandPlanner::valueOf(const std::string &place, const TerminationCondition &ptc) const
{
    if (const auto own = values_.find(place); own != values_.end())
        return own->second;
    if (place == "robots")
        return std::to_string(instance().robotCount());
    if (place == "seed") // many programs take no more than 31 bits
        return std::to_string(seed() % (Seed{1} << 31));
    if (place != "time_limit")
        return fileOf(place).string();
    constexpr double kForEver = 1e6;
    const double left =
        ptc.deadline()
            ? std::chrono::duration<double>(*ptc.deadline() - TerminationCondition::Clock::now()).count()
            : kForEver;
    constexpr double kMilli = 1000;
    return formatNumber(std::max(1.0, std::ceil(left * kMilli)) / kMilli);
}

PlannerStatus CommandPlanner::solve(const TerminationCondition &ptc)
{
    if (!refusal_.empty())
        return because(PlannerStatus::unsupported, refusal_);
    constexpr std::uintmax_t kMostBytes = std::uintmax_t{2} << 30;
    ProgramRequest request;
    for (const std::string &word : command_.words)
        request.words.push_back(
            fillPlaces(word, [&](const std::string &place) { return valueOf(place, ptc); }));
    request.folder = command_.folder;
    request.watched = fileOf("output");
    request.mostBytes = kMostBytes;
    if (!uses("output"))
        request.output = request.watched;
    request.stop = [&ptc] { return ptc(); };

    const ProgramEnd end = runProgram(request);
    if (!end.failure.empty())
        return because(PlannerStatus::crash, "cannot be started: " + end.failure);
    if (end.stopped)
        return PlannerStatus::timeout;
    if (end.tooMuch)
        return because(PlannerStatus::crash, "its answer grew beyond 2 GiB");
    if (end.signal != 0)
        return because(PlannerStatus::crash, "killed by signal " + std::to_string(end.signal) + " (" +
                                                 ::strsignal(end.signal) + ")");
    if (end.exitCode == 0)
        return readAnswer();
    const std::string reason = "ended with exit code " + std::to_string(end.exitCode);
    const auto known = command_.exitCodes.find(end.exitCode);
    if (known == command_.exitCodes.end())
        return because(PlannerStatus::crash, reason);
    return known->second == PlannerStatus::solved ? readAnswer() : because(known->second, reason);
}

PlannerStatus CommandPlanner::readAnswer()
{
    const std::filesystem::path file = fileOf("output");
    std::error_code error;
    if (!std::filesystem::exists(file, error) || std::filesystem::is_empty(file, error))
        return because(PlannerStatus::gave_up, "wrote no answer");
    try
    {
        const auto schedule = files_->readSolution(command_.answerFormat, instance(), file);
        if (!schedule)
            return because(PlannerStatus::gave_up, "says that it has no solution");
        setSolution(*schedule);
        return PlannerStatus::solved;
    }
    catch (const InputError &wrong)
    {
        const std::string line =
            wrong.where().line > 0 ? "line " + std::to_string(wrong.where().line) + ": " : "";
        return because(PlannerStatus::invalid, "its answer cannot be used: " + line + wrong.complaint());
    }
}

void CommandPlanner::clear()
{
    Planner::clear();
    folder_.reset();
    refusal_.clear();
}

} // namespace mrpp
