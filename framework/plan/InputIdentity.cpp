#include "framework/plan/InputIdentity.h"

#include "framework/support/Fingerprint.h"
#include "framework/system/File.h"

namespace mrpp
{

std::string InputHashes::of(const std::filesystem::path &file)
{
    std::string &hash = known_[file];
    if (hash.empty())
        hash = Fingerprint().add(readFile(file)).hex();
    return hash;
}

std::optional<std::string> InputHashes::of(const std::vector<std::filesystem::path> &files,
                                           MissingInput missing)
{
    Fingerprint hash;
    for (const std::filesystem::path &file : files)
    {
        try
        {
            hash.add(of(file));
        }
        catch (const FileError &)
        {
            if (missing == MissingInput::tolerate)
                return std::nullopt;
            throw;
        }
    }
    return hash.hex();
}

std::vector<std::optional<FileHashes>> identifyPlanners(const BenchmarkPlan &plan, MissingInput missing)
{
    InputHashes hashes;
    std::vector<std::optional<FileHashes>> planners;
    for (const Configured &planner : plan.planners)
    {
        planners.emplace_back(FileHashes());
        if (!planner.command)
            continue;
        try
        {
            for (const CommandFile &file : filesOf(*planner.command, planner.settings))
                planners.back()->emplace_back(file.name, hashes.of(file.path));
        }
        catch (const FileError &error)
        {
            if (missing == MissingInput::refuse)
                throw PlanError(planner.command->where,
                                "planner '" + planner.name + "' depends on a file: " + error.what());
            planners.back().reset();
        }
    }
    return planners;
}

} // namespace mrpp
