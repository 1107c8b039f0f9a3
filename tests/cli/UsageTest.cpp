#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

TEST(Usage, helpTeachesOnEveryLevel)
{
    const Scratch scratch;
    for (const std::vector<std::string> &words : {std::vector<std::string>{"--help"},
                                                  {"run", "--help"},
                                                  {"report", "--help"},
                                                  {"solve", "--help"},
                                                  {"validate", "--help"},
                                                  {"check", "--help"},
                                                  {"generate", "--help"},
                                                  {"list", "--help"}})
    {
        const Outcome outcome = mrppsim(words, scratch);
        EXPECT_EQ(outcome.code, 0) << words[0];
        EXPECT_THAT(outcome.out, HasSubstr("Examples:")) << words[0];
        EXPECT_EQ(outcome.err, "") << words[0];
    }
    EXPECT_EQ(mrppsim({"--version"}, scratch).out.substr(0, 8), "mrppsim ");
}

struct WrongUse
{
    std::vector<std::string> words;
    const char *complaint;
};

class WrongUseTest : public ::testing::TestWithParam<WrongUse>
{};

TEST_P(WrongUseTest, endsWith2AndOneLine)
{
    const Scratch scratch;
    const Outcome outcome = mrppsim(GetParam().words, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(GetParam().complaint));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(scratch.tree().empty());
}

INSTANTIATE_TEST_SUITE_P(
    all, WrongUseTest,
    ::testing::Values(
        WrongUse{{"rnu"}, "there is no command 'rnu'; did you mean 'run'?"},
        WrongUse{{"--verison"}, "there is no option '--verison'; did you mean '--version'?"},
        WrongUse{{"run"}, "PLAN is required"},
        WrongUse{{"run", "none.yaml"}, "none.yaml: there is no such file"},
        WrongUse{{"run", "."}, "is a folder"},
        WrongUse{{"run", "a.yaml", "b.yaml"}, "'b.yaml' is one argument too many"},
        WrongUse{{"run", "a.yaml", "--jobz", "2"}, "did you mean '--jobs'?"},
        WrongUse{{"run", "a.yaml", "--jobs", "0"}, "'0' is not a whole number from 1 on"},
        WrongUse{{"run", "a.yaml", "--jobs", "many"}, "'many' is not a whole number"},
        WrongUse{{"run", "a.yaml", "--shard", "3/2"}, "'3/2' is no part i/n"},
        WrongUse{{"run", "a.yaml", "--shard", "0/2"}, "'0/2' is no part i/n"},
        WrongUse{{"run", "a.yaml", "--shard", "1"}, "'1' is no part i/n"},
        WrongUse{{"report", "nowhere"}, "nowhere: is no campaign's folder"},
        WrongUse{{"solve"}, "--instance is required"},
        WrongUse{{"solve", "--instance", "a.instance"}, "--planner is required"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swp"},
                 "there is no planner 'push_and_swp'; did you mean 'push_and_swap'?"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--set", "ordr=given"},
                 "there is no parameter 'ordr'; did you mean 'order'?"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--set", "order"},
                 "'order' is not of the form name=value"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--set", "attempts=-1"},
                 "parameter 'attempts' must lie in"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--time-limit", "0"},
                 "'0' is not a number above 0"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--optimizer", "magic"},
                 "there is no optimizer 'magic'"},
        WrongUse{{"solve", "--instance", "a", "--planner", "push_and_swap", "--motion", "pebbel"},
                 "did you mean 'pebble'?"},
        WrongUse{{"solve", "--instance", "no.instance", "--planner", "push_and_swap"},
                 "no.instance: there is no such file"},
        WrongUse{{"validate", "--instance", "a"}, "--solution is required"},
        WrongUse{{"check"}, "--instance is required"}, WrongUse{{"generate"}, "A subcommand is required"},
        WrongUse{{"generate", "gird"}, "there is no 'gird' to generate; did you mean 'grid'?"},
        WrongUse{{"generate", "gird", "--help"}, "there is no 'gird' to generate; did you mean 'grid'?"},
        WrongUse{{"generate", "tree", "--graph", "t.graphml", "--robots", "1", "--instance", "t.scen"},
                 "no grid map"},
        WrongUse{{"generate", "grid", "--side", "3", "--graph", "g.map", "--robots", "1", "--instance", "."},
                 "it is a folder"},
        WrongUse{{"generate", "grid", "--side", "3", "--graph", "g", "--robots", "1", "--instance", "./g"},
                 "is to be written twice"},
        WrongUse{{"generate", "grid", "--obstacle", "3"},
                 "there is no option '--obstacle'; did you mean '--obstacles'?"},
        WrongUse{{"generate", "grid", "--side", "many"}, "parameter 'side' takes a whole number"},
        WrongUse{{"generate", "grid", "--side", "-1"}, "parameter 'side' must lie in 0:10000"},
        WrongUse{{"generate", "grid", "--side", "3", "--width", "3"}, "either a side, or width and height"},
        WrongUse{{"generate", "grid", "--side", "3", "--robots", "3"}, "--robots requires --instance"},
        WrongUse{{"generate", "grid", "--instance", "a.instance", "--graph", "a.map"},
                 "--instance requires --robots"},
        WrongUse{{"generate", "grid", "--side", "2", "--robots", "5", "--instance", "a.instance", "--graph",
                  "a.map"},
                 "5 robots do not fit"},
        WrongUse{{"generate", "tree", "--graph", "tree.map"}, "map"}, WrongUse{{"list"}, "WHAT is required"},
        WrongUse{{"list", "planer"}, "did you mean 'planners'?"}));

TEST(Usage, withoutAWordTheHelpIsAComplaint)
{
    const Scratch scratch;
    const Outcome outcome = mrppsim({}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("Usage: mrppsim"));
}

TEST(List, saysTheSameToPeopleAndScripts)
{
    const Scratch scratch;
    for (const char *what : {"planners", "optimizers", "problems", "reports", "metrics", "formats"})
    {
        const Outcome text = mrppsim({"list", what}, scratch);
        const Outcome json = mrppsim({"list", what, "--json"}, scratch);
        EXPECT_EQ(text.code, 0);
        ASSERT_EQ(json.code, 0);
        const auto items = nlohmann::json::parse(json.out);
        ASSERT_TRUE(items.is_array());
        ASSERT_FALSE(items.empty()) << what;
        for (const auto &item : items)
        {
            EXPECT_THAT(text.out, HasSubstr(item.at("name").get<std::string>()));
            EXPECT_FALSE(item.at("description").get<std::string>().empty());
        }
    }
}

TEST(List, plannersHaveCitationsAndParametersWithRanges)
{
    const Scratch scratch;
    for (const auto &planner : nlohmann::json::parse(mrppsim({"list", "planners", "--json"}, scratch).out))
    {
        EXPECT_FALSE(planner.at("citation").get<std::string>().empty());
        EXPECT_FALSE(planner.at("motion").get<std::string>().empty());
        for (const auto &parameter : planner.at("parameters"))
            for (const char *key : {"name", "type", "range", "default", "help"})
                EXPECT_TRUE(parameter.at(key).is_string());
    }
}

} // namespace
} // namespace mrpp::test
