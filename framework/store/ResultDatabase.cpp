#include "framework/store/ResultDatabase.h"

#include "framework/store/ResultSchema.h"
#include "framework/store/SolutionCodec.h"
#include "framework/support/Error.h"

#include <cctype>

namespace mrpp
{

namespace
{

constexpr std::size_t kLargestSolution = std::size_t{4} << 20; // bytes, packed

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
std::string experimentName(const std::string &caseId)
{
    return caseId.substr(0, caseId.rfind('/'));
}

/// As Planner Arena shows them: "planner = walker;detours = 2;".
std::string settingsText(const Configured &planner, const FileHashes &files)
{
    std::string text = "planner = " + planner.kind + ";";
    for (const auto &[name, value] : planner.effective.empty() ? planner.settings : planner.effective)
        text.append(name == kVersionSetting ? "version" : name).append(" = ").append(value).append(";");
    for (const auto &[name, hash] : files)
        text.append("file ").append(name).append(" = ").append(hash).append(";");
    return text;
}

} // namespace

ResultDatabase::ResultDatabase(const std::filesystem::path &file, bool mayWrite,
                               const FileSystemAbilities &abilities)
    : file_(file),
      connection_(file, mayWrite ? sqlite::Connection::Mode::write : sqlite::Connection::Mode::read,
                  abilities)
{
    openResultSchema(connection_, file, mayWrite);
    if (mayWrite)
    {
        connection_.beginLog();
        connection_.run("PRAGMA foreign_keys = ON");
        connection_.run("PRAGMA synchronous = FULL"); // what is committed is on the disk
    }
    sqlite::Statement columns(connection_, "SELECT name FROM pragma_table_info('runs')");
    while (columns.step())
        columns_.emplace(folded(columns.text(0)), columns.text(0));
    if (mayWrite)
        addMissingColumns();
}

void ResultDatabase::describe(const BenchmarkPlan &plan, const Provenance &provenance)
{
    provenance_ = provenance;
    timeLimit_ = plan.limits.time;
    memoryLimit_ = plan.limits.memory;
    repetitions_ = plan.repetitions;
    seed_ = std::to_string(plan.seed);
    planText_ = plan.text;
    const auto points = identifyPoints(plan, MissingInput::tolerate);
    for (std::size_t p = 0; p < points.size(); ++p)
        questions_[points[p].id] = toText(experimentParts(plan, p, points[p].inputs.value_or("")));
    const auto files = identifyPlanners(plan, MissingInput::tolerate);
    for (std::size_t i = 0; i < files.size(); ++i)
    {
        const Configured &planner = plan.planners[i];
        plannerSettings_[planner.name] = settingsText(planner, files[i].value_or(FileHashes()));
        plannerQuestions_[planner.name] = toText(plannerParts(planner, files[i].value_or(FileHashes())));
    }
    experiments_.clear();
    planners_.clear();
}

void ResultDatabase::add(const FinishedRun &run)
{
    const RunRecord &record = run.record;
    sqlite::Statement &known = prepared("SELECT 1 FROM runs WHERE run_key = ?");
    const bool isThere = known.bind(1, record.runKey).step();
    known.reset();
    if (isThere)
        return;
    addColumns(record.extra);
    const std::int64_t experimentId = experiment(record);
    insert(record, experimentId, planner(record.planner));
    insert(run.progress, connection_.lastRowId());
    spent_[experimentId] += record.time.value_or(0);
    if (!record.solutionFingerprint.empty())
        insert(record.runKey, run.solution);
}

void ResultDatabase::endBatch()
{
    sqlite::Statement &total = prepared("UPDATE experiments SET totaltime = totaltime + ? WHERE id = ?");
    for (const auto &[id, seconds] : spent_)
        total.bind(1, seconds).bind(2, id).execute();
    spent_.clear();
}

void ResultDatabase::settle(bool kept)
{
    if (!kept)
    {
        for (const std::string &name : newColumns_)
            columns_.erase(name);
        experiments_.clear();
        planners_.clear();
        spent_.clear();
    }
    newColumns_.clear();
}

sqlite::Statement &ResultDatabase::prepared(const std::string &sql)
{
    auto &statement = statements_[sql];
    if (!statement)
        statement = std::make_unique<sqlite::Statement>(connection_, sql);
    return *statement;
}

void ResultDatabase::addMissingColumns()
{
    for (const RunColumn &column : runColumns())
        if (columns_.emplace(column.name, column.name).second)
            connection_.run("ALTER TABLE runs ADD COLUMN " + sqlite::quoted(column.name) + " " +
                            sqlType(column.type));
}

void ResultDatabase::addColumns(const std::map<std::string, Value> &extra)
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
        connection_.run("ALTER TABLE runs ADD COLUMN " + sqlite::quoted(name) + " " + extraType(value));
        newColumns_.push_back(folded(name));
        columns_.emplace(folded(name), name);
    }
}

