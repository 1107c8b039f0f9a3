#include "framework/campaign/CommandPlanner.h"

#include "framework/support/Config.h"
#include "framework/support/Descriptor.h"
#include "framework/support/HarnessError.h"
#include "framework/support/OutsideProgram.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>

namespace mrpp
{

namespace
{

constexpr const char *kAdvice =
    "; nothing was recorded for this run: once that is mended, the same command goes on";

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
    try
    {
        folder_ = std::make_unique<TemporaryFolder>();
        writeInput();
    }
    catch (const FileError &error)
    {
        throw HarnessError(error.where(), error.complaint() + kAdvice);
    }
    catch (const InputError &error)
    {
        refusal_ = std::string("the program cannot be told the instance: ") + error.what();
    }
}

void CommandPlanner::writeInput() const
{
    const bool instanceNamesMap = uses("instance") && (command_.instanceFormat == "movingai_scenario" ||
                                                       command_.instanceFormat == "kei18_instance");
    if (uses("graph") || (uses("instance") && !instanceNamesMap))
        files_->writeGraph(command_.graphFormat, graph(), fileOf("graph"));
    if (uses("instance"))
        files_->writeInstance(command_.instanceFormat, instance(), fileOf(instanceNamesMap ? "map" : "graph"),
                              fileOf("instance"));
    if (uses("map") || uses("scen") || instanceNamesMap)
        files_->writeGraph("movingai_map", graph(), fileOf("map"));
    if (uses("scen"))
        files_->writeInstance("movingai_scenario", instance(), fileOf("map"), fileOf("scen"));
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
    return unlessFull(run(ptc));
}

PlannerStatus CommandPlanner::collect()
{
    return unlessFull(readAnswer());
}

PlannerStatus CommandPlanner::unlessFull(PlannerStatus status)
{
    using enum PlannerStatus;
    if (status == solved || status == timeout || !isFull(folder_->path()))
        return status;
    constexpr std::uintmax_t kMuch = std::uintmax_t{64} << 20; // bytes
    constexpr double kMega = 1e6;
    const std::uintmax_t own = bytesIn(folder_->path());
    if (own < kMuch)
        throw HarnessError({folder_->path().parent_path().string()},
                           "the temporary folder (TMPDIR) has no room left" + std::string(kAdvice));
    return because(crash, "filled the temporary folder with " +
                              formatNumber(std::round(static_cast<double>(own) / kMega)) + " MB");
}

PlannerStatus CommandPlanner::run(const TerminationCondition &ptc)
{
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
        throw HarnessError(command_.where, "the program '" + command_.words.front() +
                                               "' cannot be started: " + end.failure + kAdvice);
    if (end.stopped)
        return PlannerStatus::timeout;
    if (end.tooMuch)
        return because(PlannerStatus::crash, "its answer grew beyond 2 GiB");
    if (end.signal != 0)
        return because(PlannerStatus::crash, "killed by signal " + std::to_string(end.signal) + " (" +
                                                 ::strsignal(end.signal) + ")");
    if (end.exitCode == 0)
        return PlannerStatus::solved; // if its answer says so, too
    const std::string reason = "ended with exit code " + std::to_string(end.exitCode);
    const auto known = command_.exitCodes.find(end.exitCode);
    if (known == command_.exitCodes.end())
        return because(PlannerStatus::crash, reason);
    return because(known->second, known->second == PlannerStatus::solved ? "" : reason);
}

/// What is wrong with the file in which the answer should be; empty where it can be read, "nothing" where
/// nothing is in it.
std::string CommandPlanner::missingAnswer() const
{
    const std::filesystem::path file = fileOf("output");
    const Descriptor answer(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)); // a pipe must not hold us up
    const int reason = errno;
    struct stat status = {};
    if (answer.number() < 0 && reason == ENOENT)
        return "nothing";
    if (answer.number() < 0 && (reason == EMFILE || reason == ENFILE || reason == ENOMEM || reason == EIO))
        throw HarnessError({file.string()}, std::string("cannot be read: ") + std::strerror(reason) + kAdvice);
    if (answer.number() < 0 || ::fstat(answer.number(), &status) != 0)
        return std::strerror(reason);
    if (!S_ISREG(status.st_mode))
        return "it is no file, but a folder, a pipe or a device";
    return status.st_size == 0 ? "nothing" : "";
}

PlannerStatus CommandPlanner::readAnswer()
{
    const std::filesystem::path file = fileOf("output");
    if (const std::string missing = missingAnswer(); missing == "nothing")
        return because(PlannerStatus::gave_up, "wrote no answer");
    else if (!missing.empty())
        return because(PlannerStatus::invalid, "its answer cannot be used: " + missing);
    try
    {
        const auto schedule = files_->readSolution(command_.answerFormat, instance(), file);
        if (!schedule)
            return because(PlannerStatus::gave_up, "says that it has no solution");
        setSolution(*schedule);
        return PlannerStatus::solved;
    }
    catch (const FileError &error)
    {
        throw HarnessError(error.where(), error.complaint() + kAdvice);
    }
    catch (const std::bad_alloc &)
    {
        throw HarnessError({file.string()}, "there is not enough memory to read this answer");
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
