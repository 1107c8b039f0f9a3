#include "framework/outside/CommandPlanner.h"

#include "framework/outside/WorkingFolder.h"
#include "framework/support/Config.h"
#include "framework/support/HarnessError.h"
#include "framework/support/ReadableText.h"
#include "framework/system/Descriptor.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <fstream>
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

constexpr const char *kKilled = "did not end within 1 s after the time limit, and was killed";

/// Seconds until the deadline; very many where there is none.
double secondsLeft(const TerminationCondition &ptc)
{
    constexpr double kForEver = 1e6;
    if (!ptc.deadline())
        return kForEver;
    return std::chrono::duration<double>(*ptc.deadline() - TerminationCondition::Clock::now()).count();
}

/// The seconds that a program is told at that place, rounded down: a limit that it may use up.
double toldSeconds(const std::string &place, double seconds)
{
    constexpr double kMilli = 1000;
    return place == "time_limit_s" ? std::max(1.0, std::floor(seconds))
                                   : std::max(1.0, std::floor(seconds * kMilli)) / kMilli;
}

/// The end of a file, without reading what is before it.
std::string endOf(const std::filesystem::path &file)
{
    constexpr std::size_t kMost = 2048;
    constexpr std::size_t kWhole = 4; // bytes more, so that a cut shows
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(stream.tellg());
    stream.seekg(std::max<std::streamoff>(0, size - static_cast<std::streamoff>(kMost + kWhole)));
    const std::string end{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return std::string(tail(end, kMost));
}

} // namespace

CommandPlanner::CommandPlanner(OutsideCommand command, std::shared_ptr<const FileExchange> files)
    : Planner({.citation = "an outside program",
               .motion = command.motion,
               .completeFor = "what its authors say",
               .version = 2, // 2: runs in a folder of its own, with a margin
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
        makeWorkingFolder(folder_->path() / "work", command_.folder);
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

std::string CommandPlanner::valueOf(const std::string &place, double secondsLeft) const
{
    if (const auto own = values_.find(place); own != values_.end())
        return own->second;
    if (place == "robots")
        return std::to_string(instance().robotCount());
    if (place == "seed") // many programs take no more than 31 bits
        return std::to_string(seed() % (Seed{1} << 31));
    if (place == "folder")
        return (folder_->path() / "work").string();
    if (place == "plan_folder")
        return command_.folder.string();
    if (!place.starts_with("time_limit"))
        return fileOf(place).string();
    constexpr double kMilli = 1000;
    const double told = toldSeconds(place, secondsLeft);
    return formatNumber(place == "time_limit_ms" ? std::round(told * kMilli) : told);
}

/// The least limit that the program is told; where it is told none, when it should be ready.
double CommandPlanner::ownLimit(double secondsLeft) const
{
    std::optional<double> least;
    for (const char *place : {"time_limit", "time_limit_s", "time_limit_ms"})
        if (uses(place))
            least = std::min(toldSeconds(place, secondsLeft), least.value_or(secondsLeft + 1));
    return least.value_or(secondsLeft);
}

ProgramEnd CommandPlanner::runIt(const TerminationCondition &ptc)
{
    constexpr std::uintmax_t kMostBytes = std::uintmax_t{2} << 30;
    const double limit = secondsLeft(ptc);
    const double left = limit - timeMargin(command_, limit);
    ProgramRequest request;
    for (std::size_t i = 0; i < command_.words.size(); ++i)
        request.words.push_back(givenWord(
            command_, i,
            fillPlaces(command_.words[i], [&](const std::string &place) { return valueOf(place, left); })));
    request.folder = folder_->path() / "work";
    request.watched = fileOf("output");
    request.mostBytes = kMostBytes;
    if (!uses("output"))
        request.output = request.watched;
    request.stop = [&ptc] { return ptc(); };

    const auto start = TerminationCondition::Clock::now();
    ProgramEnd end = runProgram(request);
    const std::chrono::duration<double> spent = TerminationCondition::Clock::now() - start;
    constexpr double kAsGoodAs = 0.95; // programs look at the clock now and then, and foresee their end
    const double own = ownLimit(left);
    if (ptc.deadline() && spent.count() >= own * kAsGoodAs)
        ownLimit_ = " at its limit of " + formatNumber(std::round(own * 1000) / 1000) + " s";
    errorTail_ = readable(end.errorTail);
    outputTail_ = readable(uses("output") ? end.outputTail : endOf(request.output));
    return end;
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
    const ProgramEnd end = runIt(ptc);
    if (!end.failure.empty())
        throw HarnessError(command_.where, "the program '" + command_.words.front() +
                                               "' cannot be started: " + end.failure + kAdvice);
    if (end.stopped)
        return because(PlannerStatus::timeout, secondsLeft(ptc) > 0 ? "" : kKilled);
    if (end.tooMuch)
        return because(PlannerStatus::crash, "its answer grew beyond 2 GiB");
    if (end.signal != 0)
        return because(PlannerStatus::crash, "killed by signal " + std::to_string(end.signal) + " (" +
                                                 ::strsignal(end.signal) + ")");
    if (end.exitCode == 0)
        return PlannerStatus::solved; // if its answer says so, too
    const std::string how = "ended with exit code " + std::to_string(end.exitCode);
    const auto known = command_.exitCodes.find(end.exitCode);
    const PlannerStatus status = known == command_.exitCodes.end() ? PlannerStatus::crash : known->second;
    if (status == PlannerStatus::solved)
        return status;
    return status == PlannerStatus::gave_up ? gaveUp(how) : because(status, how + ownLimit_);
}

/// Ended without an answer: of its own accord, or because it was out of time.
PlannerStatus CommandPlanner::gaveUp(const std::string &how)
{
    return because(ownLimit_.empty() ? PlannerStatus::gave_up : PlannerStatus::timeout, how + ownLimit_);
}

/// What is wrong with the file in which the answer should be; empty where it can be read, "nothing" where
/// nothing is in it.
std::string CommandPlanner::missingAnswer() const
{
    const std::filesystem::path file = fileOf("output");
    const Descriptor answer(
        ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)); // a pipe must not hold us up
    const int reason = errno;
    struct stat status = {};
    if (answer.number() < 0 && reason == ENOENT)
        return "nothing";
    if (answer.number() < 0 && (reason == EMFILE || reason == ENFILE || reason == ENOMEM || reason == EIO))
        throw HarnessError({file.string()},
                           std::string("cannot be read: ") + std::strerror(reason) + kAdvice);
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
        return gaveUp("wrote no answer");
    else if (!missing.empty())
        return because(PlannerStatus::invalid, "its answer cannot be used: " + missing);
    try
    {
        const auto schedule = files_->readSolution(command_.answerFormat, instance(), file);
        if (schedule)
        {
            setSolution(*schedule);
            return PlannerStatus::solved;
        }
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
        return because(PlannerStatus::invalid,
                       "its answer cannot be used: " + line + readable(wrong.complaint()));
    }
    return gaveUp("says that it found no solution");
}

void CommandPlanner::clear()
{
    Planner::clear();
    folder_.reset();
    for (std::string *text : {&refusal_, &ownLimit_, &outputTail_, &errorTail_})
        text->clear();
}

} // namespace mrpp
