/// \file
/// What goes wrong around the planners is no planner's failure: full and missing temporary folders, programs
/// that cannot be started, inputs that change, kills, limits of the system.

#include "framework/store/ResultStore.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

constexpr const char *kYard = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";

/// A script that waits and then solves: SECONDS GRAPH INSTANCE OUTPUT.
const std::string kSolver =
    std::string("#!/bin/sh\nsleep $1\nexec ") + MRPP_PROGRAM +
    " solve --graph \"$2\" --instance \"$3\" --planner push_and_swap --solution \"$4\" "
    "> /dev/null\n";

/// A plan of one-robot cases on those maps for a planner that needs so long.
std::string plan(const std::string &seconds, const std::string &maps = "a.map", int repetitions = 1)
{
    return "campaign: c\nrepetitions: " + std::to_string(repetitions) +
           "\nproblems:\n  - public_benchmark: {map: [" + maps +
           "], robots: [1]}\nplanners:\n  - {command: \"./solver.sh " + seconds +
           " {graph} {instance} {output}\", name: solver}\nreports: [csv]\n";
}

void setSolver(const Scratch &scratch, const std::string &text)
{
    scratch.write("solver.sh", text);
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
}

void prepare(const Scratch &scratch, const std::string &text)
{
    for (const char *map : {"a.map", "b.map"})
        scratch.write(map, kYard);
    scratch.write("solver.sh", kSolver);
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
    scratch.write("plan.yaml", text);
}

std::vector<RunRecord> records(const Scratch &scratch, const std::string &folder = "out")
{
    if (!scratch.has(folder + "/provenance.json")) // written when the store is there
        return {};
    return ResultStore(scratch.path() / folder, ResultStore::Access::read).records();
}

void waitUntil(const std::function<bool()> &isSo)
{
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!isSo() && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

Outcome shell(const std::string &script, const Scratch &scratch)
{
    return Process({"sh", "-c", script}, scratch).wait();
}

const std::string kRun = std::string(MRPP_PROGRAM) + " run plan.yaml -q -o out";

/// The same command, once everything is mended, makes the runs that are left.
void expectItGoesOn(const Scratch &scratch, std::size_t runs)
{
    const Outcome outcome = mrppsim({"run", "plan.yaml", "-q", "-o", "out"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto all = records(scratch);
    EXPECT_EQ(all.size(), runs);
    for (const RunRecord &record : all)
        EXPECT_EQ(record.status, PlannerStatus::solved) << record.reason;
}

TEST(Harness, AFullTemporaryFolderEndsTheCampaignAndNoPlannerIsBlamed)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    fs::create_directory(scratch.path() / "full");
    const std::string mount = "mount -t tmpfs -o size=4k none full 2>/dev/null || exit 99; echo x > full/x; ";
    const Outcome outcome =
        Process({"unshare", "-m", "sh", "-c", mount + "TMPDIR=full " + kRun}, scratch).wait();
    if (outcome.code == 99 || outcome.code == 1)
        GTEST_SKIP() << "this user may mount nothing";
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("No space left on device"));
    EXPECT_THAT(outcome.err, HasSubstr("nothing was recorded for this run"));
    EXPECT_TRUE(records(scratch).empty());
    expectItGoesOn(scratch, 1);
}

TEST(Harness, NoRoomForAnAnswerEndsTheCampaign)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    setSolver(scratch, "#!/bin/sh\nhead -c 100000 /dev/zero > $4; exit 0\n");
    fs::create_directory(scratch.path() / "full");
    const std::string mount = "mount -t tmpfs -o size=60k none full 2>/dev/null || exit 99; ";
    const Outcome outcome =
        Process({"unshare", "-m", "sh", "-c", mount + "TMPDIR=full " + kRun}, scratch).wait();
    if (outcome.code == 99 || outcome.code == 1)
        GTEST_SKIP() << "this user may mount nothing";
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("the temporary folder (TMPDIR) has no room left"));
    EXPECT_TRUE(records(scratch).empty());
}

TEST(Harness, AFileSizeLimitIsNoPlannersFault)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    const Outcome outcome = shell("ulimit -f 0; " + kRun, scratch);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_TRUE(records(scratch).empty());
    fs::remove_all(scratch.path() / "out");
    expectItGoesOn(scratch, 1);
}

