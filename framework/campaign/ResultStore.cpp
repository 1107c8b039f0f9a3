#include "framework/campaign/ResultStore.h"

#include "framework/campaign/FolderLock.h"
#include "framework/campaign/ResultSchema.h"
#include "framework/campaign/SolutionCodec.h"
#include "framework/campaign/Sqlite.h"
#include "framework/support/Error.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace mrpp
{

namespace
{

constexpr std::size_t kLargestSolution = std::size_t{4} << 20; // bytes, packed

std::filesystem::path fileOf(const std::filesystem::path &folder)
{
    return folder / "results.sqlite";
}

std::filesystem::path madeFolder(const std::filesystem::path &folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw FileError({folder.string()},
                        "cannot be made: " + (error ? error.message() : std::string("it is a file")));
    return folder;
}

/// Column names of a database do not tell small letters from capitals.
std::string folded(std::string name)
{
    for (char &c : name)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

std::string extraType(const Value &value)
{
    return sqlType(std::holds_alternative<std::int64_t>(value) ? RunColumn::Type::integer
                   : std::holds_alternative<double>(value)     ? RunColumn::Type::real
                                                               : RunColumn::Type::text);
}

/// The problem at one sweep point: the case without its repetition.
std::string experimentName(const RunRecord &record)
{
    return record.caseId.substr(0, record.caseId.rfind('/'));
}

} // namespace

class ResultStore::Database
{
public:
    Database(const std::filesystem::path &folder, Access access)
        : lock_(access == Access::write ? std::make_unique<FolderLock>(madeFolder(folder)) : nullptr),
          file(existing(fileOf(folder), access)),
          connection(file, access == Access::write ? sqlite::Connection::Mode::write
                                                   : sqlite::Connection::Mode::read)
    {
        openResultSchema(connection, file, access == Access::write);
        if (access == Access::write)
        {
            connection.run("PRAGMA journal_mode = WAL");
            connection.run("PRAGMA foreign_keys = ON");
            connection.run(kEveryCommit);
        }
        sqlite::Statement columns(connection, "SELECT name FROM pragma_table_info('runs')");
        while (columns.step())
            columns_.emplace(folded(columns.text(0)), columns.text(0));
        if (access == Access::write)
            addMissingColumns();
    }

    ~Database()
    {
        if (lock_)
            connection.foldLog();
    }
    Database(const Database &) = delete;
    Database &operator=(const Database &) = delete;

    void addColumns(const std::map<std::string, Value> &extra)
    {
        for (const auto &[name, value] : extra)
        {
            if (std::holds_alternative<std::monostate>(value))
                continue;
            const auto known = columns_.find(folded(name));
            const bool isOwn = findRunColumn(folded(name)) != nullptr || isKeyColumn(folded(name));
            if (name.empty() || isOwn || (known != columns_.end() && known->second != name))
                throw InputError("an event adds a column '" + name +
                                 "', but such a name is taken; choose another");
            if (known != columns_.end())
                continue;
            connection.run("ALTER TABLE runs ADD COLUMN " + sqlite::quoted(name) + " " + extraType(value));
            newColumns_.push_back(folded(name));
            columns_.emplace(folded(name), name);
        }
    }

    /// After a commit the new columns are there to stay; after a failure they are not.
    void settleColumns(bool kept)
    {
        if (!kept)
            for (const std::string &name : newColumns_)
                columns_.erase(name);
        newColumns_.clear();
    }

    std::int64_t experiment(const RunRecord &record)
    {
        const std::string name = experimentName(record);
        sqlite::Statement find(connection, "SELECT id FROM experiments WHERE name = ? AND timelimit IS ? AND "
                                           "memorylimit IS ? AND seed IS ? AND setup IS ?");
        find.bind(1, name).bind(2, timeLimit).bind(3, memoryLimit).bind(4, seed).bind(5, planText);
        if (find.step())
            return find.integer(0);
        sqlite::Statement insert(connection, "INSERT INTO experiments VALUES "
                                             "(NULL, ?, 0, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        int parameter = 0;
        for (const Value &value : std::initializer_list<Value>{
                 name, timeLimit, memoryLimit, repetitions, provenance.version, provenance.host,
                 provenance.cpu, provenance.started, seed, planText, record.model, record.problem,
                 record.sweepVariable, record.sweepValue ? Value(*record.sweepValue) : Value()})
            insert.bind(++parameter, value);
        insert.execute();
        return connection.lastRowId();
    }

    std::int64_t planner(const std::string &name)
    {
        const std::string &settings = plannerSettings[name];
        sqlite::Statement find(connection, "SELECT id FROM plannerConfigs WHERE name = ? AND settings = ?");
        if (find.bind(1, name).bind(2, settings).step())
            return find.integer(0);
        sqlite::Statement insert(connection, "INSERT INTO plannerConfigs VALUES (NULL, ?, ?)");
        insert.bind(1, name).bind(2, settings).execute();
        return connection.lastRowId();
    }

    void insert(const RunRecord &record, std::int64_t experimentId, std::int64_t plannerId)
    {
        std::string names = "experimentid, plannerid, solved";
        std::vector<Value> values = {experimentId, plannerId, std::int64_t{record.solved() ? 1 : 0}};
        for (const RunColumn &column : runColumns())
        {
            names += ", " + sqlite::quoted(column.name);
            values.push_back(column.name == "status" ? Value(static_cast<std::int64_t>(record.status))
                                                     : column.get(record));
        }
        for (const auto &[name, value] : record.extra)
        {
            if (std::holds_alternative<std::monostate>(value))
                continue;
            names += ", " + sqlite::quoted(name);
            values.push_back(value);
        }
        std::string marks = "?";
        for (std::size_t i = 1; i < values.size(); ++i)
            marks += ", ?";
        sqlite::Statement statement(connection, "INSERT INTO runs (" + names + ") VALUES (" + marks + ")");
        for (std::size_t i = 0; i < values.size(); ++i)
            statement.bind(static_cast<int>(i) + 1, values[i]);
        statement.execute();
    }

    /// Samples of the run in the row `runId` of `runs`; a new property becomes a new column.
    void insert(const Progress &progress, std::int64_t runId)
    {
        if (progress.samples.empty())
            return;
        std::string names = "runid, time";
        std::string marks = "?, ?";
        for (const std::string &name : progress.names)
        {
            sqlite::Statement known(connection, "SELECT 1 FROM pragma_table_info('progress') WHERE name = ? "
                                                "COLLATE NOCASE");
            if (!known.bind(1, Value(name)).step())
                connection.run("ALTER TABLE progress ADD COLUMN " + sqlite::quoted(name) + " REAL");
            names += ", " + sqlite::quoted(name);
            marks += ", ?";
        }
        // Planner Arena knows a sample by its time: of two at one moment the later one counts.
        const std::string sql = "INSERT OR REPLACE INTO progress (" + names + ") VALUES (" + marks + ")";
        for (const Progress::Sample &sample : progress.samples)
        {
            sqlite::Statement statement(connection, sql);
            statement.bind(1, Value(runId)).bind(2, Value(sample.time));
            for (std::size_t i = 0; i < sample.values.size(); ++i)
                statement.bind(static_cast<int>(i) + 3, Value(sample.values[i]));
            statement.execute();
        }
    }

    static constexpr const char *kEveryCommit = "PRAGMA synchronous = FULL";   // is on the disk
    static constexpr const char *kSomeCommits = "PRAGMA synchronous = NORMAL"; // with the next that is

private:
    /// Those that the version that made the store did not know.
    void addMissingColumns()
    {
        for (const RunColumn &column : runColumns())
            if (columns_.emplace(column.name, column.name).second)
                connection.run("ALTER TABLE runs ADD COLUMN " + sqlite::quoted(column.name) + " " +
                               sqlType(column.type));
    }

    static std::filesystem::path existing(std::filesystem::path file, Access access)
    {
        std::error_code error;
        if (access == Access::read && !std::filesystem::exists(file, error))
            throw FileError({file.parent_path().string()}, "holds no campaign (there is no results.sqlite)");
        return file;
    }

    std::unique_ptr<FolderLock> lock_;           // outlives the connection
    std::map<std::string, std::string> columns_; // of `runs`, by folded name
    std::vector<std::string> newColumns_;        // of the transaction that is open

public:
    const std::filesystem::path file;
    sqlite::Connection connection;

    // Of the campaign, see describe().
    Provenance provenance;
    Value timeLimit;
    Value memoryLimit;
    Value repetitions;
    std::string seed;
    std::string planText;
    std::map<std::string, std::string> plannerSettings;
};

ResultStore::ResultStore(const std::filesystem::path &folder, Access access)
    : database_(std::make_unique<Database>(folder, access))
{}

ResultStore::~ResultStore() = default;

void ResultStore::describe(const BenchmarkPlan &plan, const Provenance &provenance)
{
    database_->provenance = provenance;
    database_->timeLimit = plan.limits.time;
    database_->memoryLimit = plan.limits.memory;
    database_->repetitions = plan.repetitions;
    database_->seed = std::to_string(plan.seed);
    database_->planText = plan.text;
    for (const Configured &planner : plan.planners)
    {
        std::string settings = "planner = " + planner.kind + ";";
        for (const auto &[name, value] : planner.settings)
            settings.append(name).append(" = ").append(value).append(";");
        database_->plannerSettings[planner.name] = settings;
    }
}

std::set<std::string> ResultStore::finishedKeys() const
{
    std::set<std::string> keys;
    sqlite::Statement query(database_->connection, "SELECT run_key FROM runs");
    while (query.step())
        keys.insert(query.text(0));
    return keys;
}

std::int64_t ResultStore::begin(const std::string &runKey)
{
    sqlite::Connection &connection = database_->connection;
    connection.run(Database::kSomeCommits);
    sqlite::Statement count(connection,
                            "INSERT INTO attempts VALUES (?, 1) "
                            "ON CONFLICT (run_key) DO UPDATE SET count = count + 1 RETURNING count");
    count.bind(1, runKey).step();
    const std::int64_t attempts = count.integer(0);
    count.execute();
    connection.run(Database::kEveryCommit);
    return attempts;
}

void ResultStore::add(const RunRecord &record, const Solution &solution, const Progress &progress)
{
    sqlite::Connection &connection = database_->connection;
    const std::vector<std::uint8_t> packed = packSolution(solution);
    try
    {
        sqlite::Transaction transaction(connection);
        sqlite::Statement known(connection, "SELECT 1 FROM runs WHERE run_key = ?");
        if (known.bind(1, record.runKey).step())
            return;
        database_->addColumns(record.extra);
        const std::int64_t experiment = database_->experiment(record);
        database_->insert(record, experiment, database_->planner(record.planner));
        database_->insert(progress, connection.lastRowId());
        sqlite::Statement total(connection, "UPDATE experiments SET totaltime = totaltime + ? WHERE id = ?");
        total.bind(1, record.time.value_or(0)).bind(2, experiment).execute();
        if (!record.solutionFingerprint.empty() && packed.size() <= kLargestSolution)
            sqlite::Statement(connection, "INSERT OR REPLACE INTO solutions VALUES (?, ?)")
                .bind(1, record.runKey)
                .bind(2, packed)
                .execute();
        transaction.commit();
        database_->settleColumns(true);
    }
    catch (...)
    {
        database_->settleColumns(false);
        throw;
    }
}

std::vector<RunRecord> ResultStore::records() const
{
    sqlite::Statement query(database_->connection, "SELECT * FROM runs ORDER BY id");
    std::vector<RunRecord> records;
    while (query.step())
        records.push_back(recordOf(query));
    return records;
}

std::optional<std::string> ResultStore::planText(const std::string &runKey) const
{
    sqlite::Statement query(database_->connection, "SELECT setup FROM experiments JOIN runs "
                                                   "ON experiments.id = experimentid WHERE run_key = ?");
    return query.bind(1, runKey).step() ? std::optional(query.text(0)) : std::nullopt;
}

std::optional<Solution> ResultStore::solution(const std::string &runKey) const
{
    sqlite::Statement query(database_->connection, "SELECT moves FROM solutions WHERE run_key = ?");
    if (!query.bind(1, runKey).step())
        return std::nullopt;
    auto solution = unpackSolution(query.bytes(0));
    if (!solution)
        throw FileError({database_->file.string()}, "the solution of run " + runKey + " is damaged");
    return solution;
}

Progress ResultStore::progress(const std::string &runKey) const
{
    sqlite::Statement query(database_->connection,
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

} // namespace mrpp
