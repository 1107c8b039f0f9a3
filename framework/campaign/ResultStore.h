#pragma once
/// \file
/// Where finished runs are kept: one SQLite file, durable run by run, in a schema that OMPL's Planner Arena
/// opens (tables experiments, plannerConfigs, enums, runs, progress).

#include "framework/campaign/BenchmarkPlan.h"
#include "framework/campaign/RunRecord.h"
#include "framework/model/Solution.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mrpp
{

class ResultStore
{
public:
    enum class Access
    {
        read,  ///< also while another process writes
        write, ///< one process at a time: FileError where another holds the folder
    };

    /// Opens DIR/results.sqlite; with `write` makes it where missing. Throws FileError where it cannot be
    /// opened, is no store, or is of a newer version.
    ResultStore(const std::filesystem::path &folder, Access access);
    ~ResultStore();
    ResultStore(const ResultStore &) = delete;
    ResultStore &operator=(const ResultStore &) = delete;

    /// Keys of the finished runs.
    [[nodiscard]] std::set<std::string> finishedKeys() const;

    /// Notes that a run begins; returns how often it began, this time included.
    std::int64_t begin(const std::string &runKey);

    /// Keeps a finished run (and its solution, packed, where that is small enough). On return it is on disk.
    void add(const RunRecord &record, const Solution &solution);

    /// All finished runs, in the order in which they were kept.
    [[nodiscard]] std::vector<RunRecord> records() const;

    /// A run's solution, where it was kept.
    [[nodiscard]] std::optional<Solution> solution(const std::string &runKey) const;

private:
    struct Database;
    std::unique_ptr<Database> database_;
};

} // namespace mrpp
