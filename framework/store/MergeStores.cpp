#include "framework/store/MergeStores.h"

#include "framework/run/Answer.h"
#include "framework/store/ResultSchema.h"
#include "framework/support/Error.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace mrpp
{

namespace
{

using Ids = std::map<std::int64_t, std::int64_t>; // of rows, there and here

struct Column
{
    std::string name;
    std::string type;
};

std::vector<Column> columnsOf(sqlite::Connection &database, const std::string &table)
{
    std::vector<Column> columns;
    sqlite::Statement query(database, "SELECT name, type FROM pragma_table_info(?)");
    query.bind(1, table);
    while (query.step())
        columns.push_back({query.text(0), query.text(1)});
    return columns;
}

std::vector<std::string> tablesOf(sqlite::Connection &database)
{
    std::vector<std::string> names;
    sqlite::Statement query(
        database, "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'");
    while (query.step())
        names.push_back(query.text(0));
    return names;
}

/// Column names do not tell small letters from capitals.
bool sameName(const std::string &a, const std::string &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Gives the table, which may be missing as a whole, every column that it has there.
void adoptColumns(sqlite::Connection &out, sqlite::Connection &from, const std::string &table)
{
    if (!out.hasTable(table))
    {
        sqlite::Statement definition(from, "SELECT sql FROM sqlite_master WHERE type = 'table' AND name = ?");
        if (definition.bind(1, table).step())
            out.run(definition.text(0));
        return;
    }
    const std::vector<Column> known = columnsOf(out, table);
    for (const Column &column : columnsOf(from, table))
        if (std::none_of(known.begin(), known.end(),
                         [&column](const Column &other) { return sameName(other.name, column.name); }))
            out.run("ALTER TABLE " + sqlite::quoted(table) + " ADD COLUMN " + sqlite::quoted(column.name) +
                    " " + column.type);
}

/// Copies rows of one table as they are, but for ids that are others here.
class RowCopier
{
public:
    RowCopier(sqlite::Connection &out, const sqlite::Statement &rows, const std::string &table)
        : out_(out), statement_(out, insertion(rows, table))
    {}

    /// \param ids by the number of their column; nothing leaves the cell empty
    /// \return the id of the new row
    std::int64_t copy(const sqlite::Statement &row, const std::map<int, Value> &ids)
    {
        for (int i = 0; i < row.columnCount(); ++i)
            if (const auto id = ids.find(i); id != ids.end())
                statement_.bind(i + 1, id->second);
            else
                statement_.bind(i + 1, row, i);
        statement_.execute();
        return out_.lastRowId();
    }

private:
    static std::string insertion(const sqlite::Statement &rows, const std::string &table)
    {
        std::string names;
        std::string marks;
        for (int i = 0; i < rows.columnCount(); ++i)
        {
            names += (i == 0 ? "" : ", ") + sqlite::quoted(rows.columnName(i));
            marks += i == 0 ? "?" : ", ?";
        }
        return "INSERT INTO " + sqlite::quoted(table) + " (" + names + ") VALUES (" + marks + ")";
    }

    sqlite::Connection &out_;
    sqlite::Statement statement_;
};

/// The number of a column, or −1.
int indexOf(const sqlite::Statement &rows, const std::string &name)
{
    for (int i = 0; i < rows.columnCount(); ++i)
        if (rows.columnName(i) == name)
            return i;
    return -1;
}

/// Rows that have an id of their own, and are the same where these columns are: copied once.
Ids takeNamed(sqlite::Connection &out, sqlite::Connection &from, const std::string &table,
              const std::vector<std::string> &identity)
{
    adoptColumns(out, from, table);
    std::string condition;
    for (const std::string &column : identity)
        condition += (condition.empty() ? "" : " AND ") + column + " IS ?";
    sqlite::Statement find(out, "SELECT id FROM " + table + " WHERE " + condition);
    sqlite::Statement rows(from, "SELECT * FROM " + table);
    RowCopier copier(out, rows, table);
    const int idColumn = indexOf(rows, "id");
    Ids ids;
    while (rows.step())
    {
        for (std::size_t i = 0; i < identity.size(); ++i)
            find.bind(static_cast<int>(i) + 1, rows, indexOf(rows, identity[i]));
        ids[rows.integer(idColumn)] =
            find.step() ? find.integer(0) : copier.copy(rows, {{idColumn, Value()}});
        find.reset();
    }
    return ids;
}

std::string spoken(const Value &value)
{
    const std::string text = toText(value);
    return text.empty() ? "nothing" : text;
}

} // namespace

/// A store whose runs are being taken.
class StoreMerger::Source
{
public:
    explicit Source(const std::filesystem::path &from)
        : folder(from), database(existing(from / "results.sqlite"), sqlite::Connection::Mode::read)
    {
        openResultSchema(database, folder / "results.sqlite", false);
        database.run("BEGIN"); // one moment of a store that may be growing
    }

    std::filesystem::path folder;
    sqlite::Connection database;
    Ids runs;                    ///< that are new
    std::set<std::string> taken; ///< their keys

private:
    static std::filesystem::path existing(std::filesystem::path file)
    {
        std::error_code error;
        if (!std::filesystem::exists(file, error))
            throw FileError({file.parent_path().string()}, "holds no campaign (there is no results.sqlite)");
        return file;
    }
};

StoreMerger::StoreMerger(sqlite::Connection &out, const std::filesystem::path &folder) : out_(out)
{
    sqlite::Statement own(out, "SELECT run_key FROM runs");
    while (own.step())
        origins_.emplace(own.text(0), folder);
}

bool StoreMerger::isThere(const Source &source, const sqlite::Statement &run)
{
    const std::string key = run.text(indexOf(run, "run_key"));
    const auto known = origins_.find(key);
    if (known == origins_.end())
        return false;
    sqlite::Statement own(out_, "SELECT * FROM runs WHERE run_key = ?");
    own.bind(1, key).step();
    const RunRecord there = recordOf(run);
    const RunRecord here = recordOf(own);
    if (endedByLimit(there) || endedByLimit(here))
        return true;
    const auto different = answerDifferences(there, here);
    if (different.empty())
        return true;
    const RunColumn *column = findRunColumn(different.front());
    throw InputError({source.folder.string()},
                     "run " + key + " (" + there.planner + " on " + there.caseId + ") has the " +
                         std::string(column->name) + " " + spoken(column->get(there)) + ", but " +
                         spoken(column->get(here)) + " in " + known->second.string() +
                         "; one question has one answer: leave out the folder that is wrong");
}

StoreMerger::Counts StoreMerger::takeRuns(Source &source)
{
    const Ids experiments = takeNamed(out_, source.database, "experiments",
                                      {"name", "timelimit", "memorylimit", "seed", "setup"});
    const Ids planners = takeNamed(out_, source.database, "plannerConfigs", {"name", "settings"});
    adoptColumns(out_, source.database, "runs");

    const auto idIn = [](const Ids &ids, std::int64_t id)
    {
        const auto found = ids.find(id);
        return found == ids.end() ? Value() : Value(found->second);
    };
    Counts counts;
    sqlite::Statement rows(source.database, "SELECT * FROM runs ORDER BY id");
    RowCopier copier(out_, rows, "runs");
    const int id = indexOf(rows, "id");
    const int key = indexOf(rows, "run_key");
    const int experiment = indexOf(rows, "experimentid");
    const int planner = indexOf(rows, "plannerid");
    while (rows.step())
    {
        if (isThere(source, rows))
        {
            ++counts.twice;
            continue;
        }
        source.runs[rows.integer(id)] =
            copier.copy(rows, {{id, Value()},
                               {experiment, idIn(experiments, rows.integer(experiment))},
                               {planner, idIn(planners, rows.integer(planner))}});
        source.taken.insert(rows.text(key));
        origins_.emplace(rows.text(key), source.folder);
        ++counts.taken;
    }
    return counts;
}

void StoreMerger::takeAttempts(Source &source)
{
    sqlite::Statement rows(source.database, "SELECT run_key, count FROM attempts");
    sqlite::Statement insert(out_,
                             "INSERT INTO attempts (run_key, count) VALUES (?, ?) ON CONFLICT (run_key) "
                             "DO UPDATE SET count = max(count, excluded.count)");
    while (rows.step())
        insert.bind(1, rows, 0).bind(2, rows, 1).execute();
}

void StoreMerger::takeRest(Source &source, const std::string &table)
{
    adoptColumns(out_, source.database, table);
    sqlite::Statement rows(source.database, "SELECT * FROM " + sqlite::quoted(table));
    const int run = indexOf(rows, "runid");
    const int key = indexOf(rows, "run_key");
    if (run < 0 && key < 0)
        return;
    RowCopier copier(out_, rows, table);
    while (rows.step())
    {
        const auto isNew = run >= 0 ? source.runs.find(rows.integer(run)) : source.runs.end();
        if (isNew != source.runs.end())
            copier.copy(rows, {{run, Value(isNew->second)}});
        else if (run < 0 && source.taken.contains(rows.text(key)))
            copier.copy(rows, {});
    }
}

StoreMerger::Counts StoreMerger::take(const std::filesystem::path &folder)
{
    Source source(folder);
    const Counts counts = takeRuns(source);
    takeAttempts(source);
    const std::set<std::string> others = {"experiments", "plannerConfigs", "enums",
                                          "meta",        "runs",           "attempts"};
    for (const std::string &table : tablesOf(source.database))
        if (!others.contains(table))
            takeRest(source, table);
    out_.run("UPDATE experiments SET totaltime = "
             "(SELECT total(time) FROM runs WHERE experimentid = experiments.id)");
    return counts;
}

} // namespace mrpp
