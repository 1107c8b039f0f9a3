#include "cli/KeptFiles.h"

#include "framework/support/Fingerprint.h"
#include "problems/formats/Formats.h"

namespace mrpp
{

void KeptFiles::write(const RunSpec &spec, const RunResult &result)
{
    if (plan_.keep.instances && cases_.insert(spec.caseId).second)
    {
        const std::filesystem::path stem = folder_ / "instances" / spec.caseId;
        const std::filesystem::path graph = stem.string() + ".graphml";
        saveGraph(graph, *result.instance->graph);
        saveInstance(stem.string() + ".instance", *result.instance, graph);
    }
    const PlannerStatus status = result.record.status;
    if (plan_.keep.solutions && (status == PlannerStatus::solved || status == PlannerStatus::partial))
    {
        const std::string name = spec.caseId + "." + fileSafe(plan_.planners[spec.planner].name) + ".csv";
        saveSolution(folder_ / "solutions" / name, result.solution);
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
