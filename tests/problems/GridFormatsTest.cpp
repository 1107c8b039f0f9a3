/// Formats that name vertices by cells: paths, the MAPF tracker, PlanViz, libMultiRobotPlanning.

#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/Paths.h"
#include "problems/formats/PlanViz.h"
#include "problems/formats/Tracker.h"

#include "tests/problems/FormatCases.h"

#include <nlohmann/json.hpp>

namespace mrpp
{
namespace
{

/// Vertices 0 1 2 3 in the upper row, 4 and 5 6 in the lower one.
Instance room(std::vector<Vertex> starts, std::vector<Vertex> goals)
{
    const GridMap map = parseMovingAiMap("type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n", "room.map");
    return {map.graph, std::move(starts), std::move(goals)};
}

// Paths of EECBS and LNS

TEST(Paths, ReadsRowsBeforeColumns)
{
    const Instance instance = room({4, 3}, {1, 3});
    for (const char *text : {"Agent 0: (1,0)->(1,0)->(0,0)->(0,1)->\nAgent 1: (0,3)->\n",
                             "Agent 0:(1,0)->(1,0)->(0,0)->(0,1)\r\nAgent 1:(0,3)\r\n"})
    {
        const SolutionRows rows = parsePaths(text, "f", instance);
        ASSERT_EQ(rows.moves.size(), 2);
        EXPECT_EQ(rows.moves[1].to, 1);
        EXPECT_EQ(rows.lineOf(1), 1);
        EXPECT_TRUE(validate(instance, rows.moves, MotionRule::pebble).valid());
    }
    EXPECT_EQ(formatPaths(instance, Schedule({{0, 4, 0}, {0, 0, 1}}, {1, 2})),
              "Agent 0: (1,0)->(0,0)->(0,1)->\nAgent 1: (0,3)->\n");
}

TEST(Paths, RefusesWhatIsMalformed)
{
    const Instance instance = room({0}, {1});
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad", "paths of 0 robots"},
        {"Word", "Robot 0: (0,0)->\n", "bad:1:1", "expected 'Agent'"},
        {"OtherRobot", "Agent 1: (0,0)->\n", "bad:1:7", "expected robot 0"},
        {"NoCell", "Agent 0:\n", "bad:1:9", "expected '('"},
        {"Obstacle", "Agent 0: (0,0)->(1,1)->\n", "bad:1:17", "no vertex in row 1, column 1"},
        {"Cut", "Agent 0: (0,0)->(0,", "bad:1:20", "expected a whole number"},
        {"OtherStart", "Agent 0: (0,1)->\n", "bad:1", "begins on vertex 1"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [&](const std::string &text, const char *file)
                      { (void)parsePaths(text, file, instance); });
    EXPECT_THROW((void)formatPaths({Graph::fromEdges(2, {{0, 1}}), {}, {}}, Schedule()), InputError);
}

// The MAPF tracker

TEST(Tracker, ReadsCountsAndBothForms)
{
    const Instance instance = room({0, 6}, {3, 2});
    const char *csv = "\xEF\xBB\xBFmap_name,agents,solution_plan,flip_up_down\r\nroom,2,\"w3r\nu\",FALSE\r\n";
    const char *json = R"({"map_name":"room","agents":2,"solution_plan":["wr2r","u"]})";
    const char *lines = R"([{"solution_plan":"wrrr\nu","flip_up_down":"FALSE"}])";
    // Robot 1 goes up from (3, 1) to (3, 0), where robot 0 wants to end: such plans are read as they are.
    const auto moves = [&](const char *text, TrackerForm form)
    { return parseTracker(text, "f", form, instance).moves.size(); };
    EXPECT_EQ(moves(csv, TrackerForm::csv), 4);
    EXPECT_EQ(moves(json, TrackerForm::json), 4);
    EXPECT_EQ(moves(lines, TrackerForm::json), 4);
    EXPECT_EQ(parseTracker(csv, "f", TrackerForm::csv, instance).lineOf(0), 3);
}

TEST(Tracker, TurnsUpAndDownOnlyWhereTheFileSaysSoOrNothingElseIsValid)
{
    const Instance down = room({0}, {4});
    const auto read = [](const std::string &plan, const std::string &flip, const Instance &instance)
    {
        return parseTracker("solution_plan" + (flip.empty() ? flip : ",flip_up_down") + "\n" + plan +
                                (flip.empty() ? flip : "," + flip) + "\n",
                            "f", TrackerForm::csv, instance);
    };
    EXPECT_TRUE(read("d", "", down).warnings.empty());
    EXPECT_EQ(read("d", "", down).moves.at(0).to, 4);
    EXPECT_EQ(read("u", "TRUE", down).moves.at(0).to, 4);
    EXPECT_THROW((void)read("u", "FALSE", down), ParseError);
    const SolutionRows old = read("u", "", down);
    EXPECT_EQ(old.moves.at(0).to, 4);
    EXPECT_THAT(old.warnings, testing::ElementsAre(testing::HasSubstr("u goes to the next row")));
    EXPECT_THROW((void)read("uu", "", down), ParseError); // wrong either way
}

TEST(Tracker, WritesBothForms)
{
    const Instance instance = room({0, 4}, {2, 4});
    const Schedule schedule({{0, 0, 1}, {0, 1, 2}}, {1, 2});
    EXPECT_EQ(formatTracker(instance, schedule, TrackerForm::csv, {"room", "even", 3}),
              "map_name,scen_type,type_id,agents,solution_plan,flip_up_down\nroom,even,3,2,\"2r\n\",FALSE\n");
    EXPECT_EQ(formatTracker(instance, schedule, TrackerForm::json, {"room", "even", 3}),
              "{\"map_name\":\"room\",\"scen_type\":\"even\",\"type_id\":3,\"agents\":2,"
              "\"solution_plan\":[\"2r\",\"\"],\"flip_up_down\":false}\n");
}

TEST(Tracker, KnowsTheNamesOfScenarios)
{
    const auto name = trackerName("random-32-32-20-even-7.scen");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->map, "random-32-32-20");
    EXPECT_EQ(name->type, "even");
    EXPECT_EQ(name->number, 7);
    EXPECT_FALSE(trackerName("room.scen"));
}

TEST(Tracker, RefusesWhatIsMalformed)
{
    const Instance instance = room({0}, {1});
    const std::vector<Refusal> csv = {
        {"Empty", "", "bad:1:1", "no column 'solution_plan'"},
        {"NoRow", "solution_plan\n", "bad", "no plan behind the heading"},
        {"OpenQuote", "solution_plan\n\"rr\n", "bad:2:1", "never closed"},
        {"BehindQuote", "solution_plan\n\"r\"r\n", "bad:2:4", "expected a comma"},
        {"TooFewCells", "agents,solution_plan\nr\n", "bad:2:1", "the row has 1 cells"},
        {"TwoPlans", "solution_plan\nr\nr\n", "bad", "there are 2 plans, but none of 1 robot,"},
        {"Flip", "solution_plan,flip_up_down\nr,maybe\n", "bad:2:3", "neither TRUE nor FALSE"},
        {"Letter", "solution_plan\nrx\n", "bad:2:2", "expected one of u, d, l, r and w"},
        {"OffTheMap", "solution_plan\n5r\n", "bad:2:1", "the cell (4, 0)"},
        {"Huge", "solution_plan\n99999999999999999999r\n", "bad:2:1", "too many"},
        {"Large", "solution_plan\n999999999w\n", "bad:2:1", "too many"},
        {"TwoRobots", "solution_plan\n\"r\nw\"\n", "bad", "paths of 2 robots"},
    };
    for (const Refusal &refusal : csv)
        expectRefusal(refusal, [&](const std::string &text, const char *file)
                      { (void)parseTracker(text, file, TrackerForm::csv, instance); });
    const std::vector<Refusal> json = {
        {"Empty", "", "bad:1:1", "no JSON"},
        {"Cut", "{\"solution_plan\":\n[\"r\"", "bad:2:5", "no JSON"},
        {"HugeNumber", "{\"solution_plan\":1e999}", "bad", "a number that is too large"},
        {"OtherObject", "{\"plan\":1}", "bad", "with the key 'solution_plan'"},
        {"Number", "{\"solution_plan\":1}", "bad", "a text or a list of texts"},
        {"Numbers", "{\"solution_plan\":[1]}", "bad", "must be a list of texts"},
        {"Flip", "{\"solution_plan\":\"r\",\"flip_up_down\":3}", "bad", "must be true or false"},
        {"Letter", "{\"solution_plan\":[\"x\"]}", "bad", "robot 0: expected one of"},
    };
    for (const Refusal &refusal : json)
        expectRefusal(refusal, [&](const std::string &text, const char *file)
                      { (void)parseTracker(text, file, TrackerForm::json, instance); });
}

// PlanViz

TEST(PlanViz, IsTheJsonThatTheViewerReads)
{
    const Instance instance = room({4, 3}, {1, 3});
    const auto json =
        nlohmann::json::parse(formatPlanViz(instance, Schedule({{0, 4, 0}, {0, 0, 1}}, {1, 2})));
    const auto expected = nlohmann::json::parse(
        R"({"actionModel":"MAPF","AllValid":"Yes","teamSize":2,"start":[[1,0,"N/A"],[0,3,"N/A"]],
            "numTaskFinished":2,"sumOfCost":2,"makespan":2,"actualPaths":["D,R","W,W"],
            "plannerPaths":["D,R","W,W"],"errors":[],
            "events":[[[0,0,"assigned"],[0,2,"finished"]],[[1,0,"assigned"],[1,0,"finished"]]],
            "tasks":[[0,0,1],[1,0,3]]})");
    EXPECT_EQ(json, expected);
}