TEST(Harness, RelativeFoldersInTMPDIRAndPATHAreThoseOfTheCaller)
{
    const Scratch scratch;
    fs::create_directories(scratch.path() / "elsewhere/t");
    fs::create_directories(scratch.path() / "elsewhere/bin");
    prepare(scratch, plan("0"));
    fs::rename(scratch.path() / "solver.sh", scratch.path() / "elsewhere/bin/solver.sh");
    std::string text = plan("0");
    scratch.write("plan.yaml", text.replace(text.find("./solver.sh"), 11, "solver.sh"));
    const Outcome outcome = shell("cd elsewhere && TMPDIR=t PATH=bin:$PATH " + std::string(MRPP_PROGRAM) +
                                      " run ../plan.yaml -q -o ../out",
                                  scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto all = records(scratch);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].status, PlannerStatus::solved) << all[0].reason;
    EXPECT_TRUE(fs::is_empty(scratch.path() / "elsewhere/t"));
}

TEST(Harness, AScriptThatCannotBeStartedAnyMoreEndsTheCampaign)
{
    const Scratch scratch;
    prepare(scratch, plan("0.2", "a.map", 4));
    Process campaign(mrppsimWords({"run", "plan.yaml", "-q", "-o", "out"}), scratch);
    waitUntil([&scratch] { return !records(scratch).empty(); });
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_read);
    const Outcome outcome = campaign.wait();
    if (outcome.code == 0)
        GTEST_SKIP() << "it was too fast";
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("solver.sh"));
    for (const RunRecord &record : records(scratch))
        EXPECT_EQ(record.status, PlannerStatus::solved) << record.reason;
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
    expectItGoesOn(scratch, 4);
}

TEST(Harness, NothingIsRecordedUnderTheKeyOfAFileThatChanged)
{
    for (const char *changed : {"b.map", "solver.sh"})
    {
        SCOPED_TRACE(changed);
        const Scratch scratch;
        prepare(scratch, plan("0.4", "a.map, b.map"));
        Process campaign(mrppsimWords({"run", "plan.yaml", "-q", "-o", "out"}), scratch);
        waitUntil([&scratch] { return scratch.has("out/.begun"); });
        const std::string before = scratch.read(changed);
        // Both maps, as their order is drawn.
        for (const char *map : {"a.map", "b.map"})
            if (std::string(changed) == "b.map")
                scratch.write(map, "type octile\nheight 3\nwidth 5\nmap\n.....\n.@@..\n.....\n");
        if (std::string(changed) == "solver.sh")
            scratch.write(changed, kSolver + "# changed\n");
        fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
        const Outcome outcome = campaign.wait();
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("changed while the campaign ran"));
        for (const RunRecord &record : records(scratch))
            EXPECT_EQ(record.vertices, 10);
        for (const char *map : {"a.map", "b.map"})
            scratch.write(map, kYard);
        scratch.write("solver.sh", kSolver);
        fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
        expectItGoesOn(scratch, 2);
        for (const RunRecord &record : records(scratch))
            EXPECT_EQ(record.vertices, 10);
    }
}

TEST(Harness, LeavesNothingInTheTemporaryFolderHoweverItEnds)
{
    for (const int signal : {SIGINT, SIGHUP, SIGKILL})
    {
        SCOPED_TRACE(signal);
        const Scratch scratch;
        fs::create_directory(scratch.path() / "t");
        prepare(scratch, plan("100"));
        setSolver(scratch, "#!/bin/sh\nhead -c 3000000 /dev/zero > \"$4\"\nsleep 60\n");
        const auto isEmpty = [&scratch] { return fs::is_empty(scratch.path() / "t"); };
        Process campaign({"env", "TMPDIR=t", MRPP_PROGRAM, "run", "plan.yaml", "-q", "-o", "out"}, scratch);
        waitUntil([&isEmpty] { return !isEmpty(); });
        campaign.signal(signal);
        EXPECT_EQ(campaign.wait().code, signal == SIGKILL ? -SIGKILL : 130);
        if (signal == SIGKILL) // its guardians clean up behind it
            waitUntil(isEmpty);
        EXPECT_TRUE(isEmpty());
    }
}

TEST(Harness, CountsTheMemoryThatOutsideProgramsUseAndNotTheirAddresses)
{
    const std::string withoutGroups =
        "mount | grep cgroup | cut -d' ' -f3 | sort -r | xargs -r umount 2>/dev/null; ";
    for (const std::string &before : {std::string(), withoutGroups})
    {
        const Scratch scratch;
        prepare(scratch, "campaign: c\nlimits: {time: 60 s, memory: 150 MB}\nproblems:\n"
                         "  - public_benchmark: {map: a.map, robots: 1}\nplanners:\n"
                         "  - {command: \"" MRPP_THREADS " 400 20 0.3 {instance} {output}\", name: many}\n"
                         "  - {command: \"" MRPP_THREADS " 400 200 3 {instance} {output}\", name: large}\n"
                         "reports: [csv]\n");
        const Outcome outcome = Process({"unshare", "-m", "sh", "-c", before + kRun}, scratch).wait();
        if (records(scratch).empty())
            GTEST_SKIP() << "this user may mount nothing: " << outcome.err;
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        for (const RunRecord &record : records(scratch))
        {
            const bool isLarge = record.planner == "large";
            EXPECT_EQ(record.status, isLarge ? PlannerStatus::memory_limit : PlannerStatus::gave_up)
                << record.limitMeans << ": " << record.reason;
            EXPECT_THAT(record.limitMeans, HasSubstr(before.empty() ? "" : "/proc"));
        }
    }
}

