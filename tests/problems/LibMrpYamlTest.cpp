/// libMultiRobotPlanning's five kinds of inputs, its schedules, and what it may be told.

#include "problems/formats/LibMrpYaml.h"

#include "problems/formats/FormatId.h"
#include "tests/problems/FormatCases.h"

namespace mrpp
{
namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kAgents = "agents:\n  - name: agent0\n    start: A\n    goal: C\n";

std::string roadmap(const std::string &rules)
{
    return "roadmap:\n" + rules + "  edges:\n    - [A, B]\n    - [B, C]\n" + kAgents;
}

TEST(LibMrpInputs, ARoadmapWithoutVerticesHasThoseOfItsEdges)
{
    const LibMrpInstance read =
        parseLibMrpInstance(roadmap("  undirected: True\n  allow_wait_actions: True\n"), "f");
    EXPECT_THAT(read.vertexNames, ElementsAre("A", "B", "C"));
    EXPECT_FALSE(read.instance.graph->hasCoordinates());
    EXPECT_EQ(read.instance.graph->edgeCount(), 2);
    EXPECT_THAT(read.instance.goals, ElementsAre(2));
    EXPECT_TRUE(read.warnings.empty());
}

TEST(LibMrpInputs, FalseHasManySpellings)
{
    for (const std::string no : {"false", "False", "FALSE", "no", "No", "off", "Off", "n", "N"})
    {
        const auto warnings =
            parseLibMrpInstance(roadmap("  undirected: " + no + "\n  allow_wait_actions: " + no + "\n"), "f")
                .warnings;
        EXPECT_THAT(warnings, Contains(HasSubstr("the roadmap is directed"))) << no;
        EXPECT_THAT(warnings, Contains(HasSubstr("the roadmap forbids waiting"))) << no;
    }
    for (const std::string yes : {"true", "True", "TRUE", "yes", "on", "Y"})
        EXPECT_TRUE(parseLibMrpInstance(roadmap("  undirected: " + yes + "\n"), "f").warnings.empty()) << yes;
    expectRefusal({"Neither", roadmap("  undirected: maybe\n"), "bad:2:15", "true or false"},
                  [](const std::string &text, const char *file) { (void)parseLibMrpInstance(text, file); });
}

TEST(LibMrpInputs, ADirectedRoadmapWithBothDirectionsAndLoopsIsAnUndirectedOne)
{
    const std::string text =
        "roadmap:\n  undirected: False\n  allow_wait_actions: False\n  conflicts: [[], []]\n"
        "  edges: [[A, B], [B, A], [B, C], [C, B], [A, A], [B, B], [C, C]]\n" +
        kAgents;
    EXPECT_TRUE(parseLibMrpInstance(text, "f").warnings.empty());
}

TEST(LibMrpInputs, WhatIsNotKnownIsRefused)
{
    const std::string map = "map: {dimensions: [3, 2]}\n";
    const std::vector<Refusal> refusals = {
        {"Misspelt", "map:\n  dimensions: [3, 2]\n  obstacle:\n    - [1, 0]\nagents: []\n", "bad:3:3",
         "did you mean 'obstacles'"},
        {"MisspeltAtTheTop", map + "agent: []\nagents: []\n", "bad:2:1", "'agent' is not known"},
        {"MisspeltInAnAgent", map + "agents: [{start: [0, 0], goal: [1, 0], nmae: a}]\n", "bad:2:40",
         "did you mean 'name'"},
        {"Conflicts", roadmap("  undirected: False\n  conflicts: [[1], [0]]\n"), "bad:3:15",
         "conflicts with others"},
        {"Dynamic", map + "dynamic_obstacles: [[1, 0]]\nagents: []\n", "bad:2:20", "obstacles that move"},
        {"Intervals",
         "start: [0, 1]\ngoal: [2, 3]\nenvironment:\n  size: [10, 10]\n  obstacles: []\n  "
         "collisionIntervals:\n"
         "    - location: [2, 3]\n      intervals:\n        - [0, 8]\n",
         "bad:7:7", "the program sipp with obstacles that move"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file)
                      { (void)parseLibMrpInstance(text, file); });
    EXPECT_EQ(parseLibMrpInstance(map + "dynamic_obstacles: {}\nagents: []\n", "f").instance.robotCount(), 0);
}

TEST(LibMrpInputs, OneGoalToChooseFromIsTheGoal)
{
    const LibMrpInstance read = parseLibMrpInstance(
        "map: {dimensions: [3, 1]}\nagents:\n  - {name: a, start: [0, 0], potentialGoals: [[2, 0]]}\n", "f");
    EXPECT_THAT(read.instance.goals, ElementsAre(2));
}

TEST(LibMrpInputs, SippsOneRobotIsReadWhereNothingElseMoves)
{
    const LibMrpInstance read = parseLibMrpInstance("start: [0, 1]\ngoal: [2, 0]\nenvironment:\n  size: [3, "
                                                    "2]\n  obstacles: [[1, 1]]\n  collisionIntervals: []\n",
                                                    "f");
    EXPECT_EQ(read.instance.graph->vertexCount(), 5);
    EXPECT_THAT(read.instance.starts, ElementsAre(3));
    EXPECT_THAT(read.instance.goals, ElementsAre(2));
    const std::string answer = "schedule:\n  agent1:\n    - {x: 0, y: 1, t: 0}\n    - {x: 0, y: 0, t: 1}\n";
    EXPECT_EQ(parseLibMrpSchedule(answer, "f", read.instance, {}, read.robotNames).moves.size(), 1U);
}

TEST(LibMrpInputs, AMapKeepsItsSizeWhereTheBorderIsBlocked)
{
    const std::string text = "map:\n  dimensions: [3, 2]\n  obstacles: [[2, 0], [2, 1]]\nagents: []\n";
    const LibMrpInstance read = parseLibMrpInstance(text, "f");
    ASSERT_TRUE(read.map);
    EXPECT_EQ(read.map->width, 3U);
    EXPECT_THAT(formatLibMrpInstance(read.instance, {{}, {}, &*read.map}), HasSubstr("dimensions: [3, 2]"));
}

TEST(LibMrpOutputs, AMapOrARoadmapIsWrittenWhereOneIsAskedFor)
{
    const Instance grid = parseLibMrpInstance("map: {dimensions: [2, 1]}\nagents: []\n", "f").instance;
    EXPECT_THAT(formatLibMrpInstance(grid, {}, LibMrpForm::map), HasSubstr("map:\n"));
    EXPECT_THAT(formatLibMrpInstance(grid, {}, LibMrpForm::roadmap), HasSubstr("roadmap:\n"));
    const Instance tree{Graph::fromEdges(3, {{0, 1}, {1, 2}}), {0}, {2}};
    EXPECT_THROW((void)formatLibMrpInstance(tree, {}, LibMrpForm::map), InputError);
    const std::string text = formatLibMrpInstance(tree);
    EXPECT_THAT(text, HasSubstr("roadmap:\n"));
    const LibMrpInstance again = parseLibMrpInstance(text, "f");
    EXPECT_EQ(again.instance.fingerprint(), tree.fingerprint());
    EXPECT_FALSE(again.instance.graph->hasCoordinates());
}

Instance corridor(std::vector<Vertex> starts, std::vector<Vertex> goals)
{
    return {parseLibMrpInstance("map: {dimensions: [4, 2]}\nagents: []\n", "f").instance.graph,
            std::move(starts), std::move(goals)};
}

TEST(LibMrpSchedules, GapsInTheTimesAreWaits)
{
    const Instance instance = corridor({1, 6}, {2, 7});
    const std::string text = "schedule:\n  agent0:\n    - {x: 1, y: 0, t: 0}\n    - {x: 1, y: 0, t: 3}\n"
                             "    - {x: 2, y: 0, t: 4}\n  agent1:\n    - {x: 2, y: 1, t: 0}\n"
                             "    - {x: 3, y: 1, t: 2}\n";
    const SolutionRows rows = parseLibMrpSchedule(text, "f", instance);
    ASSERT_EQ(rows.moves.size(), 2U);
    EXPECT_EQ(rows.moves[0].robot, 1);
    EXPECT_EQ(rows.moves[1].robot, 0);
    EXPECT_EQ(rows.moves[1].step, 1);
    EXPECT_TRUE(validate(instance, rows.moves, MotionRule::pebble).valid());
}

TEST(LibMrpSchedules, SayThatThereIsNoSolution)
{
    const Instance instance = corridor({1}, {2});
    for (const char *text : {"statistics:\n  success: 0\n", "statistics: {success: false}\n",
                             "schedule:\n  agent0:\n    []\nstatistics:\n  cost: 0\n"})
        EXPECT_THROW((void)parseLibMrpSchedule(text, "f", instance), NoSolution) << text;
}

TEST(LibMrpSchedules, RobotsAreCalledByTheirNamesOrNumbers)
{
    const Instance instance = corridor({1, 6}, {1, 6});
    const auto text = [](const std::string &first, const std::string &second)
    {
        return "schedule:\n  " + first + ":\n    - {x: 1, y: 0, t: 0}\n  " + second +
               ":\n    - {x: 2, y: 1, t: 0}\n";
    };
    const std::vector<std::string> names = {"red", "blue"};
    EXPECT_TRUE(parseLibMrpSchedule(text("red", "blue"), "f", instance, {}, names).moves.empty());
    EXPECT_TRUE(parseLibMrpSchedule(text("agent0", "agent1"), "f", instance, {}, names).moves.empty());
    EXPECT_THROW((void)parseLibMrpSchedule(text("red", "green"), "f", instance, {}, names), ParseError);
    EXPECT_THROW((void)parseLibMrpSchedule(text("red", "blue"), "f", instance), ParseError);
    const std::vector<std::string> swapped = {"agent1", "agent0"};
    EXPECT_TRUE(parseLibMrpSchedule(text("agent1", "agent0"), "f", instance, {}, swapped).moves.empty());
    EXPECT_TRUE(parseLibMrpSchedule(text("agent0", "agent1"), "f", instance, {}, swapped).moves.empty());
    EXPECT_THAT(formatLibMrpSchedule(instance, Schedule(), {}, names), HasSubstr("\"blue\":\n"));
}

} // namespace
} // namespace mrpp
