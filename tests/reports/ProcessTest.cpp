#include "reports/picture/Process.h"
#include "framework/system/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace std::chrono_literals;

TEST(RunProcess, GivesOutputAndExitCode)
{
    const TemporaryFolder folder;
    const auto result = runProcess({"sh", "-c", "pwd; echo bad >&2; exit 3"}, folder.path(), 10s);
    EXPECT_TRUE(result.started);
    EXPECT_FALSE(result.succeeded());
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.output, std::filesystem::canonical(folder.path()).string() + "\nbad\n");
}

TEST(RunProcess, ArgumentsMeetNoShell)
{
    const auto result = runProcess({"printf", "%s", "`echo a` $(echo b) $HOME"}, "/", 10s);
    EXPECT_TRUE(result.succeeded());
    EXPECT_EQ(result.output, "`echo a` $(echo b) $HOME");
}

TEST(RunProcess, SaysWhenThereIsNoSuchProgram)
{
    EXPECT_FALSE(runProcess({"mrppsim-no-such-program"}, "/", 10s).started);
}

TEST(RunProcess, KillsTheWholeGroupAtTheLimit)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto result = runProcess({"sh", "-c", "sleep 60 & sleep 60"}, "/", 200ms);
    EXPECT_TRUE(result.timedOut);
    EXPECT_FALSE(result.succeeded());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 20s);
}

TEST(RunProcess, ReadsNothingFromStandardInputAndKeepsLittleOutput)
{
    const auto result = runProcess({"sh", "-c", "cat; yes | head -c 1000000"}, "/", 30s);
    EXPECT_TRUE(result.succeeded());
    EXPECT_EQ(result.output.size(), 65536U);
}

} // namespace
} // namespace mrpp
