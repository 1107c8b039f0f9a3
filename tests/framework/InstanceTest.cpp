#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

Instance onPath(std::vector<Vertex> starts, std::vector<Vertex> goals)
{
    return {Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}}), std::move(starts), std::move(goals)};
}

TEST(Instance, CountsRobotsAndFreeVertices)
{
    const Instance instance = onPath({0, 3}, {1, 2});
    EXPECT_EQ(instance.robotCount(), 2U);
    EXPECT_EQ(instance.freeCount(), 2U);
    EXPECT_EQ(instance.occupancy(), 0.5);
    EXPECT_EQ((Instance{Graph::fromEdges(0, {}), {}, {}}).occupancy(), 0);
}

TEST(Instance, AcceptsGoalsOnOwnAndOtherStarts)
{
    EXPECT_EQ(onPath({0, 1, 2}, {0, 2, 1}).defect(), std::nullopt);
    EXPECT_EQ(onPath({}, {}).defect(), std::nullopt);
}

TEST(Instance, SaysWhatIsMalformed)
{
    EXPECT_EQ((Instance{nullptr, {}, {}}).defect(), "there is no graph");
    EXPECT_EQ(onPath({0, 1}, {2}).defect(), "2 starts but 1 goals");
    EXPECT_EQ(onPath({0, 4}, {1, 2}).defect(),
              "robot 1's start is vertex 4, but the graph's vertices are numbered from 0 to 3");
    EXPECT_EQ(onPath({0, 1}, {1, kNoVertex}).defect(),
              "robot 1's goal is vertex 4294967295, but the graph's vertices are numbered from 0 to 3");
    EXPECT_EQ(onPath({0, 2, 0}, {1, 2, 3}).defect(), "robots 0 and 2 have the same start, vertex 0");
    EXPECT_EQ(onPath({0, 1, 2}, {1, 3, 3}).defect(), "robots 1 and 2 have the same goal, vertex 3");
    EXPECT_EQ((Instance{Graph::fromEdges(0, {}), {0}, {0}}).defect(),
              "robot 0's start is vertex 0, but the graph has no vertices");
}

TEST(Instance, FingerprintDependsOnGraphStartsAndGoals)
{
    EXPECT_EQ(onPath({0, 3}, {1, 2}).fingerprint(), "4fded6ddb5fe54bf33b0cbfebf295156");
    EXPECT_NE(onPath({0, 3}, {2, 1}).fingerprint(), "4fded6ddb5fe54bf33b0cbfebf295156");
    EXPECT_NE(onPath({3, 0}, {1, 2}).fingerprint(), "4fded6ddb5fe54bf33b0cbfebf295156");
    const Instance cycle{Graph::fromEdges(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}), {0, 3}, {1, 2}};
    EXPECT_NE(cycle.fingerprint(), "4fded6ddb5fe54bf33b0cbfebf295156");
}

TEST(MotionRule, NamesReadBack)
{
    EXPECT_EQ(toString(MotionRule::pebble), "pebble");
    EXPECT_EQ(toString(MotionRule::parallel), "parallel");
    EXPECT_EQ(toString(MotionRule::following), "following");
    EXPECT_EQ(toString(MotionRule::rotation), "rotation");
    EXPECT_EQ(motionRule("following"), MotionRule::following);
    EXPECT_EQ(motionRule("Following"), std::nullopt);
    EXPECT_EQ(motionRule(""), std::nullopt);
}

} // namespace
} // namespace mrpp
