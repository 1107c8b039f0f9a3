#include "cli/ProgressLine.h"
#include "cli/KeptFiles.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mrpp
{

namespace
{

TEST(ProgressLine, saysCountsAndAnEstimate)
{
    EXPECT_EQ(progressText({{PlannerStatus::solved, 10}, {PlannerStatus::timeout, 2}}, 12, 40, 64.2),
              "12/40 runs, timeout 2, solved 10, 1 min 5 s left");
    EXPECT_EQ(progressText({{PlannerStatus::solved, 40}}, 40, 40, 0), "40/40 runs, solved 40");
}

TEST(ProgressLine, durationsArePlain)
{
    EXPECT_EQ(durationText(0.2), "1 s");
    EXPECT_EQ(durationText(59), "59 s");
    EXPECT_EQ(durationText(60), "1 min 0 s");
    EXPECT_EQ(durationText(7380), "2 h 3 min");
    EXPECT_EQ(durationText(-1), "0 s");
}

TEST(ProgressLine, rewritesItsLineAndEndsWithTheLastState)
{
    std::ostringstream out;
    {
        ProgressLine line(out, ProgressLine::Mode::terminal);
        line.update(PlannerStatus::solved, 1, 3, 100);
        line.update(PlannerStatus::solved, 2, 3, 50);
        line.update(PlannerStatus::timeout, 3, 3, 0);
    }
    EXPECT_EQ(out.str(), "\r1/3 runs, solved 1, 1 min 40 s left\r3/3 runs, timeout 1, solved 2      \n");
}

TEST(ProgressLine, isSilentWhereAsked)
{
    std::ostringstream out;
    {
        ProgressLine quiet(out, ProgressLine::Mode::quiet);
        quiet.update(PlannerStatus::solved, 1, 3, 100);
        ProgressLine lines(out, ProgressLine::Mode::lines);
        lines.update(PlannerStatus::solved, 1, 3, 100);
    }
    EXPECT_EQ(out.str(), "");
}

TEST(FileSafe, keepsPlainNamesAndTellsOthersApart)
{
    EXPECT_EQ(fileSafe("push_and_swap-2"), "push_and_swap-2");
    EXPECT_NE(fileSafe("a b"), fileSafe("a_b"));
    EXPECT_NE(fileSafe("a b"), fileSafe("a/b"));
    for (const char *name : {".", "..", "a/b", "`x`", "a\nb", "ü"})
    {
        const std::string safe = fileSafe(name);
        EXPECT_EQ(safe.find_first_of("/`\n$' "), std::string::npos);
        EXPECT_NE(safe, name);
    }
    EXPECT_LE(fileSafe(std::string(500, 'a')).size(), 70U);
}

} // namespace
} // namespace mrpp
