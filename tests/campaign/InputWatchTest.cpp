#include "framework/run/InputWatch.h"

#include "framework/Benchmark.h"
#include "framework/store/ResultStore.h"
#include "framework/support/HarnessError.h"
#include "framework/system/File.h"
#include "tests/campaign/Fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

std::string complaint(InputWatch &watch, const std::vector<std::filesystem::path> &files)
{
    try
    {
        watch.check(files);
    }
    catch (const HarnessError &error)
    {
        return error.what();
    }
    return "";
}

TEST(InputWatch, SaysWhichFileChanged)
{
    const fixtures::TemporaryFolder folder;
    const std::vector<std::filesystem::path> files = {folder.path() / "a.map", folder.path() / "b.map"};
    for (const auto &file : files)
        writeFile(file, "before");
    InputWatch watch(files);
    EXPECT_EQ(complaint(watch, files), "");
    writeFile(files[0], "before"); // touched, but the same
    EXPECT_EQ(complaint(watch, files), "");
    writeFile(files[1], "behind");
    EXPECT_THAT(complaint(watch, files), HasSubstr("b.map: changed while the campaign ran"));
    writeFile(files[1], "before");
    EXPECT_EQ(complaint(watch, files), "");
    std::filesystem::remove(files[0]);
    EXPECT_THAT(complaint(watch, files), HasSubstr("a.map: went away"));
    writeFile(folder.path() / "c.map", "new");
    EXPECT_THAT(complaint(watch, {folder.path() / "c.map"}), HasSubstr("c.map: appeared"));
}

TEST(InputWatch, EndsACampaignBeforeAnythingIsRecordedUnderTheWrongKey)
{
    const fixtures::TemporaryFolder folder;
    const auto file = folder.path() / "lanes.txt";
    writeFile(file, "one");
    BenchmarkPlan plan = fixtures::plan({"walker"}, 3);
    plan.points = {fixtures::lanes(1, file)};
    const Catalog catalog = fixtures::catalog();
    Benchmark benchmark(plan, catalog);
    benchmark.setPostRunEvent([&file](RunRecord &, const Instance &, const Solution &)
                              { writeFile(file, "two"); });
    EXPECT_THROW((void)benchmark.benchmark({.folder = folder.path() / "out"}, {}), HarnessError);
    EXPECT_EQ(ResultStore(folder.path() / "out", ResultStore::Access::read).records().size(), 1U);
    writeFile(file, "one");
    benchmark.setPostRunEvent({});
    const auto summary = benchmark.benchmark({.folder = folder.path() / "out"}, {});
    EXPECT_EQ(summary.kept, 1U);
    EXPECT_EQ(summary.finished, 2U);
}

} // namespace
} // namespace mrpp
