#pragma once
/// \file
/// The files that runs depend on, by their contents, and what is said where one is missing or does not fit.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/support/Error.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// Hashes of input files, each read once.
class InputHashes
{
public:
    /// Throws FileError.
    [[nodiscard]] std::string of(const std::filesystem::path &file);

    /// Of all files together; nothing where one is missing and that is tolerated.
    [[nodiscard]] std::optional<std::string> of(const std::vector<std::filesystem::path> &files,
                                                MissingInput missing);

private:
    std::map<std::filesystem::path, std::string> known_;
};

/// Names of files and hashes of their contents.
using FileHashes = std::vector<std::pair<std::string, std::string>>;

/// Of each planner: the files that its answers depend on (filesOf()), none but for outside programs; nothing
/// where one is missing and that is tolerated. Reads them. Throws PlanError.
[[nodiscard]] std::vector<std::optional<FileHashes>> identifyPlanners(const BenchmarkPlan &plan,
                                                                      MissingInput missing);

} // namespace mrpp
