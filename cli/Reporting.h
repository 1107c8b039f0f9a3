#pragma once
/// \file
/// Writes a campaign's reports from what its folder holds.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// The plan of the campaign in that folder, read as if it stood where it was run from: its relative paths,
/// and the campaign's name where the file gave it, start there. \param text that of an older plan; without it
/// the folder's own copy Throws InputError where the folder holds no campaign.
[[nodiscard]] BenchmarkPlan campaignPlan(const std::filesystem::path &folder, Catalog &catalog,
                                         const std::optional<std::string> &text = std::nullopt);

/// Writes the reports of these kinds in order; returns all files that they wrote. Throws InputError where the
/// folder holds no campaign.
std::vector<std::filesystem::path> writeReports(const BenchmarkPlan &plan,
                                                const std::vector<std::string> &kinds,
                                                const std::filesystem::path &folder, const Catalog &catalog);

/// Says on the standard output where to look: at the report itself, else at the tables; and on the standard
/// error what could not be drawn, and why.
void sayWhere(const std::vector<std::filesystem::path> &files, const std::filesystem::path &folder);

} // namespace mrpp
