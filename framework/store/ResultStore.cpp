#include "framework/store/ResultStore.h"

#include "framework/store/BegunRuns.h"
#include "framework/store/FolderLock.h"
#include "framework/store/ResultDatabase.h"
#include "framework/store/ResultSchema.h"
#include "framework/store/SolutionCodec.h"
#include "framework/support/Error.h"
#include "framework/system/FileSystem.h"

#include <cmath>
#include <mutex>
#include <sys/stat.h>
#include <utility>

namespace mrpp
{

namespace
{

std::filesystem::path madeFolder(const std::filesystem::path &folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (std::error_code ignored; !std::filesystem::is_directory(folder, ignored))
        throw FileError({folder.string()},
                        "cannot be made: " + (error ? error.message() : std::string("it is a file")));
    return folder;
}

std::filesystem::path existing(const std::filesystem::path &folder)
{
    std::error_code error;
    if (!std::filesystem::exists(folder / "results.sqlite", error))
        throw FileError({folder.string()}, "holds no campaign (there is no results.sqlite)");
    return folder;
}

/// Device and number of a file; zeros where there is none.
std::pair<dev_t, ino_t> identityOf(const std::filesystem::path &file)
{
    struct stat status = {};
    return ::stat(file.c_str(), &status) == 0 ? std::pair(status.st_dev, status.st_ino)
                                              : std::pair(dev_t{0}, ino_t{0});
}

std::size_t countRuns(sqlite::Connection &connection)
{
    sqlite::Statement count(connection, "SELECT count(*) FROM runs");
    return count.step() ? static_cast<std::size_t>(count.integer(0)) : 0;
}

} // namespace

struct ResultStore::State
{
    State(const std::filesystem::path &folder, Access access)
        : lock(access == Access::write ? std::make_unique<FolderLock>(madeFolder(folder)) : nullptr),
          abilities(access == Access::write ? abilitiesOf(folder)
                                            : FileSystemAbilities{.locks = hasLocks(folder / ".lock")}),
          database((access == Access::read ? existing(folder) : folder) / "results.sqlite",
                   access == Access::write, abilities),
          begun(folder), identity(identityOf(database.file()))
    {
        if (access == Access::write)
            takeOverBegun();
    }

    ~State()
    {
        if (!lock)
            return;
        try
        {
            takeOverBegun();
        }
        catch (const FileError &)
        {
            // The notes stay in their file for the next time.
        }
        database.connection().foldLog();
    }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    /// Counts the noted runs that were not finished, and begins a new list.
    void takeOverBegun()
    {
        const std::vector<std::string> keys = begun.read();
        if (!keys.empty())
        {
            sqlite::Transaction transaction(database.connection());
            sqlite::Statement count(database.connection(),
                                    "INSERT INTO attempts SELECT ?1, 1 WHERE NOT EXISTS "
                                    "(SELECT 1 FROM runs WHERE run_key = ?1) "
                                    "ON CONFLICT (run_key) DO UPDATE SET count = count + 1");
            for (const std::string &key : keys)
                count.bind(1, key).execute();
            transaction.commit();
        }
        begun.forget();
        attempts.clear();
        sqlite::Statement query(database.connection(), "SELECT run_key, count FROM attempts");
        while (query.step())
            attempts.emplace(query.text(0), query.integer(1));
    }

    /// What is written into a file that is gone from its folder would be lost.
    void expectFolder() const
    {
        if (identityOf(database.file()) != identity)
            throw FileError(
                {database.file().parent_path().string()},
                "the folder was removed or replaced while the campaign ran; what had been written to "
                "it is gone with it");
    }

