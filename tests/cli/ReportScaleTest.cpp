/// \file
/// A small campaign of the shape of large ones, five planners on several sweeps: what its reports take, and
/// that a second time nothing is drawn again but what has changed.

#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sys/resource.h>

namespace mrpp::test
{

namespace
{

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char *kPlan = R"(seed: 7
repetitions: 10
limits: {time: 2 s, memory: 1 GiB}
problems:
  - fg_vr: {graph: {biconnected: {initial_cycle: 5, handles: 2, max_handle_length: 3}}, free: [2, 4]}
  - fg_vr: {graph: {random: {vertices: 20}}, free: [4, 8]}
  - fr_vg: {graph: {grid: {side: [3, 4]}}, occupancy: 0.2}
planners: [push_and_swap, push_and_rotate, push_and_spin, one_blank, bibox]
optimizers: [redundancy_removal]
)";

std::string withTitle(const std::string &title)
{
    return kPlan + ("reports: [charts, layouts, csv, pdf, latex, markdown, "
                    "chart: {x: free, y: time, title: '" +
                    title + "'}, chart: {kind: cactus, y: time}]\n");
}

/// When each picture was written.
std::map<std::string, std::filesystem::file_time_type> pictures(const Scratch &scratch)
{
    std::map<std::string, std::filesystem::file_time_type> times;
    for (const char *folder : {"figures", "layouts"})
        for (const auto &entry : std::filesystem::directory_iterator(scratch.path() / "out" / folder))
            if (const auto kind = entry.path().extension();
                kind == ".png" || kind == ".svg" || kind == ".pdf")
                times[entry.path().filename()] = entry.last_write_time();
    return times;
}

/// Of `mrppsim run`, which has nothing to run any more, and all that it starts: seconds of all cores.
double reportingTime(const Scratch &scratch)
{
    const auto spent = []
    {
        rusage usage{};
        ::getrusage(RUSAGE_CHILDREN, &usage);
        const auto seconds = [](const timeval &time)
        { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
        return seconds(usage.ru_utime) + seconds(usage.ru_stime);
    };
    const double start = spent();
    const Outcome outcome = mrppsim({"run", "plan.yaml", "-o", "out"}, scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("300 runs (0 now, 300 before)"));
    return spent() - start;
}

TEST(Reports, DrawOnlyWhatChangedAndInGoodTime)
{
    const Scratch scratch;
    scratch.write("plan.yaml", withTitle("one"));
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "out", "--no-report"}, scratch).code, 0);
    const double first = reportingTime(scratch);
    const auto drawn = pictures(scratch);
    EXPECT_LT(first, 0.15 * static_cast<double>(drawn.size())); // of each picture three files

    EXPECT_LT(reportingTime(scratch), first / 3);
    EXPECT_EQ(pictures(scratch), drawn);

    scratch.write("plan.yaml", withTitle("another"));
    EXPECT_LT(reportingTime(scratch), first / 3);
    std::set<std::string> changed;
    for (const auto &[name, time] : pictures(scratch))
        if (const auto before = drawn.find(name); before == drawn.end() || before->second != time)
            changed.insert(name);
    EXPECT_EQ(changed.size(), 3U);
    EXPECT_THAT(changed, Each(StartsWith("chart-curves")));

    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    EXPECT_LT(usage.ru_maxrss, 500'000) << "kB at most of any process";
}

} // namespace
} // namespace mrpp::test
