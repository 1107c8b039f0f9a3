#include "framework/store/ResultStore.h"

#include "framework/run/RunRecordJson.h"
#include "framework/store/Sqlite.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "tests/campaign/Fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrpp
{
namespace
{

using Access = ResultStore::Access;
using testing::ElementsAre;
using testing::HasSubstr;

class ResultStoreTest : public testing::Test
{
protected:
    [[nodiscard]] const std::filesystem::path &dir() const { return folder_.path(); }
    [[nodiscard]] std::filesystem::path file() const { return dir() / "results.sqlite"; }

    static RunRecord record(const std::string &key)
    {
        RunRecord record;
        record.runKey = key;
        record.caseId = "lanes/lanes/robots=2/0";
        record.model = "lanes";
        record.problem = "lanes";
        record.planner = "walker";
        record.status = PlannerStatus::solved;
        record.graphSeed = 9223372036854775807U;
        record.time = 0.125;
        record.occupancy = 1; // whole, in a column of real numbers
        record.pathLength = 2;
        record.solutionFingerprint = solution().fingerprint();
        return record;
    }
    static Solution solution() { return Solution({{0, 0, 1}, {1, 5, 4}}); }

    [[nodiscard]] std::string complaintOfOpening(Access access = Access::write) const
    {
        try
        {
            const ResultStore store(dir(), access);
            return "";
        }
        catch (const FileError &error)
        {
            return error.what();
        }
    }

    std::vector<std::string> texts(const std::string &sql) const
    {
        sqlite::Connection database(file(), sqlite::Connection::Mode::read);
        sqlite::Statement query(database, sql);
        std::vector<std::string> list;
        while (query.step())
            list.push_back(query.text(0));
        return list;
    }

private:
    fixtures::TemporaryFolder folder_;
};

TEST_F(ResultStoreTest, KeepsRunsAndSolutions)
{
    RunRecord first = record("a");
    first.extra["turns"] = std::int64_t{4};
    first.extra["a \"quoted\" name; --"] = std::string("x'y");
    RunRecord second = record("b");
    second.status = PlannerStatus::gave_up;
    second.reason = "robots 1 and 2\nblock each other";
    second.solutionFingerprint.clear();
    {
        ResultStore store(dir(), Access::write);
        store.add(first, solution());
        store.add(second, Solution());
    }
    const ResultStore store(dir(), Access::read);
    const auto records = store.records();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(toJson(records[0], JsonColumns::all), toJson(first, JsonColumns::all));
    EXPECT_EQ(toJson(records[1], JsonColumns::all), toJson(second, JsonColumns::all));
    EXPECT_EQ(store.finishedKeys(), (std::set<std::string>{"a", "b"}));
    EXPECT_EQ(store.finishedKeys("b"), std::set<std::string>{"b"});
    EXPECT_TRUE(store.finishedKeys("ab").empty());
    EXPECT_EQ(toJson(store.record("b").value(), JsonColumns::all), toJson(second, JsonColumns::all));
    EXPECT_FALSE(store.record("").has_value());
    EXPECT_EQ(store.solution("a"), solution());
    EXPECT_EQ(store.solution("b"), std::nullopt);
    EXPECT_EQ(store.solution("c"), std::nullopt);
}

TEST_F(ResultStoreTest, KeepsProgressBesideItsRun)
{
    const Progress progress = {{"best \"cost\"", "nodes"}, {{0.05, {9, 1}}, {0.1, {7, 2}}, {0.1, {6, 3}}}};
    {
        ResultStore store(dir(), Access::write);
        store.add(record("a"), solution());
        store.add(record("b"), solution(), progress);
    }
    EXPECT_EQ(texts("SELECT run_key || ' ' || progress.time || ' ' || \"best \"\"cost\"\"\" || ' ' || nodes "
                    "FROM progress JOIN runs ON runid = id ORDER BY progress.time"),
              (std::vector<std::string>{"b 0.05 9.0 1.0", "b 0.1 6.0 3.0"}));
}

TEST_F(ResultStoreTest, KeepsASolutionWithoutMoves)
{
    ResultStore store(dir(), Access::write);
    RunRecord still = record("a");
    still.solutionFingerprint = Solution().fingerprint();
    store.add(still, Solution());
    EXPECT_EQ(store.solution("a"), Solution());
}

TEST_F(ResultStoreTest, LeavesOutSolutionsThatAreTooLarge)
{
    ResultStore store(dir(), Access::write);
    Solution large;
    for (int i = 0; i < 1500000; ++i)
        large.append({0, static_cast<Vertex>(i % 2), static_cast<Vertex>(1 - i % 2)});
    store.add(record("a"), large);
    EXPECT_EQ(store.solution("a"), std::nullopt);
    EXPECT_EQ(store.records().size(), 1U);
}

TEST_F(ResultStoreTest, NeverChangesAFinishedRun)
{
    ResultStore store(dir(), Access::write);
    store.add(record("a"), solution());
    RunRecord other = record("a");
    other.status = PlannerStatus::crash;
    store.add(other, Solution());
    ASSERT_EQ(store.records().size(), 1U);
    EXPECT_EQ(store.records()[0].status, PlannerStatus::solved);
    EXPECT_EQ(store.solution("a"), solution());
}

TEST_F(ResultStoreTest, TakesColumnsThatAnOlderVersionDidNotKnow)
{
    {
        ResultStore store(dir(), Access::write);
        store.add(record("old"), solution());
    }
    {
        sqlite::Connection old(file(), sqlite::Connection::Mode::write);
        old.run("ALTER TABLE runs DROP COLUMN solvable");
        old.run("ALTER TABLE runs DROP COLUMN unsolvable_reason");
    }
    EXPECT_EQ(ResultStore(dir(), Access::read).records().at(0).solvable, "");
    ResultStore store(dir(), Access::write);
    RunRecord fresh = record("new");
    fresh.solvable = "no";
    fresh.unsolvableReason = "robots 0 and 1 cannot pass each other on the path 0–2";
    store.add(fresh, solution());
    const std::vector<RunRecord> records = store.records();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].solvable, "");
    EXPECT_FALSE(records[0].unsolvable());
    EXPECT_TRUE(records[1].unsolvable());
    EXPECT_EQ(records[1].unsolvableReason, fresh.unsolvableReason);
}

