/// Instance text, solutions, animations, and the one door to all formats.

#include "problems/formats/Formats.h"

#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/Problems.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphRec.h"
#include "problems/formats/InstanceText.h"
#include "problems/formats/SolutionCsv.h"

#include <ctime>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

std::shared_ptr<const Graph> path(std::size_t vertices)
{
    std::vector<Graph::Edge> edges;
    for (Vertex v = 0; v + 1 < vertices; ++v)
        edges.push_back({v, v + 1});
    return Graph::fromEdges(vertices, edges);
}

/// A folder of its own for each test.
class FormatsFolder : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) / ("mrpp_formats_" + std::to_string(::getpid())) /
                  test->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_ / "maps");
    }
    void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

    std::filesystem::path write(const std::string &name, const std::string &contents) const
    {
        writeFile(folder_ / name, contents);
        return folder_ / name;
    }

    /// The message with which `work` ends.
    template <class Work>
    static std::string complaint(Work &&work)
    {
        try
        {
            work();
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "nothing was wrong";
    }

    std::filesystem::path folder_;
};

// Instance text

TEST(InstanceText, ReadsThePapersFigure2)
{
    const InstanceText text = parseInstanceText("graph =//Graph.xml\n"
                                                "agent: start = 0, goal = 2\n"
                                                "agent: start = 2, goal = 3\n",
                                                "dir/figure2.instance");
    EXPECT_EQ(text.graph, "Graph.xml");
    EXPECT_EQ(text.graphPath(), std::filesystem::path("dir/Graph.xml"));
    const Instance instance = textInstance(text, path(4));
    EXPECT_EQ(instance.starts, (std::vector<Vertex>{0, 2}));
    EXPECT_EQ(instance.goals, (std::vector<Vertex>{2, 3}));
    EXPECT_THROW((void)textInstance(text, path(3)), ParseError); // the paper's own graph has no vertex 3
}

TEST(InstanceText, BlanksAreFree)
{
    const InstanceText text = parseInstanceText("\xEF\xBB\xBF\n  graph=my graph.gml \r\n\r\n"
                                                "agent:start=0,goal=1\r\n\tagent : start = 1 , goal = 0  ",
                                                "i");
    EXPECT_EQ(text.graph, "my graph.gml");
    const Instance instance = textInstance(text, path(2));
    EXPECT_EQ(instance.starts, (std::vector<Vertex>{0, 1}));
    EXPECT_EQ(instance.goals, (std::vector<Vertex>{1, 0}));
}

RC_GTEST_PROP(InstanceText, ComesBackAsItWasWritten, ())
{
    const auto count = *rc::gen::inRange<Vertex>(1, 60);
    const auto distinct = [count]
    { return *rc::gen::unique<std::vector<Vertex>>(rc::gen::inRange<Vertex>(0, count)); };
    Instance instance{path(count), distinct(), distinct()};
    const std::size_t robots = std::min(instance.starts.size(), instance.goals.size());
    instance.starts.resize(robots);
    instance.goals.resize(robots);
    const InstanceText text = parseInstanceText(formatInstanceText(instance, "a b.graphml"), "i");
    RC_ASSERT(text.graph == "a b.graphml");
    const Instance again = textInstance(text, instance.graph);
    RC_ASSERT(again.starts == instance.starts);
    RC_ASSERT(again.goals == instance.goals);
}

// Solutions

TEST(SolutionCsv, ARotationIsOneStep)
{
    Solution solution;
    solution.append({0, 3, 4});
    const std::vector<Move> cycle = {{0, 4, 5}, {1, 5, 6}, {2, 6, 4}};
    solution.appendRotation(cycle);
    solution.append({1, 6, 7});
    EXPECT_EQ(formatSolutionCsv(solution),
              "step,robot,from,to\n0,0,3,4\n1,0,4,5\n1,1,5,6\n1,2,6,4\n2,1,6,7\n");
    EXPECT_EQ(formatSolutionCsv(Solution()), "step,robot,from,to\n");
}

TEST(SolutionCsv, AStepOfAScheduleIsAStep)
{
    Schedule schedule;
    schedule.appendStep(std::vector<Move>{{1, 0, 1}, {0, 5, 6}});
    schedule.appendStep({});
    schedule.appendStep(std::vector<Move>{{0, 6, 7}});
    EXPECT_EQ(formatSolutionCsv(schedule), "step,robot,from,to\n0,1,0,1\n0,0,5,6\n1,0,6,7\n");
}