TEST(PlanViz, DGoesToTheRowBeforeButForTheVersionsUpTo20)
{
    const Instance instance = room({4}, {0});
    const auto path = [&](PlanVizVersion version)
    {
        const std::string text = formatPlanViz(instance, Schedule({{0, 4, 0}}, {1}), version);
        return nlohmann::json::parse(text)["actualPaths"][0].get<std::string>();
    };
    EXPECT_EQ(path(PlanVizVersion::current), "D");
    EXPECT_EQ(path(PlanVizVersion::upTo2_0), "U");
}

// libMultiRobotPlanning

TEST(LibMrp, ReadsAGridInAnyOrder)
{
    const char *block =
        "agents:\n-   goal: [2, 0]\n    name: a\n    start: [0, 0]\nmap:\n    dimensions: [3, 2]\n"
        "    obstacles:\n    - [1, 1]\n";
    const char *flow = "map: {dimensions: [3, 2], obstacles: [!!python/tuple [1, 1]]}\n"
                       "agents: [{name: a, start: [0, 0], goal: [2, 0]}]\n";
    for (const char *text : {block, flow})
    {
        const Instance instance = parseLibMrpInstance(text, "f").instance;
        EXPECT_EQ(instance.graph->vertexCount(), 5) << text;
        EXPECT_EQ(instance.graph->edgeCount(), 4) << text;
        EXPECT_EQ(instance.graph->yAxis(), YAxis::up) << text;
        EXPECT_EQ(instance.starts, std::vector<Vertex>{0}) << text;
        EXPECT_EQ(instance.goals, std::vector<Vertex>{2}) << text;
    }
}

