#include "framework/support/Config.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpp
{
namespace
{

std::string complaintOf(const Config &config, bool whole)
{
    try
    {
        whole ? static_cast<void>(config.integer()) : static_cast<void>(config.number());
    }
    catch (const PlanError &error)
    {
        return error.what();
    }
    return "";
}

Config::Entry entry(std::string key, Config value, SourceLocation where = {})
{
    Config::Entry made;
    made.key = std::move(key);
    made.where = std::move(where);
    made.value = std::move(value);
    return made;
}

TEST(Config, IsATreeThatKnowsItsPlaces)
{
    const Config map =
        Config::map({entry("robots", Config::scalar("20", {"plan.yaml", 3, 13}), {"plan.yaml", 3, 5}),
                     entry("names", Config::list({Config::scalar("a"), Config::scalar("b")}))});
    ASSERT_TRUE(map.isMap());
    EXPECT_EQ(map.find("robots")->integer(), 20);
    EXPECT_EQ(map.find("robots")->where().toString(), "plan.yaml:3:13");
    EXPECT_EQ(map.entries()[0].where.toString(), "plan.yaml:3:5");
    EXPECT_EQ(map.find("names")->items()[1].text(), "b");
    EXPECT_EQ(map.find("none"), nullptr);
    EXPECT_EQ(Config().kind(), Config::Kind::empty);
}

TEST(Config, RefusesWhatIsNoNumberAtItsPlace)
{
    EXPECT_EQ(complaintOf(Config::scalar("ten", {"plan.yaml", 7, 9}), false),
              "plan.yaml:7:9: 'ten' is not a number");
    EXPECT_EQ(complaintOf(Config::scalar("2.5", {"plan.yaml", 7, 9}), true),
              "plan.yaml:7:9: '2.5' is not a whole number");
    EXPECT_EQ(complaintOf(Config::list({}, {"plan.yaml", 2, 1}), false), "plan.yaml:2:1: expected a number");
    EXPECT_EQ(complaintOf(Config::map({}), true), "expected a whole number");
    EXPECT_EQ(Config::scalar("2.5").number(), 2.5);
}

TEST(Config, EqualSettingsHaveEqualText)
{
    const Config one = Config::map({entry("b", Config::scalar("5")), entry("a", Config::scalar("x y"))});
    const Config two = Config::map(
        {{"a", {"f", 1, 1}, Config::scalar("x y", {"f", 1, 2})}, {"b", {}, Config::scalar("5.0")}});
    EXPECT_EQ(one.canonical(), R"({"a":"x y","b":"5"})");
    EXPECT_EQ(two.canonical(), one.canonical());
    EXPECT_EQ(Config::list({Config::scalar("1e2"), Config(), Config::map({})}).canonical(),
              R"(["100",null,{}])");
}

TEST(Config, DifferentSettingsHaveDifferentText)
{
    EXPECT_NE(Config::scalar("a").canonical(), Config::scalar("b").canonical());
    EXPECT_NE(Config::list({Config::scalar("1"), Config::scalar("2")}).canonical(),
              Config::list({Config::scalar("2"), Config::scalar("1")}).canonical());
    EXPECT_EQ(Config::scalar("\"\n").canonical(), R"("\"\n")");
}

TEST(Numbers, AreReadWholeOrNotAtAll)
{
    EXPECT_EQ(parseNumber("0.5"), 0.5);
    EXPECT_EQ(parseNumber("+3"), 3);
    EXPECT_EQ(parseNumber("-1e3"), -1000);
    for (const char *text : {"", "+", "1,5", "1 ", " 1", "0x10", "inf", "nan", "1e999", "five", "+-1"})
        EXPECT_EQ(parseNumber(text), std::nullopt) << text;
    EXPECT_EQ(parseInteger("010"), 10) << "no octal numbers";
    EXPECT_EQ(parseInteger("-7"), -7);
    EXPECT_EQ(parseInteger("+7"), 7);
    for (const char *text : {"", "1.0", "1e3", "9223372036854775808", "0x1", "--1", "+-1"})
        EXPECT_EQ(parseInteger(text), std::nullopt) << text;
}

TEST(Numbers, AreWrittenShortestAndReadBackTheSame)
{
    EXPECT_EQ(formatNumber(5), "5");
    EXPECT_EQ(formatNumber(-2), "-2");
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(-0.0), "0");
    EXPECT_EQ(formatNumber(1e14), "100000000000000");
    for (const double value : {0.98, 1.0 / 3, 1e300, -2.5e-8, std::numeric_limits<double>::min()})
        EXPECT_EQ(parseNumber(formatNumber(value)), value);
}

TEST(Error, PutsThePlaceInFront)
{
    const ParseError error({"a.map", 4, 2}, "a row has 5 cells, not 6");
    EXPECT_STREQ(error.what(), "a.map:4:2: a row has 5 cells, not 6");
    EXPECT_EQ(error.complaint(), "a row has 5 cells, not 6");
    EXPECT_EQ(error.where().line, 4U);
    EXPECT_STREQ(InputError(SourceLocation{"a.map", 4, 0}, "x").what(), "a.map:4: x");
    EXPECT_STREQ(InputError(SourceLocation{"a.map", 0, 0}, "x").what(), "a.map: x");
    EXPECT_STREQ(InputError("x").what(), "x");
}

} // namespace
} // namespace mrpp
