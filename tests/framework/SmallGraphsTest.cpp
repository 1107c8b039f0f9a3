#include "tests/support/SmallGraphs.h"

#include "framework/analysis/Components.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp::test
{
namespace
{

using ::testing::ElementsAre;

TEST(SmallGraphs, AreAsManyAsThereAre)
{
    // The sequence A001349.
    std::vector<std::size_t> counts;
    for (std::size_t n = 1; n <= 7; ++n)
        counts.push_back(connectedGraphs(n).size());
    EXPECT_THAT(counts, ElementsAre(1, 1, 2, 6, 21, 112, 853));
}

TEST(SmallGraphs, AreConnected)
{
    for (const auto &graph : connectedGraphs(6))
    {
        EXPECT_EQ(graph->vertexCount(), 6U);
        EXPECT_EQ(Components(*graph).count(), 1U);
    }
}

TEST(SmallGraphs, HaveTheirCycles)
{
    // A square with a diagonal: two triangles and the square.
    const auto cycles = simpleCycles(*Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}));
    EXPECT_THAT(cycles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 1, 2, 3), ElementsAre(0, 2, 3)));
    // K5 has 10 triangles, 15 squares and 12 pentagons.
    EXPECT_EQ(
        simpleCycles(*Graph::fromEdges(
                         5, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}))
            .size(),
        37U);
}

TEST(SmallGraphs, OrbitsAreThePlacesThatRobotsReach)
{
    // A star with arms 1, 2, 3: with two free vertices the robots on 1 and 2 can change places, with one they
    // cannot.
    const auto star = Graph::fromEdges(4, {{0, 1}, {0, 2}, {0, 3}});
    const std::vector<Vertex> orbits = positionOrbits(*star, MotionRule::pebble);
    EXPECT_EQ(orbits[0b0110 * 4 + 2], 1U);
    EXPECT_EQ(orbits[0b0111 * 4 + 2], 2U);
    const auto triangle = Graph::fromEdges(3, {{0, 1}, {1, 2}, {2, 0}});
    EXPECT_EQ(positionOrbits(*triangle, MotionRule::pebble)[0b111 * 3 + 2], 2U);
    EXPECT_EQ(positionOrbits(*triangle, MotionRule::rotation)[0b111 * 3 + 2], 0U);
}

} // namespace
} // namespace mrpp::test