TEST_F(ResultStoreTest, CountsAttempts)
{
    {
        ResultStore store(dir(), Access::write);
        EXPECT_EQ(store.begin("a"), 1);
        EXPECT_EQ(store.begin("a"), 2);
        EXPECT_EQ(store.begin("b"), 1);
    }
    ResultStore store(dir(), Access::write);
    EXPECT_EQ(store.begin("a"), 3);
}

TEST_F(ResultStoreTest, RefusesASecondWriter)
{
    const ResultStore store(dir(), Access::write);
    EXPECT_THAT(complaintOfOpening(), HasSubstr("is running a campaign in this folder"));
    EXPECT_EQ(complaintOfOpening(Access::read), "");
}

TEST_F(ResultStoreTest, CanBeReadWhileItIsWritten)
{
    ResultStore writer(dir(), Access::write);
    writer.add(record("a"), solution());
    const ResultStore reader(dir(), Access::read);
    EXPECT_EQ(reader.records().size(), 1U);
    writer.add(record("b"), solution());
    EXPECT_EQ(reader.records().size(), 2U);
}

TEST_F(ResultStoreTest, LeavesOneFileThatHoldsEverything)
{
    {
        ResultStore writer(dir(), Access::write);
        writer.add(record("a"), solution());
    }
    EXPECT_EQ(ResultStore(dir(), Access::read).records().size(), 1U);
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(dir()))
        names.insert(entry.path().filename());
    EXPECT_EQ(names, (std::set<std::string>{".lock", "results.sqlite"}));
    std::filesystem::create_directory(dir() / "copy");
    std::filesystem::copy_file(file(), dir() / "copy" / "results.sqlite");
    EXPECT_EQ(ResultStore(dir() / "copy", Access::read).solution("a"), solution());
}

TEST_F(ResultStoreTest, CanBeClosedWhileAReportReads)
{
    auto writer = std::make_unique<ResultStore>(dir(), Access::write);
    writer->add(record("a"), solution());
    const ResultStore reader(dir(), Access::read);
    EXPECT_EQ(reader.records().size(), 1U);
    writer.reset();
    EXPECT_EQ(reader.records().size(), 1U);
    ResultStore next(dir(), Access::write);
    next.add(record("b"), solution());
    EXPECT_EQ(reader.records().size(), 2U);
}