TEST(LibMrp, ReadsARoadmap)
{
    const LibMrpInstance read = parseLibMrpInstance(
        "roadmap:\n  undirected: false\n  allow_wait_actions: true\n  vertices:\n    A: [0.5, 0]\n    B: [1, "
        "2]\n"
        "    C: [3, 3]\n  edges: [[A, B], [C, B]]\nagents:\n  - {name: x, start: C, goal: A}\n",
        "f");
    EXPECT_EQ(read.instance.graph->edgeCount(), 2);
    EXPECT_EQ(read.instance.graph->coordinate(1), (Point{1, 2, 0}));
    EXPECT_EQ(read.instance.starts, std::vector<Vertex>{2});
    EXPECT_THAT(read.warnings, testing::ElementsAre(testing::HasSubstr("directed")));
}

TEST(LibMrp, RefusesWhatIsMalformed)
{
    const std::string map = "map: {dimensions: [3, 2]}\n";
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "expected YAML with a map"},
        {"NoYaml", "map: [1, 2\n", "bad:2:1", "this is no YAML"},
        {"NoMap", "agents: []\n", "bad:1:1", "neither a 'map' nor a 'roadmap'"},
        {"NoAgents", map, "bad:1:1", "the key 'agents' is missing"},
        {"KeyTwice", map + map, "bad:2:1", "stands in line 1 already"},
        {"Alias", "map: &a {dimensions: [3, 2]}\nagents: []\n", "bad:1:6", "anchors"},
        {"Dimensions", "map: {dimensions: [3]}\nagents: []\n", "bad:1:19", "a list of two"},
        {"Huge", "map: {dimensions: [99999, 99999]}\nagents: []\n", "bad:1:19", "1 to 2097152 cells"},
        {"Zero", "map: {dimensions: [0, 3]}\nagents: []\n", "bad:1:19", "1 to 2097152 cells"},
        {"ObstacleOutside", "map: {dimensions: [3, 2], obstacles: [[3, 0]]}\nagents: []\n", "bad:1:39",
         "(3, 0) is outside"},
        {"NoGoal", map + "agents: [{start: [0, 0]}]\n", "bad:2:10", "the key 'goal' is missing"},
        {"NoChoice", map + "agents: [{start: [0, 0], potentialGoals: []}]\n", "bad:2:42", "has no goal"},
        {"Choice", map + "agents: [{start: [0, 0], potentialGoals: [[1, 0], [2, 0]]}]\n", "bad:2:42",
         "may choose its goal"},
        {"StartIsAWord", map + "agents: [{start: x, goal: [0, 0]}]\n", "bad:2:18", "a list of two"},
        {"StartTwice", map + "agents: [{start: [0, 0], goal: [0, 0]},\n {start: [0, 0], goal: [1, 0]}]\n",
         "bad:3:10", "the start of the robot in line 2 too"},
        {"NoSuchVertex", "roadmap: {vertices: {A: [0, 0]}, edges: [[A, B]]}\nagents: []\n", "bad:1:46",
         "there is no vertex 'B'"},
        {"Deep", std::string(400, '[') + std::string(400, ']'), "bad:1:17", "nested deeper"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file)
                      { (void)parseLibMrpInstance(text, file); });
    const Instance instance = room({0}, {1});
    const std::vector<Refusal> schedules = {
        {"NoSchedule", "statistics: {cost: 1}\n", "bad:1:1", "the key 'schedule' is missing"},
        {"NoRobots", "schedule: []\n", "bad:1:11", "expected a map of robots"},
        {"OtherRobot", "schedule:\n  agent1: [{x: 0, y: 0, t: 0}]\n", "bad:2:3", "none of the instance's 1"},
        {"OtherTime", "schedule:\n  agent0: [{x: 0, y: 0, t: 1}]\n", "bad:2:28", "expected the time 0"},
        {"Obstacle", "schedule:\n  agent0: [{x: 1, y: 1, t: 0}]\n", "bad:2:12",
         "no vertex on the cell (1, 1)"},
        {"Name", "schedule:\n  agent0: [{v: A, t: 0}]\n", "bad:2:16", "there is no vertex 'A'"},
        {"NoStates", "schedule:\n  agent0: []\n", "bad:2:3", "found none for this robot"},
        {"TimeBack", "schedule:\n  agent0: [{x: 0, y: 0, t: 0}, {x: 1, y: 0, t: 0}]\n", "bad:2:48",
         "expected a time after 0"},
    };
    for (const Refusal &refusal : schedules)
        expectRefusal(refusal, [&](const std::string &text, const char *file)
                      { (void)parseLibMrpSchedule(text, file, instance); });
}

