#include "yaml/Sweep.h"
#include "tests/yaml/TestCatalog.h"
#include "yaml/YamlConfig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpp
{

namespace
{

using ::testing::ElementsAre;

std::vector<std::string> values(const std::string &range)
{
    std::vector<std::string> texts;
    for (const Config &value : rangeValues(parseYaml(range, "p")))
        texts.push_back(value.text());
    return texts;
}

/// "name variable=value settings" of each point of `family: settings`.
std::vector<std::string> points(const std::string &family, const std::string &settings)
{
    const Catalog catalog = test::makeCatalog();
    std::vector<std::string> lines;
    for (const ProblemPoint &point :
         expandProblem(family, {"p", 1, 1}, parseYaml(settings, "p"), {&catalog, {}}))
        lines.push_back(point.name + " " + point.sweepVariable + "=" +
                        (point.sweepValue ? formatNumber(*point.sweepValue) : "") + " " + point.settings);
    return lines;
}

std::string complaint(const std::string &family, const std::string &settings)
{
    try
    {
        return "read as " + std::to_string(points(family, settings).size()) + " points";
    }
    catch (const PlanError &error)
    {
        return error.what();
    }
}

TEST(Range, wholeNumbersStayWholeAndTheEndIsIncluded)
{
    EXPECT_THAT(values("{from: 2, to: 10, step: 4}"), ElementsAre("2", "6", "10"));
    EXPECT_THAT(values("{from: 2, to: 9, step: 4}"), ElementsAre("2", "6"));
    EXPECT_THAT(values("{from: 3, to: 3, step: 1}"), ElementsAre("3"));
    EXPECT_THAT(values("{from: -4, to: 0, step: 2}"), ElementsAre("-4", "-2", "0"));
}

TEST(Range, realStepsDoNotDrift)
{
    EXPECT_THAT(values("{from: 0.1, to: 0.5, step: 0.1}"), ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5"));
    EXPECT_THAT(values("{from: 0.9, to: 1, step: 0.02}"),
                ElementsAre("0.9", "0.92", "0.94", "0.96", "0.98", "1"));
    EXPECT_EQ(values("{from: 0, to: 1, step: 0.001}").size(), 1001U);
    EXPECT_EQ(values("{from: 0, to: 1, step: 0.001}")[777], "0.777");
}

TEST(Range, factorsMultiply)
{
    EXPECT_THAT(values("{from: 10, to: 100, factor: 2}"), ElementsAre("10", "20", "40", "80"));
    EXPECT_THAT(values("{from: 1, to: 1000, factor: 10}"), ElementsAre("1", "10", "100", "1000"));
    EXPECT_THAT(values("{from: 0.1, to: 0.4, factor: 2}"), ElementsAre("0.1", "0.2", "0.4"));
}

TEST(Range, extremesNeitherOverflowNorHang)
{
    EXPECT_EQ(values("{from: 9223372036854775806, to: 9223372036854775807, step: 1}").size(), 2U);
    EXPECT_THROW((void)values("{from: -9223372036854775808, to: 9223372036854775807, step: 1}"), PlanError);
    EXPECT_THROW((void)values("{from: 0, to: 1, step: 1e-300}"), PlanError);
    EXPECT_THROW((void)values("{from: 1, to: 2, factor: 1.000000000000001}"), PlanError);
    EXPECT_EQ(values("{from: 1, to: 1000000, step: 1}").size(), 1'000'000U);
    EXPECT_THROW((void)values("{from: 0, to: 1000000, step: 1}"), PlanError);
}

RC_GTEST_PROP(Range, hasEveryStepBetweenItsEndsAndNothingElse, ())
{
    const auto from = *rc::gen::inRange(-1000, 1000);
    const auto to = from + *rc::gen::inRange(0, 1000);
    const auto step = *rc::gen::inRange(1, 50);
    std::vector<std::string> expected;
    for (int value = from; value <= to; value += step)
        expected.push_back(std::to_string(value));
    RC_ASSERT(values("{from: " + std::to_string(from) + ", to: " + std::to_string(to) +
                     ", step: " + std::to_string(step) + "}") == expected);
}

TEST(ExpandProblem, withoutSweepThereIsOnePoint)
{
    EXPECT_THAT(points("puzzle", "tunnel"), ElementsAre("tunnel = \"tunnel\""));
    EXPECT_THAT(points("puzzle", ""), ElementsAre("tree = {}"));
    EXPECT_THAT(points("ladder", "{rungs: 5, robots: 3}"),
                ElementsAre(R"(ladder = {"robots":"3","rungs":"5"})"));
}

TEST(ExpandProblem, aListAsAFamilysValueMakesSeveralProblems)
{
    EXPECT_THAT(points("puzzle", "[tunnel, {problem: string}]"),
                ElementsAre("tunnel = \"tunnel\"", R"(string = {"problem":"string"})"));
}

TEST(ExpandProblem, theNumberOfRobotsIsTheAxisOfAFixedGraph)
{
    EXPECT_THAT(points("map", "{map: a.map, robots: [5, 10]}"),
                ElementsAre(R"(a robots=5 {"map":"a.map","robots":"5"})",
                            R"(a robots=10 {"map":"a.map","robots":"10"})"));
    EXPECT_THAT(points("ladder", "{rungs: [4, 8], free: {from: 1, to: 2, step: 1}}"),
                ElementsAre(R"(ladder rungs=4 free=1 {"free":"1","rungs":"4"})",
                            R"(ladder rungs=4 free=2 {"free":"2","rungs":"4"})",
                            R"(ladder rungs=8 free=1 {"free":"1","rungs":"8"})",
                            R"(ladder rungs=8 free=2 {"free":"2","rungs":"8"})"));
}

TEST(ExpandProblem, textsMakeProblemsOfTheirOwn)
{
    EXPECT_THAT(points("map", "{map: [a.map, b.map], robots: [5, 10]}"),
                ElementsAre(R"(a robots=5 {"map":"a.map","robots":"5"})",
                            R"(a robots=10 {"map":"a.map","robots":"10"})",
                            R"(b robots=5 {"map":"b.map","robots":"5"})",
                            R"(b robots=10 {"map":"b.map","robots":"10"})"));
    EXPECT_THAT(points("map", "{map: a.map, passable: [movingai, strict], robots: 5}"),
                ElementsAre(R"(a passable=movingai = {"map":"a.map","passable":"movingai","robots":"5"})",
                            R"(a passable=strict = {"map":"a.map","passable":"strict","robots":"5"})"));
}

TEST(ExpandProblem, aParameterOfTheGraphIsTheAxisWhereTheFamilyVariesGraphs)
{
    EXPECT_THAT(points("growing", "{graph: {square: {side: {from: 2, to: 4, step: 2}}}, occupancy: 0.5}"),
                ElementsAre(R"(square side=2 {"graph":{"square":{"side":"2"}},"occupancy":"0.5"})",
                            R"(square side=4 {"graph":{"square":{"side":"4"}},"occupancy":"0.5"})"));
    EXPECT_THAT(
        points("growing", "{occupancy: [0.5, 0.9], graph: {square: {side: [2, 4]}}}"),
        ElementsAre(R"(square occupancy=0.5 side=2 {"graph":{"square":{"side":"2"}},"occupancy":"0.5"})",
                    R"(square occupancy=0.5 side=4 {"graph":{"square":{"side":"4"}},"occupancy":"0.5"})",
                    R"(square occupancy=0.9 side=2 {"graph":{"square":{"side":"2"}},"occupancy":"0.9"})",
                    R"(square occupancy=0.9 side=4 {"graph":{"square":{"side":"4"}},"occupancy":"0.9"})"));
    EXPECT_THAT(points("growing", "{graph: {square: {side: 3}}, robots: [1, 2]}"),
                ElementsAre(R"(square 3 robots=1 {"graph":{"square":{"side":"3"}},"robots":"1"})",
                            R"(square 3 robots=2 {"graph":{"square":{"side":"3"}},"robots":"2"})"));
}

TEST(ExpandProblem, listsOfMapsMayHoldSweeps)
{
    EXPECT_THAT(
        points("growing", "{graph: [{square: {side: [2, 3]}}, {ring: {length: 9, chords: 1}}], robots: 1}"),
        ElementsAre(R"(square side=2 {"graph":{"square":{"side":"2"}},"robots":"1"})",
                    R"(square side=3 {"graph":{"square":{"side":"3"}},"robots":"1"})",
                    R"(ring 9 1 = {"graph":{"ring":{"chords":"1","length":"9"}},"robots":"1"})"));
}

TEST(ExpandProblem, oneXDrivesSeveralParameters)
{
    EXPECT_THAT(points("growing", "{x: [4, 8], graph: {ring: {length: x, chords: x}}, occupancy: 0.9}"),
                ElementsAre(R"(ring x=4 {"graph":{"ring":{"chords":"4","length":"4"}},"occupancy":"0.9"})",
                            R"(ring x=8 {"graph":{"ring":{"chords":"8","length":"8"}},"occupancy":"0.9"})"));
    EXPECT_THAT(
        points("ladder", "{rungs: x, robots: x, x: {from: 1, to: 2, step: 1}}"),
        ElementsAre(R"(ladder x=1 {"robots":"1","rungs":"1"})", R"(ladder x=2 {"robots":"2","rungs":"2"})"));
    EXPECT_THAT(points("ladder", "{rungs: x, robots: 1, x: 7}"),
                ElementsAre(R"(ladder = {"robots":"1","rungs":"7"})"));
}

TEST(ExpandProblem, refusesWhatSweepsNothing)
{
    EXPECT_EQ(complaint("puzzle", "[]"), "p:1:1: an empty list sweeps nothing; give one value or more");
    EXPECT_EQ(complaint("map", "{map: a, robots: []}"),
              "p:1:18: an empty list sweeps nothing; give one value or more");
    EXPECT_EQ(complaint("map", "{map: a, robots: [5, 6, 5.0]}"), "p:1:25: '5.0' stands twice in the list");
    EXPECT_EQ(complaint("map", "{map: a, robots: [5, [6]]}"),
              "p:1:22: a list inside a list; give its values in one list");
    EXPECT_EQ(complaint("map", "{map: a, robots: [5, ~]}"),
              "p:1:22: an empty value in a list; give a value or leave it out");
    EXPECT_EQ(complaint("ladder", "{robots: 1, x: [1, 2]}"),
              "p:1:13: nothing uses x; give it to a parameter, as in 'handles: x'");
    EXPECT_EQ(complaint("ladder", "{robots: 1, rungs: x, x: [a, b]}"),
              "p:1:27: 'x' takes a number, a list of numbers, {from, to, step} or {from, to, factor}");
}

TEST(ExpandProblem, refusesRangesThatAreNone)
{
    const auto robots = [](const std::string &range)
    { return complaint("map", "{map: a, robots: " + range + "}"); };
    EXPECT_EQ(robots("{from: 5, to: 1, step: 1}"), "p:1:25: the range is empty: from 5 is above to 1");
    EXPECT_EQ(robots("{from: 1, to: 5, step: 0}"), "p:1:41: a step must be above 0, or the range never ends");
    EXPECT_EQ(robots("{from: 1, to: 5, step: -1}"),
              "p:1:41: a step must be above 0, or the range never ends");
    EXPECT_EQ(robots("{from: 1, to: 5, factor: 1}"),
              "p:1:43: a factor must be above 1, or the range never ends");
    EXPECT_EQ(robots("{from: 0, to: 5, factor: 2}"), "p:1:25: a range with a factor must begin above 0");
    EXPECT_EQ(robots("{from: 1, to: 5}"), "p:1:18: a range is {from, to, step} or {from, to, factor}");
    EXPECT_EQ(robots("{from: 1, to: 5, step: 1, factor: 2}"),
              "p:1:18: a range is {from, to, step} or {from, to, factor}");
    EXPECT_EQ(robots("{from: 1, to: 5, stpe: 1}"),
              "p:1:35: unknown key 'stpe' in a range; did you mean 'step'?");
    EXPECT_EQ(robots("{from: a, to: 5, step: 1}"), "p:1:25: 'a' is not a number");
    EXPECT_EQ(robots("{from: 1, to: [5], step: 1}"), "p:1:32: expected a number");
    EXPECT_EQ(robots("{from: 0, to: 5e9, step: 1}"),
              "p:1:18: more than 1000000 points; sweep in larger steps");
}

TEST(ExpandProblem, refusesCrossProductsThatAreTooLarge)
{
    const std::string thousand = "{from: 1, to: 1000, step: 1}";
    EXPECT_NE(complaint("ladder", "{rungs: " + thousand + ", robots: {from: 0, to: 2000, step: 1}}")
                  .find("more than 1000000 points"),
              std::string::npos);
}

} // namespace
} // namespace mrpp
