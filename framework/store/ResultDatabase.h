#pragma once
/// \file
/// The inside of ResultStore: the database's tables as one object. Only the store uses it.

#include "framework/plan/RunKey.h"
#include "framework/store/ResultStore.h"
#include "framework/store/Sqlite.h"

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace mrpp
{

class ResultDatabase
{
public:
    /// Opens the file; with `mayWrite` makes what is missing of it. Throws FileError.
    ResultDatabase(const std::filesystem::path &file, bool mayWrite, const FileSystemAbilities &abilities);

    [[nodiscard]] sqlite::Connection &connection() { return connection_; }
    [[nodiscard]] const std::filesystem::path &file() const { return file_; }

    /// What the runs to come belong to.
    void describe(const BenchmarkPlan &plan, const Provenance &provenance);

    /// Adds a finished run, unless it is there already, inside the transaction that is open.
    void add(const FinishedRun &run);

    /// Ends the batch of the open transaction: to be called before its commit.
    void endBatch();

    /// After the commit what add() made is there to stay; after a failure it is not.
    void settle(bool kept);

private:
    void addMissingColumns();
    void addColumns(const std::map<std::string, Value> &extra);
    [[nodiscard]] std::int64_t experiment(const RunRecord &record);
    [[nodiscard]] std::int64_t planner(const std::string &name);
    void insert(const RunRecord &record, std::int64_t experimentId, std::int64_t plannerId);
    void insert(const Progress &progress, std::int64_t runId);
    void insert(const std::string &runKey, const Solution &solution);

    /// The statement, prepared once.
    sqlite::Statement &prepared(const std::string &sql);

    std::filesystem::path file_;
    sqlite::Connection connection_;
    std::unordered_map<std::string, std::unique_ptr<sqlite::Statement>>
        statements_;                             // outlived by connection_
    std::map<std::string, std::string> columns_; // of `runs`, by folded name
    std::vector<std::string> newColumns_;        // of the transaction that is open

    // Of the campaign, see describe().
    Provenance provenance_;
    Value timeLimit_;
    Value memoryLimit_;
    Value repetitions_;
    std::string seed_;
    std::string planText_;
    std::unordered_map<std::string, std::string> questions_; // by the experiment's name, see RunKey.h
    std::map<std::string, std::string> plannerSettings_;
    std::map<std::string, std::string> plannerQuestions_; // by name, as plannerSettings_

    // Rows that are known, and what the open transaction adds to them.
    std::unordered_map<std::string, std::int64_t> experiments_;
    std::unordered_map<std::string, std::int64_t> planners_;
    std::unordered_map<std::int64_t, double> spent_; // seconds, by experiment
};

} // namespace mrpp
