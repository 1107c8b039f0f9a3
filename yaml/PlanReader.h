#pragma once
/// \file
/// Reads a plan: strict YAML in, a BenchmarkPlan out, every complaint with file:line:column.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/plan/PointError.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mrpp
{

/// Reads the plan's file. Relative paths in it start at its own folder, then at `searchPaths` in order. The
/// plan's plugins are loaded into the catalog.
/// Throws PlanError (grammar), ParamError, FileError.
[[nodiscard]] BenchmarkPlan readPlan(const std::filesystem::path &file, Catalog &catalog,
                                     const std::vector<std::filesystem::path> &searchPaths = {});

/// The same from text. \param file for messages, and for the folder where relative paths start
[[nodiscard]] BenchmarkPlan parsePlan(const std::string &text, const std::filesystem::path &file,
                                      Catalog &catalog,
                                      const std::vector<std::filesystem::path> &searchPaths = {});

/// What is wrong with a problem's input, at the place of the setting that leads to it. An error in a line of
/// a file stays there and names the problem and its place. \param plan as it was read
[[nodiscard]] PlanError placed(const PointError &error, const BenchmarkPlan &plan, const Catalog &catalog);

} // namespace mrpp