/// All of them read what they write.
RC_GTEST_PROP(GridFormats, ComeBackAsTheyWereWritten, ())
{
    const Case given = randomCase(randomCells());
    const Instance &instance = given.instance;
    const auto comesBack = [&](const SolutionRows &rows)
    {
        RC_ASSERT(rows.warnings.empty());
        const Schedule again = scheduleOf(rows, instance);
        RC_ASSERT(formatPaths(instance, again) == formatPaths(instance, given.schedule));
        RC_ASSERT(again.makespan() == given.schedule.makespan());
    };
    comesBack(parsePaths(formatPaths(instance, given.schedule), "f", instance));
    comesBack(parseLibMrpSchedule(formatLibMrpSchedule(instance, given.schedule), "f", instance));
    for (const TrackerForm form : {TrackerForm::csv, TrackerForm::json})
        comesBack(parseTracker(formatTracker(instance, given.schedule, form, {"a,\"b", "random", 1}), "f",
                               form, instance));
    const LibMrpInstance again = parseLibMrpInstance(formatLibMrpInstance(instance), "f");
    RC_ASSERT(again.instance.fingerprint() == instance.fingerprint());
}

RC_GTEST_PROP(LibMrp, ARoadmapComesBackAsItWasWritten, ())
{
    const auto bare = randomGraph();
    std::vector<Point> points;
    for (Vertex v = 0; v < bare->vertexCount(); ++v)
        points.push_back({v + 0.5, *rc::gen::inRange(-99, 99) / 7.0, 0});
    const Case given = randomCase(Graph::fromEdges(bare->vertexCount(), bare->edges(), points));
    const LibMrpInstance again = parseLibMrpInstance(formatLibMrpInstance(given.instance), "f");
    RC_ASSERT(again.instance.fingerprint() == given.instance.fingerprint());
    RC_ASSERT(std::equal(points.begin(), points.end(), again.instance.graph->coordinates().begin()));
    const SolutionRows rows =
        parseLibMrpSchedule(formatLibMrpSchedule(given.instance, given.schedule), "f", given.instance);
    RC_ASSERT(scheduleOf(rows, given.instance).makespan() == given.schedule.makespan());
}

} // namespace
} // namespace mrpp
