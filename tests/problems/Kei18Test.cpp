/// Instances and results of Kei18's programs.

#include "problems/formats/Kei18.h"

#include "tests/problems/FormatCases.h"

namespace mrpp
{
namespace
{

GridMap room()
{
    return parseMovingAiMap("type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n", "room.map");
}

constexpr const char *kInstance = "# a comment\nmap_file=arena.map\nagents=2\nseed=0\nrandom_problem=0\n"
                                  "max_timestep=1000\nmax_comp_time=5000\n0,1,3,0\n2,0,0,1\n";

TEST(Kei18Instance, ReadsColumnsBeforeRows)
{
    const Kei18Instance text = parseKei18Instance(kInstance, "f");
    EXPECT_EQ(text.map, "arena.map");
    const Instance instance = kei18Instance(text, room());
    EXPECT_EQ(instance.starts, (std::vector<Vertex>{4, 2}));
    EXPECT_EQ(instance.goals, (std::vector<Vertex>{3, 4}));
    EXPECT_EQ(formatKei18Instance(instance, "arena.map"), "map_file=arena.map\nagents=2\nrandom_problem=0\n"
                                                          "0,1,3,0\n2,0,0,1\n");
}

TEST(Kei18Instance, TheRobotsAreTheFirstLines)
{
    EXPECT_EQ(parseKei18Instance("agents=1\r\n0,1,3,0\r\n2,0,0,1,\r\n", "f").agents.size(), 1);
}

TEST(Kei18Instance, RefusesWhatIsMalformed)
{
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "no line 'agents="},
        {"NoCount", "map_file=a\n0,0,1,0\n", "bad:1:1", "no line 'agents="},
        {"TooFew", "agents=2\n0,0,1,0\n", "bad:1:8", "should be 2 agents, but 1 lines"},
        {"Negative", "agents=-2\n", "bad:1:8", "should be -2"},
        {"CountTwice", "agents=1\nagents=1\n0,0,1,0\n", "bad:2:1", "a second time"},
        {"UnknownKey", "agents=1\ntask_num=3\n0,0,1,0\n", "bad:2:1", "'task_num' is no key"},
        {"Random", "agents=1\nrandom_problem=1\n", "bad:2:16", "other robots in every program"},
        {"Word", "agents=1\nhello\n", "bad:2:1", "expected a whole number here, the start's column"},
        {"ThreeNumbers", "agents=1\n0,0,1\n", "bad:2:6", "expected ','"},
        {"FiveNumbers", "agents=1\n0,0,1,0,3\n", "bad:2:9", "expected the line's end"},
        {"Huge", "agents=1\n0,0,99999999999999999999,0\n", "bad:2:5", "too large"},
        {"Outside", "agents=1\n0,0,4,0\n", "bad:2:5", "the goal (4, 0) is outside"},
        {"Obstacle", "agents=1\n1,1,0,0\n", "bad:2:1", "the start (1, 1) is an obstacle"},
        {"StartTwice", "agents=2\n0,0,1,0\n0,0,2,0\n", "bad:3:1", "the start of the robot in line 2 too"},
        {"GoalTwice", "agents=2\n0,0,1,0\n2,0,1,0\n", "bad:3:5", "the goal of the robot in line 2 too"},
    };
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [](const std::string &text, const char *file)
                      { (void)kei18Instance(parseKei18Instance(text, file), room()); });
}

RC_GTEST_PROP(Kei18Instance, ComesBackAsItWasWritten, ())
{
    const Instance instance = randomCase(randomCells()).instance;
    const GridMap map = gridMapOf(*instance.graph);
    const Instance again =
        kei18Instance(parseKei18Instance(formatKei18Instance(instance, "a b.map"), "f"), map);
    RC_ASSERT(again.fingerprint() == instance.fingerprint());
}

TEST(Kei18Result, WritesEveryRobotAtEveryTime)
{
    const GridMap map = room();
    const Instance instance{map.graph, {0, 6}, {2, 6}};
    const Schedule schedule({{0, 0, 1}, {0, 1, 2}}, {1, 2});
    EXPECT_EQ(formatKei18Result(instance, schedule, "room.map"),
              "agents=2\nmap_file=room.map\nsolver=mrppsim\nsolved=1\nsoc=2\nmakespan=2\ncomp_time=0\n"
              "starts=(0,0),(3,1),\ngoals=(2,0),(3,1),\nsolution=\n"
              "0:(0,0),(3,1),\n1:(1,0),(3,1),\n2:(2,0),(3,1),\n");
}

TEST(Kei18Result, ReadsDirectionsAndWaits)
{
    const GridMap map = room();
    const Instance instance{map.graph, {0}, {2}};
    const SolutionRows rows = parseKei18Result(
        "solved=1\nsome words\nsolution=\n0:(0,0,X_PLUS),\n1:(0,0,X_PLUS),\n2:(1,0),\n3:(2,0)\n", "f",
        instance);
    ASSERT_EQ(rows.moves.size(), 2);
    EXPECT_EQ(rows.moves[0].step, 0); // the wait leaves no gap
    EXPECT_EQ(rows.moves[1].to, 2);
    EXPECT_EQ(rows.lineOf(1), 7);
    EXPECT_TRUE(validate(instance, rows.moves, MotionRule::pebble).valid());
}

TEST(Kei18Result, RefusesWhatIsMalformed)
{
    const std::vector<Refusal> refusals = {
        {"Empty", "", "bad:1:1", "no line 'solution='"},
        {"NoSolution", "solved=0\nsolution=\n", "bad", "no solution behind"},
        {"OtherTime", "solution=\n1:(0,0),\n", "bad:2:1", "expected the time 0"},
        {"Obstacle", "solution=\n0:(1,1),\n", "bad:2:3", "the graph has no vertex"},
        {"OtherStart", "solution=\n0:(1,0),\n", "bad:2", "robot 0 begins on vertex 1"},
        {"OtherCount", "solution=\n0:(0,0),(1,0),\n", "bad", "paths of 2 robots"},
        {"MoreRobots", "solution=\n0:(0,0),\n1:(0,0),(1,0),\n", "bad:3:9", "more robots than at time 0"},
        {"FewerRobots", "solution=\n0:(0,0),\n1:\n", "bad:3:3", "there are 0 robots, fewer than the 1"},
        {"Bracket", "solution=\n0:(0,0,\n", "bad:2:8", "expected ')'"},
        {"Task", "solution=\n0:(0,0)->(1,0):1,\n", "bad:2:8", "expected ','"},
    };
    const GridMap map = room();
    const Instance instance{map.graph, {0}, {2}};
    for (const Refusal &refusal : refusals)
        expectRefusal(refusal, [&](const std::string &text, const char *file)
                      { (void)parseKei18Result(text, file, instance); });
}

RC_GTEST_PROP(Kei18Result, ComesBackAsItWasWritten, ())
{
    const Case given = randomCase(randomCells());
    const std::string text = formatKei18Result(given.instance, given.schedule, "a.map");
    const SolutionRows rows = parseKei18Result(text, "f", given.instance);
    const Schedule again = scheduleOf(rows, given.instance);
    RC_ASSERT(again.makespan() == given.schedule.makespan());
    RC_ASSERT(formatKei18Result(given.instance, again, "a.map") == text);
}

} // namespace
} // namespace mrpp
