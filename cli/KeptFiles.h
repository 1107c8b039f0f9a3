#pragma once
/// \file
/// What a plan's `keep` asks for: instances/CASE.graphml and .instance, solutions/CASE.PLANNER.csv, where
/// CASE is a case's id ("small_benchmark/tree/0").
///
/// Files are written when a run finishes, as the store takes no solution above 4 MiB; at the end they are
/// made to follow the plan's names (a renamed planner, an edited list of problems), from the store.
/// `kept-files.csv` says which of the files are whose.

#include "framework/plan/BenchmarkPlan.h"
#include "framework/run/Executor.h"
#include "framework/store/ResultStore.h"
#include "framework/store/ResultTable.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mrpp
{

/// Files of the folder that were written here: their paths in it, and what they hold: a run's key, or an
/// instance's fingerprint.
class KeptList
{
public:
    explicit KeptList(const std::filesystem::path &folder);

    [[nodiscard]] bool exists() const { return exists_; }
    [[nodiscard]] std::map<std::string, std::string> &entries() { return entries_; }

    /// Writes the list as it is now. Throws FileError.
    void save();
    /// Notes one more at once, as this process may be killed. Throws FileError. \pre the list was saved
    void add(const std::string &path, const std::string &key);

private:
    std::filesystem::path file_;
    bool exists_;
    std::map<std::string, std::string> entries_;
};

class KeptFiles
{
public:
    /// \param plan must outlive this
    KeptFiles(const BenchmarkPlan &plan, std::filesystem::path folder);

    /// Writes the files of a finished run. One call at a time. Throws FileError.
    /// \pre the folder is this campaign's alone (the result store is open)
    void write(const RunSpec &spec, const RunResult &result);

    /// Every finished run of the plan has its files, under the plan's names; what was written here for other
    /// names and can be written again is gone. Throws FileError, also where another process has the folder.
    void followNames();

private:
    /// What a file has to hold, and the record that leads to it.
    struct Wanted
    {
        std::string key;
        const RunRecord *record = nullptr;
    };

    [[nodiscard]] bool keepsAnything() const { return plan_.keep.instances || plan_.keep.solutions; }
    void prepare();
    void removeLeftovers() const;
    void adopt(const std::vector<RunRecord> &records);
    [[nodiscard]] std::map<std::string, Wanted> wanted(const ResultTable &results) const;
    void moveUnstored(const std::map<std::string, Wanted> &wanted, const ResultStore &store);
    void writeMissing(const std::map<std::string, Wanted> &wanted, const ResultTable &results);
    void removeStale(const std::map<std::string, Wanted> &wanted, const ResultStore &store);
    [[nodiscard]] bool holds(const std::string &path, const std::string &key);

    const BenchmarkPlan &plan_;
    std::filesystem::path folder_;
    std::optional<KeptList> list_;
    std::set<std::string> cases_; ///< whose instance is written
};

/// The name with every character that file systems or shells could mind replaced; distinct names stay
/// distinct, as a changed one ends with its fingerprint.
[[nodiscard]] std::string fileSafe(const std::string &name);

} // namespace mrpp
