#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace mrpp::test
{

namespace
{

using ::testing::StartsWith;

const char *const kGraph = R"(<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<graph edgedefault="undirected">
<node id="a"/>
<node id="b"/>
<node id="c"/>
<edge source="a" target="b"/>
<edge source="b" target="c"/>
</graph>
</graphml>
)";
const char *const kInstance = "graph = g.graphml\nagent: start = 0, goal = 1\nagent: start = 2, goal = 2\n";
const char *const kMap = "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n";
const char *const kScenario = "version 1\n0\tm.map\t3\t2\t0\t0\t2\t0\t2\n";

/// One good file made bad: everything else stays right.
struct BadFile
{
    const char *file; ///< g.graphml, g.instance, m.map, m.scen
    std::string contents;
    const char *place; ///< how the complaint goes on after the file's name
};

std::string replaced(std::string text, const std::string &what, const std::string &by)
{
    return text.replace(text.find(what), what.size(), by);
}

class MalformedInput : public ::testing::TestWithParam<BadFile>
{};

TEST_P(MalformedInput, endsWith2OneLineAndNothingWritten)
{
    const BadFile &bad = GetParam();
    const Scratch scratch;
    scratch.write("g.graphml", kGraph);
    scratch.write("g.instance", kInstance);
    scratch.write("m.map", kMap);
    scratch.write("m.scen", kScenario);
    scratch.write("plan.yaml", "problems:\n  - fully_controlled: {instance: g.instance}\n"
                               "  - public_benchmark: {map: m.map, scenario: m.scen, robots: 1}\n"
                               "planners: [push_and_swap]\n");
    scratch.write(bad.file, bad.contents);
    const auto before = scratch.tree();

    const bool grid = std::string(bad.file).starts_with("m.");
    const std::vector<std::string> question = {"--graph", grid ? "m.map" : "g.graphml", "--instance",
                                               grid ? "m.scen" : "g.instance"};
    std::vector<std::string> solve = {"solve",     "--planner", "push_and_swap", "--solution",
                                      "out/s.csv", "--json",    "out/s.json"};
    solve.insert(solve.end(), question.begin(), question.end());
    for (const std::vector<std::string> &words : {solve, {"run", "plan.yaml"}})
    {
        const Outcome outcome = mrppsim(words, scratch);
        EXPECT_EQ(outcome.code, 2) << words[0] << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "") << words[0];
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_TRUE(std::regex_search(outcome.err, std::regex(std::string(bad.file) + bad.place)))
            << outcome.err;
        EXPECT_EQ(scratch.tree(), before) << words[0];
    }
    EXPECT_FALSE(scratch.has("results"));
    EXPECT_FALSE(scratch.has("out"));
}

INSTANTIATE_TEST_SUITE_P(
    graphs, MalformedInput,
    ::testing::Values(BadFile{"g.graphml", "", ":1:\\d+: "}, BadFile{"g.graphml", "<graphml>", ":1:\\d+: "},
                      BadFile{"g.graphml", "hello", ":1:\\d+: "},
                      BadFile{"g.graphml", replaced(kGraph, "\"a\"/>", "\"a/>"), ":[34]:\\d+: "},
                      BadFile{"g.graphml", replaced(kGraph, "target=\"b\"", "target=\"z\""), ":6:\\d+: .*z"},
                      BadFile{"g.graphml", replaced(kGraph, "id=\"b\"", "id=\"a\""), ":4:\\d+: .*a"},
                      BadFile{"g.graphml", replaced(kGraph, "node id=\"b\"", "node"), ":4:\\d+: "},
                      BadFile{"g.graphml", replaced(kGraph, "source=\"b\" ", ""), ":7:\\d+: "}));

INSTANTIATE_TEST_SUITE_P(
    instances, MalformedInput,
    ::testing::Values(BadFile{"g.instance", "", ":"},
                      BadFile{"g.instance", replaced(kInstance, "start = 0", "start = 3"), ":2:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "start = 0", "start = -1"), ":2:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "start = 0", "start = one"), ":2:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "start = 0", "start = 0.5"), ":2:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "start = 2", "start = 0"), ":3:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "goal = 2", "goal = 1"), ":3:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, ", goal = 1", ""), ":2:\\d+: "},
                      BadFile{"g.instance", replaced(kInstance, "agent", "agnet"), ":2:\\d+: "},
                      BadFile{"g.instance", std::string("graph = g.graphml\n") + kInstance, ":2:\\d+: "}));

