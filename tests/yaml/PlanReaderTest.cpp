#include "yaml/PlanReader.h"
#include "tests/yaml/TestCatalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{

namespace
{

using ::testing::ElementsAre;
using ::testing::Pair;

BenchmarkPlan plan(const std::string &text)
{
    static Catalog catalog = test::makeCatalog();
    return parsePlan(text, "folder/my_plan.yaml", catalog);
}

std::vector<std::string> pointNames(const BenchmarkPlan &plan)
{
    std::vector<std::string> names;
    for (const ProblemPoint &point : plan.points)
        names.push_back(point.name + (point.sweepValue
                                          ? " " + point.sweepVariable + "=" + formatNumber(*point.sweepValue)
                                          : ""));
    return names;
}

TEST(PlanReader, readsEveryKey)
{
    const BenchmarkPlan read = plan(R"yaml(campaign: Objective-05_b.2
seed: 2016
repetitions: 10
limits: {time: 90 s, memory: 4 GiB}
problems:
  - puzzle: [tree, tunnel]
  - map: {map: a.map, robots: {from: 200, to: 400, step: 100}}
planners:
  - walker
  - {planner: walker, name: "slow `walker` $(x)", set: {pace: 2, order: far_first}}
optimizers: [shorten, {optimizer: shorten, set: {rounds: 7}}]
reports: [charts, csv]
motion: pebble
execution: {jobs: 2, isolation: process}
keep: {instances: true, solutions: false}
explorer: {solutions: all, size: 500 kB}
)yaml");
    EXPECT_EQ(read.campaign, "Objective-05_b.2");
    EXPECT_EQ(read.seed, 2016U);
    EXPECT_EQ(read.repetitions, 10);
    EXPECT_DOUBLE_EQ(read.limits.time, 90);
    EXPECT_DOUBLE_EQ(read.limits.memory, 4294.967296);
    EXPECT_THAT(pointNames(read),
                ElementsAre("tree", "tunnel", "a robots=200", "a robots=300", "a robots=400"));
    EXPECT_EQ(read.points[2].model, "map");
    EXPECT_EQ(read.points[2].problem->robots()->value, 200);
    ASSERT_EQ(read.planners.size(), 2U);
    EXPECT_EQ(read.planners[0].kind, "walker");
    EXPECT_EQ(read.planners[0].name, "walker");
    EXPECT_EQ(read.planners[1].name, "slow `walker` $(x)");
    EXPECT_THAT(read.planners[1].settings, ElementsAre(Pair("pace", "2"), Pair("order", "far_first")));
    ASSERT_EQ(read.optimizers.size(), 2U);
    EXPECT_THAT(read.optimizers[1].settings, ElementsAre(Pair("rounds", "7")));
    EXPECT_THAT(read.reports, ElementsAre("charts", "csv"));
    EXPECT_EQ(read.motion, MotionRule::pebble);
    EXPECT_EQ(read.execution.jobs, 2);
    EXPECT_EQ(read.execution.isolation, "process");
    EXPECT_TRUE(read.keep.instances);
    EXPECT_FALSE(read.keep.solutions);
    EXPECT_EQ(read.explorer.solutions, "all");
    EXPECT_DOUBLE_EQ(read.explorer.size, 0.5);
    EXPECT_EQ(read.file, "folder/my_plan.yaml");
}

TEST(PlanReader, looksForMapsWhereThePlanSays)
{
    const std::string rest = "problems: [puzzle]\nplanners: [runner]\n";
    EXPECT_THAT(plan("maps: there\n" + rest).mapFolders, ElementsAre("folder/there"));
    EXPECT_THAT(plan("maps: [../a, /b]\n" + rest).mapFolders, ElementsAre("folder/../a", "/b"));
    EXPECT_TRUE(plan(rest).mapFolders.empty());
}

TEST(PlanReader, hasDefaults)
{
    const BenchmarkPlan read = plan("problems: [puzzle]\nplanners: [runner]\n");
    EXPECT_EQ(read.campaign, "my_plan");
    EXPECT_EQ(read.seed, 1U);
    EXPECT_EQ(read.repetitions, 1);
    EXPECT_DOUBLE_EQ(read.limits.time, 60);
    EXPECT_TRUE(read.optimizers.empty());
    EXPECT_THAT(read.reports, ElementsAre("csv", "charts"));
    EXPECT_EQ(read.motion, MotionRule::rotation);
    EXPECT_EQ(read.execution.jobs, 1);
    EXPECT_FALSE(read.keep.instances);
    EXPECT_EQ(read.text, "problems: [puzzle]\nplanners: [runner]\n");
}

TEST(PlanReader, readsCharts)
{
    const std::string start = "problems: [puzzle]\nplanners: [runner]\n";
    const BenchmarkPlan some =
        plan(start + "reports: [csv, {chart: {x: occupancy, y: path_length, per: robots, log: [y]}}]");
    EXPECT_THAT(some.reports, ElementsAre("charts", "csv"));
    EXPECT_FALSE(some.automaticCharts);
    ASSERT_EQ(some.charts.size(), 1U);
    EXPECT_EQ(some.charts[0].kind, "curves");
    EXPECT_EQ(some.charts[0].x, "occupancy");
    EXPECT_EQ(some.charts[0].y, "path_length");
    EXPECT_EQ(some.charts[0].per, "robots");
    EXPECT_EQ(some.charts[0].logX, false);
    EXPECT_EQ(some.charts[0].logY, true);
    const BenchmarkPlan both =
        plan(start + "reports: [charts, {chart: {kind: ecdf, y: time, problem: puzzle}}]");
    EXPECT_TRUE(both.automaticCharts);
    EXPECT_EQ(both.charts[0].logY, std::nullopt);
    const BenchmarkPlan grown = plan(start + "reports: [{chart: {kind: scaling, y: time}}, "
                                             "{chart: {kind: scaling, x: path_length, y: memory}}]");
    EXPECT_EQ(grown.charts[0].x, "vertices");
    EXPECT_EQ(grown.charts[1].x, "path_length");
}

TEST(PlanReader, knowsUnits)
{
    const auto limits = [](const std::string &text)
    { return plan("problems: [puzzle]\nplanners: [runner]\nlimits: " + text).limits; };
    EXPECT_DOUBLE_EQ(limits("{time: 500 ms}").time, 0.5);
    EXPECT_DOUBLE_EQ(limits("{time: 2min}").time, 120);
    EXPECT_DOUBLE_EQ(limits("{time: 1.5 h}").time, 5400);
    EXPECT_DOUBLE_EQ(limits("{memory: 500 MB}").memory, 500);
    EXPECT_DOUBLE_EQ(limits("{memory: 512 KiB}").memory, 0.524288);
    EXPECT_DOUBLE_EQ(limits("{memory: 2 TB}").memory, 2e6);
}

TEST(PlanReader, problemsOfOneNameAreToldApart)
{
    EXPECT_THAT(pointNames(plan(R"(planners: [runner]
problems:
  - map: {map: a.map, robots: [1, 2]}
  - map: {map: a.map, robots: [3]}
  - map: {map: other/a.map, robots: [1, 2]}
  - map: {map: a.map, robots: 7}
  - map: {map: a.map, robots: 8}
)")),
                ElementsAre("a robots=1", "a robots=2", "a robots=3", "a (2) robots=1", "a (2) robots=2", "a",
                            "a robots=8"));
}

struct BadPlan
{
    const char *text;
    const char *place;     ///< line:column
    const char *complaint; ///< how the message begins
};

/// A plan that is right but for one line.
std::string goodExcept(const std::string &line)
{
    return "problems: [puzzle]\nplanners: [runner]\n" + line;
}

std::string complaintAbout(const std::string &text)
{
    try
    {
        (void)plan(text);
        return "accepted";
    }
    catch (const InputError &error)
    {
        return error.what();
    }
}

class PlanReaderRefuses : public ::testing::TestWithParam<BadPlan>
{};

TEST_P(PlanReaderRefuses, aWholePlan)
{
    const std::string expected =
        std::string("folder/my_plan.yaml:") + GetParam().place + ": " + GetParam().complaint;
    const std::string complaint = complaintAbout(GetParam().text);
    EXPECT_EQ(complaint.substr(0, expected.size()), expected) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    problems, PlanReaderRefuses,
    ::testing::Values(
        BadPlan{"", "1:1", "a plan is a map of keys"}, BadPlan{"- a\n", "1:1", "a plan is a map of keys"},
        BadPlan{"hello", "1:1", "a plan is a map of keys"},
        BadPlan{"planners: [runner]", "1:1", "the plan has no 'problems'"},
        BadPlan{"problems: [puzzle]", "1:1", "the plan has no 'planners'"},
        BadPlan{"problem: [puzzle]", "1:1", "unknown key 'problem' in a plan; did you mean 'problems'?"},
        BadPlan{"problems: [puzzle]\nproblems: [map]", "2:1", "the key 'problems' stands here a second time"},
        BadPlan{"problems: []", "1:11", "'problems' is an empty list; give problems"},
        BadPlan{"problems: puzzle", "1:11", "'problems' takes a list: problems"},
        BadPlan{"problems:\n", "1:1", "'problems' takes a list: problems"},
        BadPlan{"problems: [puzle]", "1:12", "there is no problem 'puzle'; did you mean 'puzzle'?"},
        BadPlan{"problems:\n  - puzzle: tree\n    seed: 3", "3:5",
                "a problem is one family with its settings"},
        BadPlan{"problems: [[puzzle]]", "1:12", "a problem is one family with its settings"},
        BadPlan{"problems: [puzzle: tre]", "1:20", "parameter 'problem'"},
        BadPlan{"problems: [puzzle: []]", "1:20", "an empty list sweeps nothing"},
        BadPlan{"problems: [puzzle: [tree, tree]]", "1:27", "'tree' stands twice in the list"},
        BadPlan{"problems:\n  - puzzle: tree\n  - puzzle: tree", "3:5",
                "the problem 'tree' is in the plan already"},
        BadPlan{"problems: [ladder: {rungs: 5, robts: 2}]", "1:31",
                "unknown key 'robts'; did you mean 'robots'?"},
        BadPlan{"problems: [ladder: {rungs: 5}]", "1:20", "'ladder' needs to know how many robots there are"},
        BadPlan{"problems: [ladder: {rungs: 0, robots: 1}]", "1:28", "parameter 'rungs' must lie in 1:1000"},
        BadPlan{"problems: [ladder: {rungs: many, robots: 1}]", "1:28",
                "parameter 'rungs' takes a whole number"},
        BadPlan{"problems: [ladder: {rungs: [1, 5000], robots: 1}]", "1:32", "parameter 'rungs' must lie in"},
        BadPlan{"problems: [ladder: {robots: 1, free: 2}]", "1:32", "'free' says a second time"},
        BadPlan{"problems: [ladder: {robots: -1}]", "1:29", "'robots' cannot be negative"},
        BadPlan{"problems: [ladder: {robots: 1.5}]", "1:29", "'robots' takes a whole number"},
        BadPlan{"problems: [ladder: {occupancy: 1.5}]", "1:32", "an occupancy lies between 0 and 1"},
        BadPlan{"problems: [ladder: {robots: x}]", "1:29", "'x' is not a number"},
        BadPlan{"problems: [map: {map: a, robots: {from: 1, to: 2}}]", "1:34",
                "a range is {from, to, step}"}));

INSTANTIATE_TEST_SUITE_P(
    planners, PlanReaderRefuses,
    ::testing::Values(
        BadPlan{"planners: []", "1:11", "'planners' is an empty list; give planners"},
        BadPlan{"planners: [runer]", "1:12", "there is no planner 'runer'; did you mean 'runner'?"},
        BadPlan{"planners: [runner, runner]", "1:20", "two planners are named 'runner'"},
        BadPlan{"planners: [{planner: walker, name: runner}, runner]", "1:45",
                "two planners are named 'runner'"},
        BadPlan{"planners: [{name: mine}]", "1:12", "this entry does not say which planner it is"},
        BadPlan{"planners: [{planer: runner}]", "1:13",
                "unknown key 'planer' in a planner of the plan; did you mean"},
        BadPlan{"planners: [{planner: wlker}]", "1:22",
                "there is no planner 'wlker'; did you mean 'walker'?"},
        BadPlan{"planners: [{planner: walker, set: {pase: 1}}]", "1:36",
                "there is no parameter 'pase'; did you mean 'pace'?"},
        BadPlan{"planners: [{planner: walker, set: {pace: 11}}]", "1:42",
                "parameter 'pace' must lie in 1:10"},
        BadPlan{"planners: [{planner: walker, set: {pace: [[1], 2]}}]", "1:43",
                "parameter 'pace' takes one value"},
        BadPlan{"planners: [{planner: walker, set: {pace: [1, 11]}}]", "1:46",
                "parameter 'pace' must lie in 1:10"},
        BadPlan{"planners: [{planner: walker, set: {pace: []}}]", "1:42", "'pace' is an empty list"},
        BadPlan{"planners: [{planner: walker, set: {pace: {from: 1}}}]", "1:42",
                "a range is {from, to, step}"},
        BadPlan{"planners: [{planner: walker, set: {pace: [1, 1]}}]", "1:12",
                "two planners are named 'walker pace=1'"},
        BadPlan{"planners: [{planner: walker, set: {pace: }}]", "1:36", "parameter 'pace' takes one value"},
        BadPlan{"planners: [{planner: walker, set: pace}]", "1:35", "'set' takes a map"},
        BadPlan{"planners: [{planner: walker, name: }]", "1:30", "'name' takes one value"},
        BadPlan{"planners: [[walker]]", "1:12", "a planner is a name or"},
        BadPlan{"planners: [walker]\noptimizers: [{optimizer: shorten, set: {rounds: [1, 2]}}]", "2:14",
                "an optimizer has one value for each parameter"}));

INSTANTIATE_TEST_SUITE_P(
    commands, PlanReaderRefuses,
    ::testing::Values(
        BadPlan{"planners: [{command: lacam3, name: L}]", "1:22", "the command is not told its instance"},
        BadPlan{"planners: [{command: 'x {instance}', format: kai18}]", "1:46",
                "there is no format 'kai18' for this"},
        BadPlan{"planners: [{command: 'x {instance}', format: instance}]", "1:46",
                "there is no format 'instance' for this"},
        BadPlan{"planners: [{command: 'x {instance}', comand: y}]", "1:38",
                "unknown key 'comand' in a command of the plan; did you mean 'command'?"},
        BadPlan{"planners: [{command: 'x {instance} {time_limt}'}]", "1:22",
                "nothing fills the place {time_limt}; did you mean 'time_limit'?"},
        BadPlan{"planners: [{command: 'x {instance} {wieght}', set: {weight: 1}}]", "1:53",
                "the command has no place {weight}; did you mean 'wieght'?"},
        BadPlan{"planners: [{command: 'x {instance} {w}'}]", "1:22", "nothing fills the place {w}"},
        BadPlan{"planners: [{command: 'x {instance}', set: {seed: 1}}]", "1:44",
                "'seed' is no parameter of a command"},
        BadPlan{"planners: [{command: 'x {instance} {w}', set: {w: [1, [2]]}}]", "1:55",
                "parameter 'w' takes one value"},
        BadPlan{"planners: [{command: \"x 'y {instance}\"}]", "1:22", "this is no command: a quote ' is not"},
        BadPlan{"planners: [{command: ' '}]", "1:22", "this is no command: there is no program in it"},
        BadPlan{"planners: [{command: 'x {instance}', motion: rotaton}]", "1:46",
                "there is no motion rule 'rotaton'; did you mean 'rotation'?"},
        BadPlan{"planners: [{command: 'x {instance}', exit_codes: {0: solved}}]", "1:51",
                "an exit code is a number from 1 to 255"},
        BadPlan{"planners: [{command: 'x {instance}', exit_codes: {1: gaveup}}]", "1:54",
                "an exit code cannot mean 'gaveup'; did you mean 'gave_up'?"},
        BadPlan{"planners: [{command: 'x {instance}'}, {command: 'x {scen}'}]", "1:39",
                "two planners are named 'x'"}));

TEST(PlanReader, commandsAreWordsWithPlaces)
{
    const auto planners = plan(R"(problems: [puzzle]
planners:
  - {command: "./a\\ b 'c {d e}' {{f}} --w={w} {instance} ''", format: kei18, motion: following, set: {w: 1.5}}
)")
                              .planners;
    ASSERT_EQ(planners.size(), 1U);
    EXPECT_EQ(planners[0].name, "a b");
    ASSERT_TRUE(planners[0].command);
    const OutsideCommand &command = *planners[0].command;
    EXPECT_THAT(command.words, ElementsAre("./a b", "c {d e}", "{{f}}", "--w={w}", "{instance}", ""));
    EXPECT_EQ(command.answerFormat, "kei18_result");
    EXPECT_EQ(command.motion, MotionRule::following);
    EXPECT_THAT(placesIn(command.words), ElementsAre("w", "instance"));
    EXPECT_EQ(fillPlaces("{{f}}{w}}", [](const std::string &name) { return "<" + name + ">"; }), "{f}<w>}");
}

TEST(PlanReader, aSweptSettingMakesPlannersOfItsOwn)
{
    const auto planners = plan("problems: [puzzle]\nplanners: [{planner: walker, name: w, set: {order: "
                               "near_first, pace: [1, 3]}}, "
                               "{command: 'x {instance} {a}', set: {a: {from: 2, to: 6, step: 2}}}]")
                              .planners;
    ASSERT_EQ(planners.size(), 5U);
    EXPECT_EQ(planners[0].name, "w pace=1");
    EXPECT_EQ(planners[1].name, "w pace=3");
    EXPECT_EQ(planners[1].settings.at(1).second, "3");
    EXPECT_EQ(planners[3].name, "x a=4");
    EXPECT_EQ(planners[3].settings.back().second, "4");
}

class PlanReaderRefusesLine : public PlanReaderRefuses
{};

TEST_P(PlanReaderRefusesLine, afterAGoodStart)
{
    const std::string expected =
        std::string("folder/my_plan.yaml:3:") + GetParam().place + ": " + GetParam().complaint;
    const std::string complaint = complaintAbout(goodExcept(GetParam().text));
    EXPECT_EQ(complaint.substr(0, expected.size()), expected) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    others, PlanReaderRefusesLine,
    ::testing::Values(
        BadPlan{"campaign: a/b", "11", "'a/b' cannot name a campaign"},
        BadPlan{"campaign: ..", "11", "'..' cannot name a campaign"},
        BadPlan{"campaign:", "1", "'campaign' takes one value"},
        BadPlan{"campaign: [a]", "11", "'campaign' takes one value"},
        BadPlan{"seed: -1", "7", "'seed' takes a whole number from 0"},
        BadPlan{"seed: 1.5", "7", "'seed' takes a whole number"},
        BadPlan{"seed: 99999999999999999999", "7", "'seed' takes a whole number"},
        BadPlan{"repetitions: 0", "14", "'repetitions' takes a whole number from 1 to 1000000, but is '0'"},
        BadPlan{"repetitions: 010", "14", "'010' may be read as an octal"},
        BadPlan{"repetitions: many", "14", "'repetitions' takes a whole number"},
        BadPlan{"limits: 60", "9", "'limits' takes a map"},
        BadPlan{"limits: {time: 60}", "16", "'time' takes a number and a unit, as in 500 ms, 60 s"},
        BadPlan{"limits: {time: 60 seconds}", "16", "'time' takes a number and a unit"},
        BadPlan{"limits: {time: 0 s}", "16", "'time' is '0 s', which is no sensible limit"},
        BadPlan{"limits: {time: -5 s}", "16", "'time' is '-5 s', which is no sensible limit"},
        BadPlan{"limits: {time: s}", "16", "'time' takes a number and a unit"},
        BadPlan{"limits: {memory: 4 gb}", "18", "'memory' takes a number and a unit"},
        BadPlan{"limits: {tme: 4 s}", "10", "unknown key 'tme' in limits; did you mean 'time'?"},
        BadPlan{"optimizers: [shortn]", "14", "there is no optimizer 'shortn'; did you mean 'shorten'?"},
        BadPlan{"optimizers: []", "13", "'optimizers' is an empty list"},
        BadPlan{"optimizers: [{optimizer: shorten, set: {rounds: 0}}]", "49",
                "parameter 'rounds' must lie in"},
        BadPlan{"reports: [pdff]", "11", "there is no report 'pdff'"},
        BadPlan{"reports: [csv, csv]", "16", "the report 'csv' stands twice"},
        BadPlan{"reports: [{chart: {x: robot, y: time}}]", "23",
                "there is no numeric column or swept variable 'robot'"},
        BadPlan{"reports: [{chart: {x: robots, z: time}}]", "31", "unknown key 'z' in a chart"},
        BadPlan{"reports: [{chart: {y: time}}]", "19", "a chart of the kind 'curves' needs 'x'"},
        BadPlan{"reports: [{chart: {kind: boxes, y: time, log: [z]}}]", "48", "there is no axis 'z'"},
        BadPlan{"reports: [{chart: {kind: ecdf, x: robots, y: time}}]", "19",
                "a chart of the kind 'ecdf' needs no 'x'"},
        BadPlan{"reports: [{chart: {kind: pie, y: time}}]", "26", "there is no kind of chart 'pie'"},
        BadPlan{"reports: csv", "10", "'reports' takes a list"},
        BadPlan{"motion: pebbles", "9", "there is no motion rule 'pebbles'; known: pebble"},
        BadPlan{"execution: {jobs: 0}", "19", "'jobs' takes a whole number from 1"},
        BadPlan{"execution: {isolation: docker}", "24", "'isolation' takes none or process"},
        BadPlan{"execution: 2", "12", "'execution' takes a map"},
        BadPlan{"keep: {solutions: maybe}", "19", "'solutions' takes true or false"},
        BadPlan{"keep: {everything: true}", "8", "unknown key 'everything' in keep"},
        BadPlan{"explorer: {solutions: frist}", "23",
                "'solutions' takes first, all or none, but is 'frist'; did you mean 'first'?"},
        BadPlan{"explorer: {size: 10}", "18", "'size' takes a number and a unit, as in 500 kB, 10 MB"},
        BadPlan{"explorer: all", "11", "'explorer' takes a map"},
        BadPlan{"sed: 1", "1", "unknown key 'sed' in a plan; did you mean 'seed'?"}));

TEST(PlanReader, aFileNameThatNamesNoCampaignMustBeReplaced)
{
    Catalog catalog = test::makeCatalog();
    const std::string text = "problems: [puzzle]\nplanners: [runner]\n";
    EXPECT_THROW((void)parsePlan(text, "my plan.yaml", catalog), PlanError);
    EXPECT_EQ(parsePlan("campaign: mine\n" + text, "my plan.yaml", catalog).campaign, "mine");
}

TEST(PlanReader, aMissingFileIsAFileError)
{
    Catalog catalog = test::makeCatalog();
    EXPECT_THROW((void)readPlan("no/such/plan.yaml", catalog), FileError);
}

} // namespace
} // namespace mrpp
