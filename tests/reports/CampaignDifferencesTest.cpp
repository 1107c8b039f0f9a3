#include "reports/summary/CampaignDifferences.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;
using ::testing::ElementsAre;

FakeCampaign campaign()
{
    FakeCampaign made("versions", 2);
    made.planner("P").planner("Q").problem("m", "p", treeInstance());
    made.plan().limits.time = 60;
    return made;
}

TEST(CampaignDifferences, OfTheSameAreNone)
{
    FakeCampaign same = campaign();
    EXPECT_THAT(campaignDifferences({same.plan(), fakeProvenance(), {}}, {same.plan(), fakeProvenance(), {}}),
                ElementsAre());
}

TEST(CampaignDifferences, NameLimitsSettingsAndRulesFirst)
{
    FakeCampaign before = campaign();
    FakeCampaign now = campaign();
    now.plan().limits.time = 0.003;
    now.plan().planners[0].settings = {{"restarts", "20"}};
    now.plan().planners[1].motion = MotionRule::rotation;
    now.plan().execution.jobs = 4;
    Provenance elsewhere = fakeProvenance();
    elsewhere.host = "laptop";
    EXPECT_THAT(campaignDifferences({before.plan(), fakeProvenance(), {}}, {now.plan(), elsewhere, {}}),
                ElementsAre("time limit: 60 before, 0.003 now",
                            "parameter restarts: not recorded before, 20 now (P)",
                            "motion rule of its solutions: pebble before, rotation now (Q)",
                            "jobs: 1 before, 4 now", "host: workstation before, laptop now"));
}

TEST(CampaignDifferences, AreWhatTheStoresWroteDownOfTheirRuns)
{
    // The plans say the same, and the program had another default.
    FakeCampaign same = campaign();
    const AskedParts before{
        {{"m/p", {{"memory limit", "4096"}, {"input files", "abc"}}}, {"m/gone", {{"x", "1"}}}},
        {{"P", {{"parameter order", "given"}, {"algorithm version", "1"}}}, {"Q", {}}}};
    const AskedParts now{{{"m/p", {{"memory limit", "4096"}, {"input files", "def"}}}},
                         {{"P", {{"parameter order", "far_first"}, {"algorithm version", "2"}}}, {"Q", {}}}};
    EXPECT_THAT(
        campaignDifferences({same.plan(), fakeProvenance(), before}, {same.plan(), fakeProvenance(), now}),
        ElementsAre("input files: others", "parameter order: given before, far_first now (P)",
                    "algorithm version: 1 before, 2 now (P)"));
}

} // namespace
} // namespace mrpp
