#include "framework/store/ResultSchema.h"

#include "framework/PlannerStatus.h"
#include "framework/run/ReadableRecord.h"
#include "framework/support/Error.h"

namespace mrpp
{

namespace
{

constexpr std::int64_t kVersion = 1;

/// Names, types and their order are Planner Arena's: it takes the columns of `runs` behind the two foreign
/// keys as measures, those of `experiments` behind the twelfth as filters, and needs `time` and `solved`.
constexpr const char *kArenaTables = R"sql(
CREATE TABLE experiments (
    id INTEGER PRIMARY KEY, name VARCHAR(512), totaltime REAL, timelimit REAL, memorylimit REAL,
    runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024), cpuinfo TEXT, date DATETIME,
    seed VARCHAR(24), setup TEXT, model VARCHAR(512), problem VARCHAR(512), sweep_variable VARCHAR(512),
    sweep_value REAL);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name VARCHAR(512) NOT NULL, settings TEXT);
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY (name, value));
CREATE TABLE progress (
    runid INTEGER REFERENCES runs (id) ON DELETE CASCADE, time REAL, PRIMARY KEY (runid, time));
)sql";

/// The best settings of each planner: most often solved, then fastest. (OMPL's own views take the least often
/// solved.)
constexpr const char *kArenaViews = R"sql(
CREATE VIEW bestPlannerConfigsPerExperiment AS
    SELECT plannerid, experimentid, avg_solved, avg_total_time FROM (
        SELECT *, row_number() OVER (PARTITION BY name, experimentid
                                     ORDER BY avg_solved DESC, avg_total_time) AS place FROM (
            SELECT plannerid, experimentid, plannerConfigs.name AS name, avg(solved) AS avg_solved,
                   avg(time) AS avg_total_time
            FROM runs JOIN plannerConfigs ON plannerConfigs.id = plannerid
            GROUP BY plannerid, experimentid))
    WHERE place = 1 ORDER BY avg_solved DESC, avg_total_time;
CREATE VIEW bestPlannerConfigs AS
    SELECT plannerid, avg_solved, avg_total_time FROM (
        SELECT *, row_number() OVER (PARTITION BY name ORDER BY avg_solved DESC, avg_total_time) AS place FROM (
            SELECT plannerid, plannerConfigs.name AS name, avg(solved) AS avg_solved,
                   avg(time) AS avg_total_time
            FROM runs JOIN plannerConfigs ON plannerConfigs.id = plannerid
            GROUP BY plannerid))
    WHERE place = 1 ORDER BY avg_solved DESC, avg_total_time;
)sql";

constexpr const char *kOwnTables = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY, value);
CREATE TABLE attempts (run_key TEXT PRIMARY KEY, count INTEGER NOT NULL);
CREATE TABLE solutions (run_key TEXT PRIMARY KEY, moves BLOB NOT NULL);
)sql";

/// Since version 1 was made: what the rows of two tables stand for, see RunKey.h.
void addQuestions(sqlite::Connection &database)
{
    for (const char *table : {"experiments", "plannerConfigs"})
        if (!database.hasColumn(table, "question"))
            database.run(std::string("ALTER TABLE ") + table + " ADD COLUMN question TEXT");
}

std::string runsTable()
{
    std::string sql =
        "CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER REFERENCES experiments "
        "(id) ON DELETE CASCADE, plannerid INTEGER REFERENCES plannerConfigs (id) ON DELETE "
        "CASCADE";
    for (const RunColumn &column : runColumns())
        sql += ", " + sqlite::quoted(column.name) + " " +
               (column.name == "status" ? "ENUM" : sqlType(column.type)) +
               (column.name == "run_key" ? " NOT NULL UNIQUE" : "");
    return sql + ", solved BOOLEAN);";
}

void create(sqlite::Connection &database)
{
    sqlite::Transaction transaction(database);
    database.run(kArenaTables);
    database.run(runsTable());
    database.run(kArenaViews);
    database.run(kOwnTables);
    addQuestions(database);

    sqlite::Statement meaning(database, "INSERT INTO enums VALUES ('status', ?, ?)");
    constexpr int kBeyondAll = 64;
    for (int value = 0; value < kBeyondAll; ++value)
    {
        const auto status = static_cast<PlannerStatus>(value);
        if (plannerStatus(toString(status)) == status)
            meaning.bind(1, std::int64_t{value}).bind(2, std::string(toString(status))).execute();
    }
    sqlite::Statement version(database, "INSERT INTO meta VALUES ('schema', ?)");
    version.bind(1, kVersion).execute();
    transaction.commit();
}

bool isEmpty(sqlite::Connection &database)
{
    return !sqlite::Statement(database, "SELECT 1 FROM sqlite_master").step();
}

} // namespace

void openResultSchema(sqlite::Connection &database, const std::filesystem::path &file, bool mayCreate)
{
    if (mayCreate && isEmpty(database))
        return create(database);
    if (!database.hasTable("meta") || !database.hasTable("runs"))
        throw FileError({file.string()}, "is a database, but no store of results; use another folder");
    sqlite::Statement query(database, "SELECT value FROM meta WHERE key = 'schema'");
    const std::int64_t version = query.step() ? query.integer(0) : 0;
    if (version > kVersion)
        throw FileError({file.string()}, "was written by a newer version of this program (schema " +
                                             std::to_string(version) + ", known here up to " +
                                             std::to_string(kVersion) + "); use that version");
    if (version < 1)
        throw FileError({file.string()}, "does not say which version of the store it is; use another folder");
    if (mayCreate)
        addQuestions(database);
}

RunRows::RunRows(const sqlite::Statement &rows)
{
    for (int i = 0; i < rows.columnCount(); ++i)
    {
        std::string name = rows.columnName(i);
        if (name == "status")
            status_ = i;
        else if (!isKeyColumn(name))
            cells_.push_back({std::move(name), findRunColumn(rows.columnName(i)), i});
    }
}

RunRecord RunRows::record(const sqlite::Statement &row) const
{
    RunRecord record;
    record.status = static_cast<PlannerStatus>(row.integer(status_));
    for (const Cell &cell : cells_)
    {
        Value value = row.column(cell.index);
        if (std::holds_alternative<std::monostate>(value))
            continue;
        if (cell.column != nullptr)
            cell.column->set(record, std::move(value));
        else
            record.extra[cell.name] = std::move(value);
    }
    makeReadable(record); // older versions kept bytes as they came
    return record;
}

RunRecord recordOf(const sqlite::Statement &row)
{
    return RunRows(row).record(row);
}

bool isKeyColumn(const std::string &name)
{
    return name == "id" || name == "experimentid" || name == "plannerid" || name == "solved";
}

std::string sqlType(RunColumn::Type type)
{
    switch (type)
    {
    case RunColumn::Type::integer:
        return "INTEGER";
    case RunColumn::Type::real:
        return "REAL";
    case RunColumn::Type::text:
        break;
    }
    return "VARCHAR(1024)";
}

} // namespace mrpp