TEST(SolutionCsv, RowsAreReadAsTheyAre)
{
    const SolutionRows rows =
        parseSolutionCsv("\xEF\xBB\xBFstep, robot, from, to\r\n7, -1 ,0,99\r\n-3,0,0,0\r\n\r\n", "s.csv");
    ASSERT_EQ(rows.moves.size(), 2);
    EXPECT_EQ(rows.moves[0].step, 7);
    EXPECT_EQ(rows.moves[0].robot, -1);
    EXPECT_EQ(rows.moves[0].to, 99);
    EXPECT_EQ(rows.moves[1].step, -3);
    EXPECT_EQ(rows.lineOf(0), 2);
    EXPECT_EQ(rows.lineOf(1), 3);
    EXPECT_TRUE(parseSolutionCsv("step,robot,from,to", "s.csv").moves.empty());
}

RC_GTEST_PROP(SolutionCsv, ComesBackAsItWasWritten, ())
{
    const auto number = rc::gen::arbitrary<std::uint32_t>();
    const auto move = rc::gen::construct<Move>(number, number, number);
    Schedule schedule;
    for (const auto &step : *rc::gen::container<std::vector<std::vector<Move>>>(
             rc::gen::nonEmpty(rc::gen::container<std::vector<Move>>(move))))
        schedule.appendStep(step);
    const SolutionRows rows = parseSolutionCsv(formatSolutionCsv(schedule), "s.csv");
    RC_ASSERT(rows.moves.size() == schedule.pathLength());
    std::size_t row = 0;
    for (std::size_t s = 0; s < schedule.makespan(); ++s)
        for (const Move &expected : schedule.step(s))
        {
            RC_ASSERT(rows.moves[row].step == static_cast<std::int64_t>(s));
            RC_ASSERT(rows.moves[row].robot == expected.robot);
            RC_ASSERT(rows.moves[row].from == expected.from);
            RC_ASSERT(rows.moves[row].to == expected.to);
            ++row;
        }
}

TEST(SolutionCsv, AMillionRowsTakeNoTime)
{
    Solution solution;
    for (std::uint32_t i = 0; i < 1000000; ++i)
        solution.append({i % 600, i, i + 1});
    const std::clock_t begin = std::clock(); // the processor's time: other programs do not count
    const std::string text = formatSolutionCsv(solution);
    const std::clock_t middle = std::clock();
    EXPECT_EQ(parseSolutionCsv(text, "s.csv").moves.size(), 1000000);
    const std::clock_t end = std::clock();
    const double writing = static_cast<double>(middle - begin) / CLOCKS_PER_SEC;
    const double reading = static_cast<double>(end - middle) / CLOCKS_PER_SEC;
    RecordProperty("writing_ms", static_cast<int>(writing * 1000));
    RecordProperty("reading_ms", static_cast<int>(reading * 1000));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(writing, 0.4); // 0.05 s on a free machine
    EXPECT_LT(reading, 1.0); // 0.15 s on a free machine
#endif
}

// GraphRec

TEST(GraphRec, WritesGraphRobotsAndSteps)
{
    const auto graph = Graph::fromEdges(3, std::vector<Graph::Edge>{{0, 1}, {1, 2}, {0, 2}},
                                        {{0, 0, 0}, {1, 0, 0}, {0.5, 0.866025, 0}});
    const Instance instance{graph, {0, 2}, {2, 1}};
    Schedule schedule;
    schedule.appendStep(std::vector<Move>{{0, 0, 1}});
    schedule.appendStep({});
    schedule.appendStep(std::vector<Move>{{1, 2, 0}, {0, 1, 2}});
    EXPECT_EQ(formatGraphRec(instance, schedule), "id:1\n"
                                                  "V =\n"
                                                  "(1:0)[1:0:0]\n"
                                                  "(2:0)[0:2:2]\n"
                                                  "(3:0)[2:1:1]\n"
                                                  "E =\n"
                                                  "{1,2} (0)\n"
                                                  "{1,3} (0)\n"
                                                  "{2,3} (0)\n"
                                                  "MOD =\n"
                                                  "M:TRANSITIVE\n"
                                                  "POS =\n"
                                                  "1:X0.00:Y0.00\n"
                                                  "2:X60.00:Y0.00\n"
                                                  "3:X30.00:Y-51.96\n"
                                                  "Solution\n"
                                                  "1 ---> 2 (0)\n"
                                                  "3 ---> 1 (1)\n"
                                                  "2 ---> 3 (1)\n"
                                                  "Length:3\n");
}

