/// \file
/// Limits and Ctrl-C on a large instance: nothing that grows with robots and vertices holds the program up.

#include "cli/WorkLine.h"
#include "framework/support/Random.h"
#include "tests/cli/Program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>
#include <sys/resource.h>
#include <thread>

namespace mrpp::test
{
namespace
{

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr std::size_t kSide = 100;
constexpr double kSlower = 20;
#else
constexpr std::size_t kSide = 500;
constexpr double kSlower = 1;
#endif

/// Processor time of all processes that have ended: other work on the machine does not count.
double childrensSeconds()
{
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval &time)
    { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// An open map and a scenario in which every tenth cell is a start.
class LargeScenario : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string map =
            "type octile\nheight " + std::to_string(kSide) + "\nwidth " + std::to_string(kSide) + "\nmap\n";
        for (std::size_t y = 0; y < kSide; ++y)
            map += std::string(kSide, '.') + "\n";
        scratch_.write("open.map", map);
        Random random(1);
        std::vector<std::size_t> starts(kSide * kSide);
        std::iota(starts.begin(), starts.end(), 0U);
        std::vector<std::size_t> goals = starts;
        random.shuffle(std::span(starts));
        random.shuffle(std::span(goals));
        std::ostringstream scenario;
        scenario << "version 1\n";
        for (std::size_t r = 0; r < kSide * kSide / 10; ++r)
            scenario << "0\topen.map\t" << kSide << '\t' << kSide << '\t' << starts[r] % kSide << '\t'
                     << starts[r] / kSide << '\t' << goals[r] % kSide << '\t' << goals[r] / kSide << "\t1\n";
        scratch_.write("open.scen", scenario.str());
    }

    static std::vector<std::string> solve(const std::string &planner, const std::string &limit)
    {
        return {"solve",        "--instance", "open.scen", "--planner",    planner, "--solution",
                "solution.csv", "--json",     "s.json",    "--time-limit", limit};
    }

    Scratch scratch_;
};

TEST_F(LargeScenario, EndsSoonAfterItsTimeLimit)
{
    for (const char *planner : {"push_and_swap", "push_and_rotate", "push_and_spin", "mapp"})
    {
        const double before = childrensSeconds();
        const Outcome outcome = mrppsim(solve(planner, "0.4"), scratch_);
        EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.err;
        EXPECT_LT(childrensSeconds() - before, 2 * kSlower) << planner; // reading takes some of it
        EXPECT_THAT(scratch_.read("s.json"), testing::HasSubstr("\"path_length_bound_name\": \""));
    }
}

TEST_F(LargeScenario, EndsAtOnceWhenItIsInterruptedAtAnyMoment)
{
    Random random(7);
    for (int i = 0; i < 10; ++i)
    {
        Process process(mrppsimWords(solve(i % 2 == 0 ? "push_and_rotate" : "mapp", "30")), scratch_);
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + random.below(1500)));
        process.signal(SIGINT);
        const Clock::time_point start = Clock::now();
        const Outcome outcome = process.wait();
        EXPECT_TRUE(outcome.code == 130 || outcome.code == -SIGINT)
            << outcome.code << outcome.err;          // before main()
        EXPECT_LT(secondsSince(start), 3 * kSlower); // 0.2 s on a quiet machine; a bound once took a minute
        for (const auto &[name, contents] : scratch_.tree())
            EXPECT_FALSE(name.starts_with("solution.csv") || name.starts_with("s.json")) << name;
    }
}

TEST_F(LargeScenario, AConversionThatIsInterruptedLeavesNothing)
{
    Process process(mrppsimWords({"convert", "open.scen", "again.scen"}), scratch_);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    process.signal(SIGTERM);
    const Outcome outcome = process.wait();
    if (outcome.code == 0)
        GTEST_SKIP() << "was over already";
    EXPECT_EQ(outcome.code, 130);
    for (const auto &[name, contents] : scratch_.tree())
        EXPECT_FALSE(name.find("again") != std::string::npos) << name;
}

TEST(WorkLine, SaysNothingForTwoSecondsAndNothingWhereThereIsNoTerminal)
{
    std::ostringstream out;
    {
        WorkLine line(out, true);
        line.listener()("lower bounds", 1, 100);
    }
    EXPECT_EQ(out.str(), "");
    EXPECT_FALSE(WorkLine(out, false).listener());
}

TEST(WorkLine, ShowsAfterTwoSecondsHowMuchIsDoneAndGoesAway)
{
    std::ostringstream out;
    {
        WorkLine line(out, true);
        std::this_thread::sleep_for(std::chrono::milliseconds(2050));
        line.listener()("lower bounds", 42, 100);
        EXPECT_EQ(out.str(), "\rlower bounds: 42 of 100");
    }
    EXPECT_EQ(out.str(), "\rlower bounds: 42 of 100\r                       \r");
}

} // namespace
} // namespace mrpp::test
