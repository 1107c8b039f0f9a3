#include "framework/run/InputWatch.h"

#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Fingerprint.h"
#include "framework/support/HarnessError.h"
#include "framework/system/File.h"

#include <ctime>
#include <sys/stat.h>

namespace mrpp
{

namespace
{

constexpr std::int64_t kNano = 1'000'000'000;

std::int64_t nanoseconds(const std::timespec &time)
{
    return time.tv_sec * kNano + time.tv_nsec;
}

/// Whether a change that came right after that moment would be seen in the file's times, which are coarse.
bool isSettled(std::int64_t changed)
{
    constexpr std::int64_t kCoarsest = 2 * kNano + kNano / 2; // FAT counts two seconds
    std::timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    return nanoseconds(now) - changed > kCoarsest;
}

std::string hashOf(const std::filesystem::path &file)
{
    return Fingerprint().add(readFile(file)).hex();
}

} // namespace

std::vector<std::filesystem::path> inputFilesOf(const Configured &planner)
{
    std::vector<std::filesystem::path> paths;
    if (planner.command)
        for (const CommandFile &file : filesOf(*planner.command, planner.settings))
            paths.push_back(file.path);
    return paths;
}

std::vector<std::filesystem::path> inputFilesOf(const BenchmarkPlan &plan)
{
    std::vector<std::filesystem::path> all;
    const auto add = [&all](const std::vector<std::filesystem::path> &files)
    { all.insert(all.end(), files.begin(), files.end()); };
    for (const ProblemPoint &point : plan.points)
        try
        {
            add(point.problem->inputFiles());
        }
        catch (const InputError &)
        {
            // A file that names others is missing or malformed: expand() says so, with the plan's place.
        }
    for (const Configured &planner : plan.planners)
        add(inputFilesOf(planner));
    return all;
}

InputWatch::InputWatch(std::span<const std::filesystem::path> files)
{
    for (const std::filesystem::path &file : files)
    {
        if (hashes_.contains(file.string()))
            continue;
        try
        {
            hashes_.emplace(file.string(), hashOf(file));
        }
        catch (const FileError &)
        {
            // Whoever makes the keys says so.
        }
    }
}

InputWatch::Version InputWatch::versionOf(const std::filesystem::path &file)
{
    struct stat status = {};
    if (::stat(file.c_str(), &status) != 0)
        return {};
    return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino),
            static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

void InputWatch::check(std::span<const std::filesystem::path> files)
{
    const std::lock_guard lock(mutex_);
    for (const std::filesystem::path &file : files)
    {
        const std::string name = file.string();
        const Version version = versionOf(file);
        if (const auto known = checked_.find(name); known != checked_.end() && known->second == version)
            continue;
        const auto noted = hashes_.find(name);
        const bool exists = version.number != 0;
        if (noted == hashes_.end() || !exists || hashOf(file) != noted->second)
            throw HarnessError({name}, std::string(!exists                  ? "went away"
                                                   : noted == hashes_.end() ? "appeared"
                                                                            : "changed") +
                                           " while the campaign ran; nothing was recorded with it. The same "
                                           "command runs what is left, and again what depends on this file");
        if (isSettled(version.changed) && isSettled(version.modified))
            checked_[name] = version;
    }
}

} // namespace mrpp