TEST(GraphRec, LeavesTheLayoutToGraphRecWhereThereIsNone)
{
    const std::string text = formatGraphRec({path(2), {}, {}}, Schedule());
    EXPECT_THAT(text, testing::Not(HasSubstr("POS =")));
    EXPECT_THAT(text, HasSubstr("Solution\nLength:0\n"));
}

TEST(GraphRec, WritesFixedNotationWhateverTheCoordinates)
{
    const auto graph = Graph::fromEdges(3, std::vector<Graph::Edge>{{0, 1}},
                                        {{0, 1e-9, 0}, {1e12, 0, 0}, {-1e-9, 1e15, 0}}, YAxis::down);
    const std::string text = formatGraphRec({graph, {}, {}}, Schedule());
    const std::string positions = text.substr(text.find("POS ="), text.find("Solution") - text.find("POS ="));
    EXPECT_EQ(positions, "POS =\n1:X0.00:Y0.00\n2:X60.00:Y0.00\n3:X0.00:Y60000.00\n");
}

// All formats

constexpr const char *kMap = "type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n";

TEST_F(FormatsFolder, TellsFilesByTheirContents)
{
    const std::string graphMl = formatGraphMl(*path(3));
    for (const char *name : {"a.graphml", "a.xml", "a.gml", "a.txt", "a.map"})
    {
        EXPECT_EQ(loadGraph(write(name, graphMl)).graph->vertexCount(), 3) << name;
        EXPECT_FALSE(loadGraph(write(name, graphMl)).map) << name;
    }
    for (const char *name : {"b.map", "b.txt", "b"})
    {
        EXPECT_EQ(loadGraph(write(name, kMap)).graph->vertexCount(), 5) << name;
        EXPECT_TRUE(loadGraph(write(name, kMap)).map) << name;
    }
}

TEST_F(FormatsFolder, TellsOtherProgramsFilesByTheirContents)
{
    const auto vertices = [this](const std::string &contents)
    { return loadGraph(write("some.file", contents)).graph->vertexCount(); };
    EXPECT_EQ(vertices("\nc words\np edge 4 1\ne 1 2\n"), 4);
    EXPECT_EQ(vertices("# words\n0 1\n1 2\n"), 3);
    EXPECT_EQ(vertices("0,1,2.5\n"), 2);
    EXPECT_EQ(vertices("words\nV =\n(0:0)[0:0:0]\nE =\n"), 1);
    EXPECT_EQ(vertices("agents: []\nmap:\n  dimensions: [3, 2]\n"), 6);
    EXPECT_EQ(vertices("id:1\nV =\n(1:0)[0:0:0]\nE =\nLength:0"), 1);
    EXPECT_EQ(vertices("V =\n(1:0)[0:0:0]\nE =\nLength:0"), 1);
    EXPECT_EQ(
        vertices("<!DOCTYPE graphrec>\n<graphrec version=\"1.0\"><solution><graph><node id=\"1\"/></graph>"
                 "</solution></graphrec>"),
        1);
    // A scenario without its version line is none of numbers alone.
    write("8room.map", kMap);
    EXPECT_EQ(loadInstance({write("old.scen", "0\t8room.map\t3\t2\t0\t1\t2\t1\t4\n"), {}, {}})
                  .instance.robotCount(),
              1);
}