std::int64_t ResultDatabase::experiment(const RunRecord &record)
{
    const std::string name = experimentName(record.caseId);
    const auto [entry, isNew] = experiments_.try_emplace(name);
    if (!isNew)
        return entry->second;
    const std::string &question = questions_[name];
    sqlite::Statement &find = prepared("SELECT id FROM experiments WHERE name = ? AND timelimit IS ? AND "
                                       "memorylimit IS ? AND seed IS ? AND setup IS ? AND question IS ?");
    find.bind(1, name).bind(2, timeLimit_).bind(3, memoryLimit_).bind(4, seed_).bind(5, planText_);
    const bool isThere = find.bind(6, question).step();
    if (isThere)
        entry->second = find.integer(0);
    find.reset();
    if (isThere)
        return entry->second;
    sqlite::Statement &insert = prepared("INSERT INTO experiments VALUES "
                                         "(NULL, ?, 0, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    int parameter = 0;
    for (const Value &value : std::initializer_list<Value>{
             name, timeLimit_, memoryLimit_, repetitions_, provenance_.version, provenance_.host,
             provenance_.cpu, provenance_.started, seed_, planText_, record.model, record.problem,
             record.sweepVariable, record.sweepValue ? Value(*record.sweepValue) : Value(), question})
        insert.bind(++parameter, value);
    insert.execute();
    return entry->second = connection_.lastRowId();
}

std::int64_t ResultDatabase::planner(const std::string &name)
{
    const auto [entry, isNew] = planners_.try_emplace(name);
    if (!isNew)
        return entry->second;
    const std::string &settings = plannerSettings_[name];
    sqlite::Statement &find = prepared("SELECT id FROM plannerConfigs WHERE name = ? AND settings = ?");
    const bool isThere = find.bind(1, name).bind(2, settings).step();
    if (isThere)
        entry->second = find.integer(0);
    find.reset();
    if (isThere)
        return entry->second;
    prepared("INSERT INTO plannerConfigs VALUES (NULL, ?, ?, ?)")
        .bind(1, name)
        .bind(2, settings)
        .bind(3, plannerQuestions_[name])
        .execute();
    return entry->second = connection_.lastRowId();
}

void ResultDatabase::insert(const RunRecord &record, std::int64_t experimentId, std::int64_t plannerId)
{
    std::string names = "experimentid, plannerid, solved";
    std::string marks = "?, ?, ?";
    for (const RunColumn &column : runColumns())
    {
        names.append(", \"").append(column.name).append("\"");
        marks += ", ?";
    }
    for (const auto &[name, value] : record.extra)
        if (!std::holds_alternative<std::monostate>(value))
        {
            names += ", " + sqlite::quoted(name);
            marks += ", ?";
        }
    sqlite::Statement &statement = prepared("INSERT INTO runs (" + names + ") VALUES (" + marks + ")");
    int parameter = 0;
    for (const std::int64_t id : {experimentId, plannerId, std::int64_t{record.solved() ? 1 : 0}})
        statement.bind(++parameter, Value(id));
    for (const RunColumn &column : runColumns())
        statement.bind(++parameter, column.name == "status" ? Value(static_cast<std::int64_t>(record.status))
                                                            : column.get(record));
    for (const auto &[name, value] : record.extra)
        if (!std::holds_alternative<std::monostate>(value))
            statement.bind(++parameter, value);
    statement.execute();
}

/// Samples of the run in the row `runId` of `runs`; a new property becomes a new column.
void ResultDatabase::insert(const Progress &progress, std::int64_t runId)
{
    if (progress.samples.empty())
        return;
    std::string names = "runid, time";
    std::string marks = "?, ?";
    for (const std::string &name : progress.names)
    {
        if (!connection_.hasColumn("progress", name))
            connection_.run("ALTER TABLE progress ADD COLUMN " + sqlite::quoted(name) + " REAL");
        names += ", " + sqlite::quoted(name);
        marks += ", ?";
    }
    // Planner Arena knows a sample by its time: of two at one moment the later one counts.
    sqlite::Statement statement(connection_,
                                "INSERT OR REPLACE INTO progress (" + names + ") VALUES (" + marks + ")");
    for (const Progress::Sample &sample : progress.samples)
    {
        statement.bind(1, Value(runId)).bind(2, Value(sample.time));
        for (std::size_t i = 0; i < sample.values.size(); ++i)
            statement.bind(static_cast<int>(i) + 3, Value(sample.values[i]));
        statement.execute();
    }
}

void ResultDatabase::insert(const std::string &runKey, const Solution &solution)
{
    const std::vector<std::uint8_t> packed = packSolution(solution);
    if (packed.size() <= kLargestSolution)
        prepared("INSERT OR REPLACE INTO solutions VALUES (?, ?)").bind(1, runKey).bind(2, packed).execute();
}

} // namespace mrpp
