#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

const std::string kData = std::string(MRPP_SOURCE_DIR) + "/problems/data/";

TEST(Check, aTreeWithCycleLeavesNeedsRotations)
{
    const Scratch scratch;
    const std::string instance = kData + "tree_with_cycle_leaves.instance";
    const Outcome pebble = mrppsim({"check", "--instance", instance}, scratch);
    EXPECT_EQ(pebble.code, 1);
    EXPECT_EQ(pebble.err, "");
    EXPECT_THAT(pebble.out,
                ::testing::MatchesRegex("unsolvable: robots [0-9]+ and [0-9]+ cannot pass each other in the "
                                        "corridor [0-9]+–[0-9]+: it needs 7 free vertices, there are "
                                        "6\n"));
    const Outcome rotation = mrppsim({"check", "--instance", instance, "--motion", "rotation"}, scratch);
    EXPECT_EQ(rotation.code, 0);
    EXPECT_EQ(rotation.out, "solvable\n");
}

TEST(Check, answersAsJson)
{
    const Scratch scratch;
    const Outcome outcome = mrppsim({"check", "--graph", kData + "polygon.graphml", "--instance",
                                     kData + "polygon.instance", "--robots", "1", "--json"},
                                    scratch);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("solvable"), true);
    EXPECT_EQ(json.at("reason"), "");
    EXPECT_EQ(json.at("motion"), "pebble");
    EXPECT_EQ(json.at("robots"), 1);
    EXPECT_EQ(json.at("free").get<int>(), json.at("vertices").get<int>() - 1);
}

TEST(Check, namesRobotsThatWouldHaveToPassEachOther)
{
    const Scratch scratch;
    scratch.write("line.graphml",
                  R"(<graphml xmlns="http://graphml.graphdrawing.org/xmlns"><graph edgedefault="undirected">
<node id="a"/><node id="b"/><node id="c"/><edge source="a" target="b"/><edge source="b" target="c"/></graph></graphml>)");
    scratch.write("line.instance",
                  "graph = line.graphml\nagent: start = 0, goal = 2\nagent: start = 1, goal = 0\n");
    const Outcome outcome = mrppsim({"check", "--instance", "line.instance", "--json"}, scratch);
    EXPECT_EQ(outcome.code, 1);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("solvable"), false);
    EXPECT_EQ(json.at("reason"), "robots 0 and 1 cannot pass each other on the path 0–2");
}

TEST(Check, malformedInputIsRefused)
{
    const Scratch scratch;
    EXPECT_EQ(mrppsim({"check", "--instance", "nowhere.instance"}, scratch).code, 2);
    scratch.write("bad.instance", "graph = " + kData + "theta.graphml\nagent: start = 0, goal = 999\n");
    const Outcome outcome = mrppsim({"check", "--instance", "bad.instance"}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("bad.instance:2"));
    EXPECT_EQ(mrppsim({"check", "--instance", "bad.instance", "--motion", "rotate"}, scratch).code, 2);
}

} // namespace

} // namespace mrpp::test