TEST(Harness, APipeAsAnAnswerHoldsNobodyUp)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    scratch.write("solver.sh", "#!/bin/sh\nmkfifo $4\n");
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "-q", "-o", "out"}, scratch).code, 3);
    ASSERT_EQ(records(scratch).size(), 1U);
    EXPECT_EQ(records(scratch)[0].status, PlannerStatus::invalid);
    EXPECT_THAT(records(scratch)[0].reason, HasSubstr("it is no file, but a folder, a pipe or a device"));
}

TEST(Harness, CrashesAreDefectsInTheExitCode)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    scratch.write("solver.sh", "#!/bin/sh\nexit 7\n");
    fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
    const Outcome outcome = mrppsim({"run", "plan.yaml", "-q", "-o", "out"}, scratch);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("1 run crashed: see the column reason"));
    EXPECT_EQ(mrppsim({"run", "plan.yaml", "-q", "-o", "out"}, scratch).code, 3); // it still has
}

TEST(Harness, ExplainsWhyAScriptCannotBeStarted)
{
    for (const auto &[script, why] : std::vector<std::pair<std::string, std::string>>{
             {"#!/bin/sh\r\nexit 0\r\n", "its first line ends as in Windows files (CR LF)"},
             {"#!/no/such/sh\nexit 0\n", "its first line names '/no/such/sh', which is not there"},
             {"exit 0\n", "it has no first line '#!…' that says what runs it"}})
    {
        const Scratch scratch;
        prepare(scratch, plan("0"));
        scratch.write("solver.sh", script);
        fs::permissions(scratch.path() / "solver.sh", fs::perms::owner_all);
        const Outcome outcome = mrppsim({"run", "plan.yaml", "-q", "-o", "out"}, scratch);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, StartsWith("plan.yaml:6:15: './solver.sh' cannot be started: " + why));
        const Outcome dry = mrppsim({"run", "plan.yaml", "--dry-run"}, scratch);
        EXPECT_EQ(dry.code, 0);
        EXPECT_THAT(dry.err, HasSubstr("note: plan.yaml:6:15: './solver.sh' cannot be started: " + why));
    }
}

TEST(Harness, MissingProgramsAreSaidWhereNothingRuns)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    fs::remove(scratch.path() / "solver.sh");
    const std::string note = "note: plan.yaml:6:15: there is no program './solver.sh'";
    EXPECT_THAT(mrppsim({"run", "plan.yaml", "--dry-run"}, scratch).err, HasSubstr(note));
    const Outcome slurm = mrppsim({"slurm", "plan.yaml", "-o", "jobs", "--shards", "2"}, scratch);
    EXPECT_THAT(slurm.err, HasSubstr(note));
}

TEST(Harness, AFolderThatGoesAwayIsNoticedAtOnce)
{
    const Scratch scratch;
    prepare(scratch, plan("0.1", "a.map", 100));
    Process campaign(mrppsimWords({"run", "plan.yaml", "-q", "-o", "out"}), scratch);
    waitUntil([&scratch] { return !records(scratch).empty(); });
    fs::remove_all(scratch.path() / "out");
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = campaign.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("out: the folder was removed or replaced while the campaign ran"));
}

TEST(Harness, LimitsOfTheSystemAreNoDefects)
{
    const Scratch scratch;
    prepare(scratch, plan("0"));
    const Outcome longName = mrppsim({"run", "plan.yaml", "-q", "-o", std::string(300, 'x')}, scratch);
    EXPECT_EQ(longName.code, 2) << longName.err;
    EXPECT_THAT(longName.err, HasSubstr("File name too long"));
    const Outcome files = shell("exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ulimit -n 6; " + kRun, scratch);
    EXPECT_EQ(files.code, 2) << files.err;
    EXPECT_THAT(files.err, ::testing::Not(HasSubstr("defect")));
    for (const RunRecord &record : records(scratch))
        EXPECT_NE(record.status, PlannerStatus::crash) << record.reason;
}

} // namespace
} // namespace mrpp::test