TEST_F(ResultStoreTest, IsReadAfterItsWriterWasKilledWithinATransaction)
{
    {
        ResultStore store(dir(), Access::write);
        store.add(record("a"), solution());
    }
    const pid_t writer = ::fork();
    if (writer == 0)
    {
        sqlite::Connection database(file(), sqlite::Connection::Mode::write);
        database.run("PRAGMA cache_size = 1"); // so that changes reach the file before they are committed
        database.run("BEGIN IMMEDIATE");
        database.run("CREATE TABLE unfinished (text)");
        for (int i = 0; i < 1000; ++i)
            database.run("INSERT INTO unfinished VALUES (hex(randomblob(1000)))");
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(writer, &status, 0), writer);
    ASSERT_GT(std::filesystem::file_size(file().string() + "-journal"), 0U);
    EXPECT_THAT(complaintOfOpening(Access::read), "");
    EXPECT_EQ(ResultStore(dir(), Access::read).records().size(), 1U);
    EXPECT_FALSE(sqlite::Connection(file(), sqlite::Connection::Mode::read).hasTable("unfinished"));
}

TEST_F(ResultStoreTest, HasTheTablesOfPlannerArena)
{
    {
        ResultStore store(dir(), Access::write);
        BenchmarkPlan plan = fixtures::plan({"walker"});
        plan.planners[0].settings = {{"detours", "2"}};
        Provenance provenance;
        provenance.version = "1.2.3";
        provenance.started = "2026-01-02T03:04:05Z";
        store.describe(plan, provenance);
        RunRecord slow = record("a");
        slow.time = 2;
        RunRecord failed = record("b");
        failed.planner = "quitter";
        failed.status = PlannerStatus::gave_up;
        store.add(slow, solution());
        store.add(failed, Solution());
    }
    EXPECT_THAT(texts("SELECT name FROM sqlite_master WHERE type IN ('table', 'view') AND name NOT LIKE "
                      "'sqlite_%' ORDER BY name"),
                ElementsAre("attempts", "bestPlannerConfigs", "bestPlannerConfigsPerExperiment", "enums",
                            "experiments", "meta", "plannerConfigs", "progress", "runs", "solutions"));
    EXPECT_THAT(texts("SELECT name FROM pragma_table_info('experiments') LIMIT 12"),
                ElementsAre("id", "name", "totaltime", "timelimit", "memorylimit", "runcount", "version",
                            "hostname", "cpuinfo", "date", "seed", "setup"));
    EXPECT_THAT(texts("SELECT name FROM pragma_table_info('runs') LIMIT 5"),
                ElementsAre("id", "experimentid", "plannerid", "run_key", "case"));
    EXPECT_THAT(texts("SELECT name || ' ' || type FROM pragma_table_info('runs') WHERE name IN "
                      "('status', 'solved', 'time') ORDER BY name"),
                ElementsAre("solved BOOLEAN", "status ENUM", "time REAL"));
    EXPECT_THAT(texts("SELECT status || ' ' || solved FROM runs ORDER BY id"), ElementsAre("6 1", "11 0"));
    EXPECT_THAT(texts("SELECT value || ' ' || description FROM enums WHERE name = 'status' ORDER BY value"),
                ElementsAre("0 unknown", "4 timeout", "5 partial", "6 solved", "7 crash", "8 aborted",
                            "9 infeasible", "11 gave_up", "12 unsupported", "13 memory_limit", "14 invalid"));
    EXPECT_THAT(
        texts("SELECT name || '|' || totaltime || '|' || timelimit || '|' || runcount || '|' || version "
              "|| '|' || date || '|' || seed || '|' || setup FROM experiments"),
        ElementsAre("lanes/lanes/robots=2|2.125|10.0|2|1.2.3|2026-01-02T03:04:05Z|2016|campaign: test\n"));
    EXPECT_THAT(texts("SELECT name || '|' || settings FROM plannerConfigs ORDER BY id"),
                ElementsAre("walker|planner = walker;detours = 2;", "quitter|"));
    EXPECT_THAT(
        texts("SELECT plannerid || ' ' || avg_solved || ' ' || avg_total_time FROM bestPlannerConfigs"),
        ElementsAre("1 1.0 2.0", "2 0.0 0.125"));
}

TEST_F(ResultStoreTest, PicksTheBestSettingsOfAPlanner)
{
    for (const std::string detours : {"2", "1"})
    {
        ResultStore store(dir(), Access::write);
        BenchmarkPlan plan = fixtures::plan({"walker"});
        plan.planners[0].settings = {{"detours", detours}};
        store.describe(plan, {});
        RunRecord run = record(detours);
        run.status = detours == "1" ? PlannerStatus::solved : PlannerStatus::timeout;
        store.add(run, solution());
    }
    EXPECT_THAT(
        texts("SELECT settings FROM bestPlannerConfigsPerExperiment JOIN plannerConfigs ON id = plannerid"),
        ElementsAre("planner = walker;detours = 1;"));
}

