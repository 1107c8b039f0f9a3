#pragma once
/// \file
/// What a plan's `keep` asks for: instances/CASE.graphml and .instance, solutions/CASE.PLANNER.csv, where
/// CASE is a case's id ("small_benchmark/tree/0").

#include "framework/campaign/BenchmarkPlan.h"
#include "framework/campaign/Executor.h"

#include <filesystem>
#include <set>
#include <string>

namespace mrpp
{

class KeptFiles
{
public:
    /// \param plan must outlive this
    KeptFiles(const BenchmarkPlan &plan, std::filesystem::path folder)
        : plan_(plan), folder_(std::move(folder))
    {}

    /// Writes the files of a finished run. One call at a time. Throws FileError.
    /// \pre the folder is this campaign's alone (the result store is open)
    void write(const RunSpec &spec, const RunResult &result);

private:
    /// Files that a killed campaign had not finished when it died.
    void removeLeftovers() const;

    const BenchmarkPlan &plan_;
    std::filesystem::path folder_;
    bool clean_ = false;
    std::set<std::string> cases_; ///< whose instance is written
};

/// The name with every character that file systems or shells could mind replaced; distinct names stay
/// distinct, as a changed one ends with its fingerprint.
[[nodiscard]] std::string fileSafe(const std::string &name);

} // namespace mrpp
