#include "cli/KeptFiles.h"

#include "framework/support/Fingerprint.h"
#include "problems/formats/Formats.h"

#include <system_error>
#include <utility>
#include <vector>

namespace mrpp
{

void KeptFiles::write(const RunSpec &spec, const RunResult &result)
{
    if (!std::exchange(clean_, true))
        removeLeftovers();
    FileSet files;
    if (plan_.keep.instances && result.instance && cases_.insert(spec.caseId).second)
    {
        const std::filesystem::path stem = folder_ / "instances" / spec.caseId;
        const std::filesystem::path graph = stem.string() + ".graphml";
        saveGraph(files, graph, *result.instance->graph);
        saveInstance(files, stem.string() + ".instance", *result.instance, graph);
    }
    const PlannerStatus status = result.record.status;
    if (plan_.keep.solutions && (status == PlannerStatus::solved || status == PlannerStatus::partial))
    {
        const std::string name = spec.caseId + "." + fileSafe(plan_.planners[spec.planner].name) + ".csv";
        saveSolution(files, folder_ / "solutions" / name, result.solution);
    }
    files.commit();
}

void KeptFiles::removeLeftovers() const
{
    for (const char *part : {"instances", "solutions"})
    {
        std::vector<std::filesystem::path> leftovers;
        std::error_code error;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(folder_ / part, error))
        {
            const std::filesystem::path extension = entry.path().extension();
            if (entry.is_regular_file() && extension != ".graphml" && extension != ".instance" &&
                extension != ".csv")
                leftovers.push_back(entry.path());
        }
        for (const std::filesystem::path &file : leftovers)
            std::filesystem::remove(file, error);
    }
}

std::string fileSafe(const std::string &name)
{
    constexpr std::string_view kSafe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    constexpr std::size_t kLongest = 60;
    std::string safe = name.substr(0, kLongest);
    for (char &c : safe)
        if (kSafe.find(c) == std::string_view::npos)
            c = '_';
    return safe == name ? name : safe + "." + Fingerprint().add(name).hex().substr(0, 8);
}

} // namespace mrpp
