#include "reports/AnimationsReport.h"

#include "framework/evaluation/Condense.h"
#include "framework/support/Error.h"
#include "framework/support/Fingerprint.h"
#include "problems/formats/Formats.h"

#include <algorithm>

namespace mrpp
{

namespace
{

/// The case and the planner as a file's name: what file systems could mind is replaced, and names that become
/// alike by that are told apart.
std::string fileNameOf(const RunRecord &record)
{
    constexpr std::string_view kSafe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.=";
    constexpr std::size_t kLongest = 120;
    const std::string name = record.caseId + "." + record.planner;
    std::string safe = name.substr(0, kLongest);
    std::replace(safe.begin(), safe.end(), '/', '-');
    const std::string readable = safe;
    std::replace_if(
        safe.begin(), safe.end(), [&](char c) { return kSafe.find(c) == std::string_view::npos; }, '_');
    if (safe != readable || name.size() > kLongest)
        safe += "." + Fingerprint().add(name).hex().substr(0, 8);
    return safe + ".txt";
}

} // namespace

std::vector<std::filesystem::path> AnimationsReport::write(const ResultTable &results, const Provenance &,
                                                           const std::filesystem::path &folder) const
{
    const std::filesystem::path animations = folder / "animations";
    std::error_code error;
    std::filesystem::create_directories(animations, error);
    if (!std::filesystem::is_directory(animations))
        throw FileError({animations.string()}, "cannot be made: " + error.message());

    std::vector<std::filesystem::path> files;
    for (const RunRecord &record : results.records())
    {
        if (record.repetition != 0)
            continue;
        const auto solution = results.solution(record);
        const auto instance = solution ? results.instance(record) : std::nullopt;
        if (!instance)
            continue;
        const MotionRule rule = solution->rotations().empty() ? MotionRule::following : MotionRule::rotation;
        files.push_back(animations / fileNameOf(record));
        saveAnimation(files.back(), *instance, condense(*instance, *solution, rule));
    }
    return files;
}

} // namespace mrpp
