#include "framework/store/Provenance.h"

#include "framework/support/Error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using testing::HasSubstr;
using testing::StartsWith;

TEST(Provenance, KnowsThisProgramAndMachine)
{
    const Provenance here = Provenance::here();
    EXPECT_THAT(here.version, HasSubstr("."));
    EXPECT_FALSE(here.buildType.empty());
    EXPECT_FALSE(here.host.empty());
    EXPECT_THAT(here.system, StartsWith("Linux "));
    EXPECT_GE(here.cores, 1);
    EXPECT_GT(here.memory, 100);
    ASSERT_EQ(here.libraries.size(), 5U);
    EXPECT_THAT(here.libraries[0], StartsWith("Boost 1."));
    EXPECT_THAT(here.libraries[1], StartsWith("SQLite 3."));
    EXPECT_EQ(here.started, "");
}

TEST(Provenance, ComesBackFromItsFile)
{
    Provenance provenance = Provenance::here();
    provenance.campaign = "a \"campaign\"\nof two lines";
    provenance.seed = 9007199254740993; // more than a double can hold
    provenance.started = "2026-01-02T03:04:05Z";
    const Provenance copy = Provenance::fromJson(provenance.toJson(), "provenance.json");
    EXPECT_EQ(copy.toJson(), provenance.toJson());
    EXPECT_EQ(copy.campaign, provenance.campaign);
    EXPECT_EQ(copy.seed, 9007199254740993);
    EXPECT_EQ(copy.libraries, provenance.libraries);
}

TEST(Provenance, RefusesOtherFiles)
{
    EXPECT_THROW((void)Provenance::fromJson("{}", "p.json"), ParseError);
    EXPECT_THROW((void)Provenance::fromJson("not json", "p.json"), ParseError);
    EXPECT_THROW((void)Provenance::fromJson("", "p.json"), ParseError);
}

} // namespace
} // namespace mrpp