INSTANTIATE_TEST_SUITE_P(
    maps, MalformedInput,
    ::testing::Values(BadFile{"m.map", "", ":1"},
                      BadFile{"m.map", replaced(kMap, "height 2", "height two"), ":2:\\d+: "},
                      BadFile{"m.map", replaced(kMap, "height 2", "height 3"), ":\\d+"},
                      BadFile{"m.map", replaced(kMap, "height 2", "height 1"), ":6:\\d+: "},
                      BadFile{"m.map", replaced(kMap, "width 3", "width 4"), ":5:\\d+: "},
                      BadFile{"m.map", replaced(kMap, "width 3\n", ""), ":3:\\d+: "},
                      BadFile{"m.map", replaced(kMap, ".@.", ".@"), ":6:\\d+: "},
                      BadFile{"m.map", replaced(kMap, ".@.", ".@.."), ":6:\\d+: "},
                      BadFile{"m.map", replaced(kMap, ".@.", ".x."), ":6:2: "},
                      BadFile{"m.map", replaced(kMap, "type octile", "tpye octile"), ":1:1: .*type"}));

INSTANTIATE_TEST_SUITE_P(
    scenarios, MalformedInput,
    ::testing::Values(BadFile{"m.scen", "", ":1"},
                      BadFile{"m.scen", replaced(kScenario, "version 1", "version 2"), ":1:\\d+: "},
                      BadFile{"m.scen", replaced(kScenario, "\t2\n", "\n"), ":2:\\d+: "},
                      BadFile{"m.scen", replaced(kScenario, "3\t2\t0\t0", "3\t2\t3\t0"), ":2:\\d+: "},
                      BadFile{"m.scen", replaced(kScenario, "3\t2\t0\t0", "3\t2\t1\t1"), ":2:\\d+: "},
                      BadFile{"m.scen", replaced(kScenario, "3\t2\t0\t0", "9\t2\t0\t0"), ":2:\\d+: "},
                      BadFile{"m.scen", replaced(kScenario, "3\t2\t0\t0", "3\t2\tx\t0"), ":2:\\d+: "}));

class MalformedPlan : public ::testing::TestWithParam<std::pair<const char *, const char *>>
{};

TEST_P(MalformedPlan, endsWith2OneLineAndNothingWritten)
{
    const Scratch scratch;
    scratch.write("plan.yaml", GetParam().first);
    for (const std::vector<std::string> &words : {std::vector<std::string>{"run", "plan.yaml"},
                                                  {"run", "plan.yaml", "--dry-run"},
                                                  {"run", "plan.yaml", "-o", "x"}})
    {
        const Outcome outcome = mrppsim(words, scratch);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_THAT(outcome.err, StartsWith(std::string("plan.yaml:") + GetParam().second));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(scratch.tree().size(), 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(
    all, MalformedPlan,
    ::testing::Values(std::pair("", "1:1: a plan is a map"),
                      std::pair("problems: [", "1:11: this [ is never closed"),
                      std::pair("planners: [push_and_swap]\n", "1:1: the plan has no 'problems'"),
                      std::pair("problems: [small_benchmark: tre]\n", "1:29: parameter 'problem'"),
                      std::pair("problems: [small_benchmrk: tree]\n",
                                "1:12: there is no problem 'small_benchmrk'; did you mean"),
                      std::pair("problems: [public_benchmark: {map: x.map}]\n",
                                "1:30: 'public_benchmark' needs to know"),
                      std::pair("problems: [public_benchmark: {robots: 5}]\n", "1:30: "),
                      std::pair("planners: [push_and_swp]\n",
                                "1:12: there is no planner 'push_and_swp'; did you mean 'push_and_swap'?"),
                      std::pair("planners:\n- planner: push_and_swap\n  set:\n    order: farfirst\n",
                                "4:12: parameter 'order'"),
                      std::pair("seed: 1\nseed: 2\n", "2:1: the key 'seed' stands here a second time"),
                      std::pair("optimizers: [redundancy]\n", "1:14: there is no optimizer 'redundancy'"),
                      std::pair("campaign: ../../etc\n", "1:11: '../../etc' cannot name a campaign")));

TEST(MissingMap, isNamedWithAdvice)
{
    const Scratch scratch;
    scratch.write("plan.yaml",
                  "problems:\n  - public_benchmark: {map: none.map, robots: 2}\nplanners: [push_and_swap]\n");
    const Outcome outcome = mrppsim({"run", "plan.yaml"}, scratch);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith("plan.yaml:2:29: problem 'none': none.map: there is no such map"));
    EXPECT_EQ(scratch.tree().size(), 1U);
}

} // namespace
} // namespace mrpp::test