TEST_F(FormatsFolder, SaysWhichFormatsAreKnown)
{
    const auto graph = [this](const char *name, const char *contents)
    { return complaint([&] { (void)loadGraph(write(name, contents)); }); };
    EXPECT_THAT(graph("g.txt", "hello\n"), HasSubstr("a graph is a MovingAI map (.map), GraphML"));
    EXPECT_THAT(graph("g.csv", "step,robot,from,to\n"), HasSubstr("this is a solution as CSV, no graph"));
    EXPECT_THAT(graph("g", ""), HasSubstr("of no known format"));
    EXPECT_THAT(graph("g.gml", "graph [\n node [ id 0 ] ]\n"),
                HasSubstr("g.gml:1:1: this is GML (the bracketed format)"));
    EXPECT_THAT(graph("g.map", ""), HasSubstr("g.map:1:1: the file ends within the header"));
    EXPECT_THAT(graph("g.instance", "graph = x\n"), HasSubstr("this is instance text, no graph"));
    EXPECT_THAT(complaint([this] { (void)loadGraph(folder_ / "none.map"); }),
                HasSubstr("there is no such file"));
    EXPECT_THAT(complaint([this] { (void)loadGraph(folder_); }), HasSubstr("is a folder"));

    const auto instance = [this](const char *name, const char *contents) {
        return complaint([&] { (void)loadInstance({write(name, contents), {}, {}}); });
    };
    EXPECT_THAT(instance("i.yaml", "map: x\n"), HasSubstr("expected a map with the key 'dimensions'"));
    EXPECT_THAT(instance("i.txt", "hello\n"), HasSubstr("or a MovingAI scenario (.scen)"));
    EXPECT_THAT(instance("i.map", kMap), HasSubstr("this is a MovingAI map, no instance"));
    EXPECT_THAT(instance("i.instance", ""), HasSubstr("i.instance:1:1: the file is empty"));
    EXPECT_THAT(instance("i.instance", "agent: start = 0, goal = 1\n"), HasSubstr("names no graph"));
    EXPECT_THAT(instance("i.instance", "\ngraph = none.graphml\n"),
                HasSubstr("i.instance:2:1: there is no file 'none.graphml'"));
    EXPECT_THAT(instance("i.scen", "version 1\n0 none.map 3 2 0 0 1 0 1\n"),
                HasSubstr("'none.map' does not lie"));
}

TEST_F(FormatsFolder, AnInstanceFindsItsGraph)
{
    write("g.graphml", formatGraphMl(*path(3)));
    write("maps/h.graphml", formatGraphMl(*path(4)));
    const std::string agents = "agent: start = 0, goal = 2\nagent: start = 1, goal = 0\n";
    const auto vertices = [&](const std::string &graph)
    {
        return loadInstance({write("i.instance", "graph = " + graph + "\n" + agents), {}, {}})
            .instance.graph->vertexCount();
    };
    EXPECT_EQ(vertices("g.graphml"), 3);
    EXPECT_EQ(vertices("//g.graphml"), 3);
    EXPECT_EQ(vertices("maps/h.graphml"), 4);
    EXPECT_EQ(vertices("/home/somebody/else/g.graphml"), 3);
    EXPECT_EQ(vertices((folder_ / "maps/h.graphml").string()), 4);
    EXPECT_EQ(graphFileOf(write("i.instance", "graph = g.graphml\n" + agents)), folder_ / "g.graphml");
    EXPECT_EQ(graphFileOf(write("i.instance", agents)), std::nullopt);

    const auto named = write("i.instance", "graph = g.graphml\n" + agents);
    EXPECT_EQ(loadInstance({named, folder_ / "maps/h.graphml", {}}).instance.graph->vertexCount(), 4);
    EXPECT_EQ(loadInstance({named, {}, 1}).instance.starts, std::vector<Vertex>{0});
    EXPECT_THAT(complaint(
                    [&] {
                        (void)loadInstance({named, {}, 3});
                    }),
                HasSubstr("there are 2 agents, fewer than"));

    const auto onMap = write("j.instance", agents);
    EXPECT_EQ(loadInstance({onMap, write("room.map", kMap), {}}).instance.graph->vertexCount(), 5);
}

TEST_F(FormatsFolder, AScenarioFindsItsMap)
{
    const auto map = write("maps/room.map", kMap);
    const auto scenario = write(
        "room.scen", "version 1\n0\tx/room.map\t3\t2\t0\t1\t2\t1\t4\n0\tx/room.map\t3\t2\t1\t0\t0\t0\t1\n");
    EXPECT_EQ(loadInstance({scenario, map, 1}).instance.goals, std::vector<Vertex>{4});
    EXPECT_EQ(loadInstance({scenario, map, {}}).instance.robotCount(), 2);
    EXPECT_THAT(complaint([&] { (void)loadInstance({scenario, {}, {}}); }), HasSubstr("name the map's file"));
    write("room.map", kMap);
    EXPECT_EQ(loadInstance({scenario, {}, {}}).instance.robotCount(), 2);
    EXPECT_EQ(graphFileOf(scenario), folder_ / "room.map");
    const auto graphMl = write("g.graphml", formatGraphMl(*path(9)));
    EXPECT_THAT(complaint(
                    [&] {
                        (void)loadInstance({scenario, graphMl, {}});
                    }),
                HasSubstr("needs a MovingAI map"));
}

