#include "reports/layouts/FramesPicture.h"
#include "framework/system/File.h"
#include "framework/system/TemporaryFolder.h"
#include "reports/picture/Process.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using ::testing::HasSubstr;
using namespace mrpp::testing;

Picture drawn(const Instance &instance, const Solution &solution)
{
    return drawFrames(instance, solution, placeGraph(*instance.graph), "<b>title</b> 漢 \\N");
}

/// Every robot of a grid goes down one row after another, and nobody but the last row's is at its goal.
Solution marchDown(const Instance &instance, std::size_t side)
{
    Solution solution;
    for (std::size_t row = 0; row + 1 < side; ++row)
        for (Robot robot = 0; robot < instance.robotCount(); ++robot)
        {
            const auto from = static_cast<Vertex>(instance.starts[robot] + row * side);
            solution.append({robot, from, static_cast<Vertex>(from + side)});
        }
    return solution;
}

TEST(KeySteps, AreStartEndAndTheBestMomentsBetween)
{
    using Steps = std::vector<std::size_t>;
    EXPECT_EQ(keySteps({2}, 6), Steps({0}));
    EXPECT_EQ(keySteps({0, 1, 2}, 6), Steps({0, 1, 2}));
    EXPECT_EQ(keySteps({0, 1, 0, 0, 1, 3}, 6), Steps({0, 1, 2, 3, 4, 5}));
    // Three parts: 1 … 3, 4 … 6, and the last one, which the end stands for.
    EXPECT_EQ(keySteps({0, 0, 2, 1, 1, 1, 1, 2, 2, 3}, 4), Steps({0, 2, 6, 9}));
}

TEST(FramesPicture, CaptionsEveryFrame)
{
    const TemporaryFolder folder;
    const Solution solution({{0, 1, 0},
                             {1, 4, 3},
                             {1, 3, 1},
                             {1, 1, 2},
                             {0, 0, 1},
                             {0, 1, 3},
                             {2, 6, 4},
                             {2, 4, 5},
                             {0, 3, 4},
                             {0, 4, 6},
                             {1, 2, 1},
                             {2, 5, 4}});
    writeFile(folder.path() / "frames.pdf", drawn(treeInstance(), solution).pdf);
    const auto text =
        runProcess({"pdftotext", "frames.pdf", "frames.txt"}, folder.path(), std::chrono::seconds(60));
    ASSERT_TRUE(text.succeeded()) << text.output;
    const std::string words = readFile(folder.path() / "frames.txt");
    EXPECT_THAT(words, HasSubstr("start\n0 of 3 at goal"));
    EXPECT_THAT(words, HasSubstr("end, step 6\n3 of 3 at goal"));
    EXPECT_THAT(words, HasSubstr("<b>title</b>"));
    EXPECT_THAT(words, HasSubstr("\\N"));
}

TEST(FramesPicture, DrawsGridsOfAnySizeAndGivesTheSameBytesAgain)
{
    for (const std::size_t side : {5UL, 40UL, 150UL})
    {
        const Instance instance = gridInstance(side, side / 2);
        const Solution solution = marchDown(instance, side);
        const Picture first = drawn(instance, solution);
        const Picture second = drawn(instance, solution);
        EXPECT_EQ(first.pdf, second.pdf);
        EXPECT_EQ(first.svg, second.svg);
        EXPECT_EQ(first.png, second.png);
        EXPECT_LT(first.svg.size(), 3'000'000U);
    }
}

TEST(FramesPicture, RefusesLargeGraphsThatAreNoGrids)
{
    const Instance grid = gridInstance(71, 1);
    std::vector<Graph::Edge> edges = grid.graph->edges();
    edges.push_back({0, 72});
    const Instance instance{
        Graph::fromEdges(71 * 71, edges,
                         {grid.graph->coordinates().begin(), grid.graph->coordinates().end()}),
        {0},
        {72}};
    EXPECT_THROW((void)drawn(instance, Solution({{0, 0, 72}})), DrawingError);
}

} // namespace
} // namespace mrpp