TEST_F(ResultStoreTest, RefusesColumnsWhoseNamesAreTaken)
{
    ResultStore store(dir(), Access::write);
    for (const std::string name : {"Time", "run_key", "id", "SOLVED", ""})
    {
        RunRecord bad = record("bad");
        bad.extra["aaa"] = 1.0;
        bad.extra[name] = 1.0;
        EXPECT_THROW(store.add(bad, solution()), InputError) << name;
    }
    EXPECT_TRUE(store.records().empty());
    RunRecord good = record("good");
    good.extra["aaa"] = 2.0; // the column went with the failure, and comes again
    store.add(good, solution());
    RunRecord other = record("other");
    other.extra["AAA"] = 2.0;
    EXPECT_THROW(store.add(other, solution()), InputError);
    EXPECT_EQ(store.records().size(), 1U);
}

TEST_F(ResultStoreTest, SaysWhereThereIsNoCampaign)
{
    EXPECT_EQ(complaintOfOpening(Access::read),
              dir().string() + ": holds no campaign (there is no results.sqlite)");
}

TEST_F(ResultStoreTest, RefusesAFileThatIsNoDatabase)
{
    writeFile(file(), std::string(5000, 'x'));
    EXPECT_THAT(complaintOfOpening(),
                HasSubstr("file is not a database; the file is damaged or no result store"));
    EXPECT_THAT(complaintOfOpening(Access::read), HasSubstr("file is not a database"));
    EXPECT_EQ(readFile(file()), std::string(5000, 'x'));
}

TEST_F(ResultStoreTest, RefusesAnotherProgramsDatabase)
{
    sqlite::Connection(file(), sqlite::Connection::Mode::write).run("CREATE TABLE songs (title)");
    EXPECT_THAT(complaintOfOpening(), HasSubstr("is a database, but no store of results"));
    EXPECT_THAT(texts("SELECT name FROM sqlite_master"), ElementsAre("songs"));
}

TEST_F(ResultStoreTest, RefusesANewerVersion)
{
    (void)complaintOfOpening();
    sqlite::Connection(file(), sqlite::Connection::Mode::write)
        .run("UPDATE meta SET value = 2 WHERE key = 'schema'");
    EXPECT_THAT(complaintOfOpening(), HasSubstr("was written by a newer version of this program (schema 2"));
    EXPECT_THAT(complaintOfOpening(Access::read), HasSubstr("newer version"));
}

TEST_F(ResultStoreTest, SaysThatADamagedFileIsDamaged)
{
    {
        ResultStore store(dir(), Access::write);
        for (int i = 0; i < 200; ++i)
            store.add(record(std::to_string(i)), solution());
    }
    std::string bytes = readFile(file());
    for (std::size_t i = 4096; i < bytes.size(); ++i)
        bytes[i] = static_cast<char>(0xA5);
    writeFile(file(), bytes);
    try
    {
        const ResultStore store(dir(), Access::read);
        (void)store.records();
        FAIL() << "nothing was noticed";
    }
    catch (const FileError &error)
    {
        EXPECT_THAT(error.what(), HasSubstr("the file is damaged"));
    }
}

TEST_F(ResultStoreTest, SaysThatADamagedSolutionIsDamaged)
{
    {
        ResultStore store(dir(), Access::write);
        store.add(record("a"), solution());
    }
    sqlite::Connection(file(), sqlite::Connection::Mode::write).run("UPDATE solutions SET moves = x'0105'");
    const ResultStore store(dir(), Access::read);
    EXPECT_THROW((void)store.solution("a"), FileError);
}

TEST_F(ResultStoreTest, RefusesAFolderThatIsAFile)
{
    writeFile(dir() / "occupied", "");
    EXPECT_THROW(ResultStore(dir() / "occupied", Access::write), FileError);
    EXPECT_THROW(ResultStore("/proc/no such folder", Access::write), FileError);
}

TEST_F(ResultStoreTest, LosesNothingWhenTheDiskIsFull)
{
    ResultStore store(dir(), Access::write);
    store.add(record("a"), solution());
    // Stands for a full disk: SQLite reports both the same way.
    struct rlimit limit
    {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit small = limit;
    small.rlim_cur = std::filesystem::file_size(file().string() + "-wal") + 100;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(store.add(record("b"), solution()), FileError);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::signal(SIGXFSZ, ignored);
    EXPECT_EQ(store.finishedKeys(), std::set<std::string>{"a"});
    store.add(record("b"), solution());
    EXPECT_EQ(store.finishedKeys(), (std::set<std::string>{"a", "b"}));
}

} // namespace
} // namespace mrpp