TEST_F(FormatsFolder, SavesWhatItLoads)
{
    const LoadedGraph room = loadGraph(write("room.map", kMap));
    const Instance instance{room.graph, {0, 3}, {4, 0}};
    saveGraph(folder_ / "maps/room.graphml", *room.graph);
    saveGraph(folder_ / "maps/room.map", *room.graph);
    EXPECT_EQ(readFile(folder_ / "maps/room.map"), kMap);
    for (const char *graph : {"maps/room.graphml", "maps/room.map", "room.map"})
    {
        saveInstance(folder_ / "out/i.instance", instance, folder_ / graph);
        const Instance again = loadInstance({folder_ / "out/i.instance", {}, {}}).instance;
        EXPECT_EQ(again.fingerprint(), instance.fingerprint()) << graph;
        EXPECT_EQ(again.graph->yAxis(), YAxis::down) << graph;
    }
    EXPECT_THAT(readFile(folder_ / "out/i.instance"), HasSubstr("graph = ../room.map\n"));
    saveInstance(folder_ / "maps/i.scen", instance, folder_ / "room.map");
    EXPECT_EQ(loadInstance({folder_ / "maps/i.scen", {}, {}}).instance.fingerprint(), instance.fingerprint());
    EXPECT_THROW(saveGraph(folder_ / "path.map", *path(3)), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "path.map"));

    FileSet files;
    saveSolution(files, folder_ / "s.csv", Solution({{0, 0, 1}, {0, 1, 2}}));
    saveSolution(files, folder_ / "t.csv", Schedule({{0, 0, 1}}, {1}));
    files.commit();
    EXPECT_EQ(readFile(folder_ / "s.csv"), "step,robot,from,to\n0,0,0,1\n1,0,1,2\n");
    EXPECT_EQ(readSolutionCsv(folder_ / "t.csv").moves.size(), 1);
    saveAnimation(folder_ / "a.txt", instance, Schedule({{0, 0, 1}}, {1}));
    EXPECT_THAT(readFile(folder_ / "a.txt"), testing::EndsWith("1 ---> 2 (0)\nLength:1\n"));
}

TEST_F(FormatsFolder, AScenarioOfAGraphWithOtherNumbersKeepsItsCells)
{
    // The same cells as the map's, numbered backwards.
    const auto backwards = Graph::fromEdges(3, std::vector<Graph::Edge>{{0, 1}, {1, 2}},
                                            {{2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, YAxis::down);
    saveInstance(folder_ / "i.scen", {backwards, {0}, {2}}, "i.map");
    saveGraph(folder_ / "i.map", *backwards);
    const Instance again = loadInstance({folder_ / "i.scen", {}, {}}).instance;
    EXPECT_EQ(again.graph->coordinate(again.starts[0]), (Point{2, 0, 0}));
    EXPECT_EQ(again.graph->coordinate(again.goals[0]), (Point{0, 0, 0}));
}

TEST(Formats, AreListedInTheCatalog)
{
    Catalog catalog;
    registerProblems(catalog);
    std::set<std::string> names;
    for (const FileFormat &format : catalog.formats)
    {
        names.insert(format.name);
        EXPECT_TRUE(format.reads || format.writes) << format.name;
        EXPECT_FALSE(format.description.empty()) << format.name;
    }
    EXPECT_EQ(names, (std::set<std::string>{"cpf",
                                            "dimacs",
                                            "edge_list",
                                            "graphml",
                                            "graphrec",
                                            "graphrec_xml",
                                            "instance",
                                            "kei18_instance",
                                            "kei18_result",
                                            "libmrp_instance",
                                            "libmrp_map",
                                            "libmrp_roadmap",
                                            "libmrp_schedule",
                                            "matrix_market",
                                            "movingai_map",
                                            "movingai_scenario",
                                            "paths",
                                            "planviz",
                                            "planviz_2_0",
                                            "solution",
                                            "surynek_solution",
                                            "tracker_csv",
                                            "tracker_json",
                                            "vetand_instance",
                                            "vetand_result"}));
    for (const char *model : {"fully_controlled", "small_benchmark", "public_benchmark"})
        EXPECT_NE(catalog.problems.find(model), nullptr) << model;
}

} // namespace
} // namespace mrpp