    std::unique_ptr<FolderLock> lock; // outlives the database
    FileSystemAbilities abilities;
    ResultDatabase database;
    BegunRuns begun;
    std::pair<dev_t, ino_t> identity;                       // of the database's file
    std::mutex beginning;                                   // guards what follows and `begun`
    std::unordered_map<std::string, std::int64_t> attempts; // of unfinished runs
};

ResultStore::ResultStore(const std::filesystem::path &folder, Access access)
    : state_(std::make_unique<State>(folder, access))
{}

ResultStore::~ResultStore() = default;

std::vector<std::string> ResultStore::notes() const
{
    std::vector<std::string> notes;
    const std::string folder = state_->database.file().parent_path().string();
    if (!state_->abilities.locks)
        notes.push_back(folder +
                        ": this file system has no locks: run one campaign in it at a time, and make "
                        "reports when it is over");
    else if (!state_->abilities.sharedMemory)
        notes.push_back(folder +
                        ": this file system has no shared memory: results are kept with a rollback "
                        "journal, which is slower, and reports wait for the campaign while it writes");
    return notes;
}

void ResultStore::describe(const BenchmarkPlan &plan, const Provenance &provenance)
{
    state_->database.describe(plan, provenance);
}

RunKeyMap<PlannerStatus> ResultStore::finishedRuns() const
{
    sqlite::Connection &connection = state_->database.connection();
    RunKeyMap<PlannerStatus> runs;
    runs.reserve(countRuns(connection));
    sqlite::Statement query(connection, "SELECT run_key, status FROM runs");
    while (query.step())
        runs.set(query.view(0), static_cast<PlannerStatus>(query.integer(1)));
    return runs;
}

std::set<std::string> ResultStore::finishedKeys(const std::string &beginning) const
{
    std::set<std::string> keys;
    sqlite::Statement query(state_->database.connection(),
                            "SELECT run_key FROM runs WHERE run_key BETWEEN ?1 AND ?1 || '~'");
    query.bind(1, beginning);
    while (query.step())
        keys.insert(query.text(0));
    return keys;
}

std::int64_t ResultStore::begin(const std::string &runKey)
{
    const std::lock_guard lock(state_->beginning);
    state_->begun.note(runKey);
    return ++state_->attempts[runKey];
}

void ResultStore::add(const RunRecord &record, const Solution &solution, const Progress &progress)
{
    const FinishedRun run{record, solution, progress};
    add({&run, 1});
}

void ResultStore::add(std::span<const FinishedRun> runs)
{
    ResultDatabase &database = state_->database;
    state_->expectFolder();
    try
    {
        sqlite::Transaction transaction(database.connection());
        for (const FinishedRun &run : runs)
            database.add(run);
        database.endBatch();
        transaction.commit();
        database.settle(true);
        const std::lock_guard lock(state_->beginning);
        for (const FinishedRun &run : runs)
            state_->attempts.erase(run.record.runKey);
    }
    catch (...)
    {
        database.settle(false);
        throw;
    }
}

std::vector<RunRecord> ResultStore::records() const
{
    sqlite::Connection &connection = state_->database.connection();
    sqlite::Statement query(connection, "SELECT * FROM runs ORDER BY id");
    const RunRows rows(query);
    std::vector<RunRecord> records;
    records.reserve(countRuns(connection));
    while (query.step())
        records.push_back(rows.record(query));
    return records;
}

std::optional<RunRecord> ResultStore::record(const std::string &runKey) const
{
    sqlite::Statement query(state_->database.connection(), "SELECT * FROM runs WHERE run_key = ?");
    return query.bind(1, runKey).step() ? std::optional(recordOf(query)) : std::nullopt;
}

std::optional<std::string> ResultStore::planText(const std::string &runKey) const
{
    sqlite::Statement query(state_->database.connection(), "SELECT setup FROM experiments JOIN runs "
                                                           "ON experiments.id = experimentid "
                                                           "WHERE run_key = ?");
    return query.bind(1, runKey).step() ? std::optional(query.text(0)) : std::nullopt;
}

std::optional<Solution> ResultStore::solution(const std::string &runKey) const
{
    sqlite::Statement query(state_->database.connection(), "SELECT moves FROM solutions WHERE run_key = ?");
    if (!query.bind(1, runKey).step())
        return std::nullopt;
    auto solution = unpackSolution(query.bytes(0));
    if (!solution)
        throw FileError({state_->database.file().string()}, "the solution of run " + runKey + " is damaged");
    return solution;
}

Progress ResultStore::progress(const std::string &runKey) const
{
    sqlite::Statement query(state_->database.connection(),
                            "SELECT progress.* FROM progress JOIN runs ON runs.id = progress.runid "
                            "WHERE runs.run_key = ? ORDER BY progress.time");
    query.bind(1, runKey);
    Progress progress;
    std::vector<int> columns;
    while (query.step())
    {
        Progress::Sample sample;
        if (progress.samples.empty())
            for (int i = 0; i < query.columnCount(); ++i)
                if (const std::string name = query.columnName(i);
                    name != "runid" && name != "time" && std::holds_alternative<double>(query.column(i)))
                {
                    columns.push_back(i);
                    progress.names.push_back(name);
                }
        for (int i = 0; i < query.columnCount(); ++i)
            if (query.columnName(i) == "time")
                sample.time = std::get<double>(query.column(i));
        for (const int i : columns)
        {
            const Value value = query.column(i);
            sample.values.push_back(std::holds_alternative<double>(value) ? std::get<double>(value)
                                                                          : std::nan(""));
        }
        progress.samples.push_back(std::move(sample));
    }
    return progress;
}

std::unordered_map<std::string, std::int64_t> ResultStore::unfinishedAttempts() const
{
    std::unordered_map<std::string, std::int64_t> attempts;
    sqlite::Statement query(state_->database.connection(), "SELECT run_key, count FROM attempts");
    while (query.step())
        attempts[query.text(0)] += query.integer(1);
    for (const std::string &key : state_->begun.read())
        ++attempts[key];
    std::erase_if(attempts,
                  [finished = finishedRuns()](const auto &entry) { return finished.contains(entry.first); });
    return attempts;
}

std::unordered_map<std::string, KeyParts> ResultStore::askedBefore() const
{
    sqlite::Connection &connection = state_->database.connection();
    const auto questions = [&connection](const char *table)
    {
        std::unordered_map<std::int64_t, KeyParts> parts;
        if (!connection.hasColumn(table, "question"))
            return parts;
        sqlite::Statement rows(connection, std::string("SELECT id, question FROM ") + table);
        while (rows.step())
            parts.emplace(rows.integer(0), keyParts(rows.text(1)));
        return parts;
    };
    auto experiments = questions("experiments");
    auto planners = questions("plannerConfigs");
    std::unordered_map<std::string, KeyParts> asked;
    sqlite::Statement query(connection,
                            "SELECT \"case\", planner, experimentid, plannerid FROM runs ORDER BY id");
    while (query.step())
    {
        KeyParts &parts = asked[question(query.text(0), query.text(1))];
        parts = experiments[query.integer(2)];
        const KeyParts &planner = planners[query.integer(3)];
        parts.insert(parts.end(), planner.begin(), planner.end());
    }
    return asked;
}

AskedParts ResultStore::askedParts() const
{
    sqlite::Connection &connection = state_->database.connection();
    const auto newest = [&connection](const std::string &table, const std::string &reference)
    {
        std::map<std::string, KeyParts> parts;
        if (!connection.hasColumn(table, "question"))
            return parts;
        std::string sql = "SELECT name, question FROM " + table;
        sql += " JOIN (SELECT " + reference + " AS used, max(id) AS last FROM runs GROUP BY " + reference;
        sql += ") ON used = id WHERE question IS NOT NULL ORDER BY last";
        sqlite::Statement rows(connection, sql);
        while (rows.step())
            parts[rows.text(0)] = keyParts(rows.text(1));
        return parts;
    };
    return {newest("experiments", "experimentid"), newest("plannerConfigs", "plannerid")};
}

std::string ResultStore::question(const std::string &caseId, const std::string &planner)
{
    return caseId + '\n' + planner;
}

} // namespace mrpp
