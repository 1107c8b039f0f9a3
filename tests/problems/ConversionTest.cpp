/// From every format to every other that can express the same, and what is said about the rest.

#include "problems/formats/Conversion.h"

#include "framework/system/File.h"
#include "problems/formats/Formats.h"
#include "problems/formats/SolutionCsv.h"
#include "problems/formats/Surynek.h"

#include "tests/problems/FormatCases.h"

#include <unistd.h>

namespace mrpp
{
namespace
{

constexpr const char *kMap = "type octile\nheight 2\nwidth 4\nmap\n....\n.@..\n";

class ConversionFolder : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("mrpp_conversion_" + std::to_string(::getpid())) / test->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        writeFile(at("room.map"), kMap);
        const auto graph = loadGraph(at("room.map")).graph;
        instance_ = {graph, {0, 6}, {2, 3}};
        saveInstance(at("room-even-1.scen"), instance_, at("room.map"));
        writeFile(at("moves.csv"), formatSolutionCsv(Schedule({{0, 0, 1}, {1, 6, 3}, {0, 1, 2}}, {2, 3})));
    }
    void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

    std::filesystem::path at(const std::string &name) const { return folder_ / name; }

    std::string complaint(const ConversionRequest &request) const
    {
        try
        {
            (void)convertFile(request);
        }
        catch (const InputError &error)
        {
            return error.what();
        }
        return "nothing was wrong";
    }

    std::filesystem::path folder_;
    Instance instance_;
};

TEST_F(ConversionFolder, GraphsGoThroughEveryFormat)
{
    std::filesystem::path last = at("room.map");
    for (const char *name : {"a.graphml", "b.map", "c.graphml", "d.edges", "e.col", "f.GraphML"})
    {
        EXPECT_EQ(convertFile({last, at(name), {}, {}, {}}).files, std::vector{at(name)});
        EXPECT_EQ(loadGraph(at(name)).graph->fingerprint(), instance_.graph->fingerprint()) << name;
        last = at(name);
    }
    EXPECT_THAT(convertFile({at("room.map"), at("g.col"), {}, {}, {}}).notes,
                testing::ElementsAre("lost: the vertices' coordinates"));
    EXPECT_THAT(complaint({at("f.GraphML"), at("g.map"), {}, {}, {}}),
                testing::HasSubstr("'movingai_map' cannot hold this: this graph is no grid map"));
    EXPECT_FALSE(std::filesystem::exists(at("g.map")));
    EXPECT_THAT(
        complaint({at("room.map"), at("g.instance"), {}, {}, {}}),
        testing::HasSubstr("no format with the extension '.instance' holds what can be read here; say --to "
                           "with one of: graphml"));
    EXPECT_THAT(complaint({at("room.map"), at("g"), {}, {}, "cpf"}),
                testing::HasSubstr("no instance in this file, but 'cpf' holds one"));
    EXPECT_THAT(complaint({at("room.map"), at("g"), {}, {}, "grapml"}),
                testing::HasSubstr("did you mean 'graphml'?"));
}

TEST_F(ConversionFolder, MapsKeepTheirSizeAndSymbols)
{
    const std::string map = "type octile\nheight 3\nwidth 5\nmap\n...S@\n.T..@\n@@@@@\n";
    writeFile(at("walled.map"), map);
    EXPECT_TRUE(convertFile({at("walled.map"), at("same.map"), {}, {}, {}}).notes.empty());
    EXPECT_EQ(readFile(at("same.map")), map);
    EXPECT_THAT(convertFile({at("walled.map"), at("walled.graphml"), {}, {}, {}}).notes,
                testing::ElementsAre("lost: the map's size, and what its obstacles are"));
    writeFile(at("k.txt"), "map_file=walled.map\nagents=1\n0,0,3,1\n");
    (void)convertFile({at("k.txt"), at("k.scen"), {}, {}, {}});
    EXPECT_EQ(readFile(at("k.scen")), "version 1\n0\twalled.map\t5\t3\t0\t0\t3\t1\t3.41421356\n");
    EXPECT_THAT(convertFile({at("k.scen"), at("k.yaml"), {}, {}, {}}).notes,
                testing::ElementsAre("changed: the direction of y, which grows upwards here"));
}

TEST_F(ConversionFolder, InstancesGoThroughEveryFormat)
{
    std::filesystem::path last = at("room-even-1.scen");
    for (const auto &[name, format] : std::vector<std::pair<std::string, std::string>>{
             {"a.yaml", "libmrp_instance"},
             {"b.txt", "kei18_instance"},
             {"c.instance", "instance"},
             {"d.scen", "movingai_scenario"},
             {"e.yml", "libmrp_instance"},
             {"f.cpf", "cpf"},
             {"g.instance", "instance"},
         })
    {
        const auto to = name == "b.txt" ? std::optional(format) : std::nullopt;
        EXPECT_EQ(convertFile({last, at(name), {}, {}, to}).format, format);
        EXPECT_EQ(loadInstance({at(name), {}, {}}).instance.fingerprint(), instance_.fingerprint()) << name;
        last = at(name);
    }
    EXPECT_TRUE(std::filesystem::exists(at("b.map"))); // what the YAML held in itself
    EXPECT_TRUE(std::filesystem::exists(at("g.graphml")));
    EXPECT_EQ(loadInstance({at("f.cpf"), at("room.map"), {}}).instance.graph->coordinate(1),
              (Point{1, 0, 0}));
    EXPECT_THAT(complaint({at("f.cpf"), at("x.txt"), {}, {}, "kei18_instance"}),
                testing::HasSubstr("'kei18_instance' cannot hold this"));
    writeFile(at("h.graphml"), "something else");
    EXPECT_THAT(complaint({at("f.cpf"), at("h.instance"), {}, {}, {}}),
                testing::HasSubstr("there is another file of that name"));
    EXPECT_THAT(convertFile({at("f.cpf"), at("y.graphml"), {}, {}, {}}).notes,
                testing::ElementsAre("lost: the robots"));
}

TEST_F(ConversionFolder, SolutionsGoThroughEveryFormat)
{
    const auto scenario = at("room-even-1.scen");
    std::filesystem::path last = at("moves.csv");
    const std::string before = readFile(last);
    for (const char *format : {"surynek_solution", "kei18_result", "paths", "libmrp_schedule", "tracker_csv",
                               "tracker_json", "graphrec", "graphrec_xml"})
    {
        const auto out = at(std::string("s.") + format);
        const Conversion done = convertFile({last, out, {}, scenario, format});
        EXPECT_EQ(done.notes.empty(), !std::string(format).starts_with("graphrec")) << format;
        (void)convertFile({out, at("again.csv"), {}, scenario, {}});
        EXPECT_EQ(readFile(at("again.csv")), before) << format;
        last = out;
    }
    EXPECT_EQ(convertFile({last, at("v.json"), {}, scenario, "planviz"}).format, "planviz");
    EXPECT_THAT(readFile(at("s.graphrec")), testing::HasSubstr("M:IMMEDIATE"));
    // GraphRec's text holds the instance, too
    (void)convertFile({at("s.graphrec"), at("own.csv"), {}, {}, {}});
    EXPECT_EQ(readFile(at("own.csv")), before);
    (void)convertFile({at("s.graphrec"), at("own.cpf"), {}, {}, {}});
    EXPECT_EQ(readFile(at("own.cpf")), formatCpf(instance_));

    EXPECT_THAT(complaint({at("moves.csv"), at("s.txt"), {}, {}, "paths"}), testing::HasSubstr("--instance"));
    EXPECT_THAT(complaint({at("moves.csv"), at("s.txt"), {}, scenario, {}}),
                testing::HasSubstr("several formats have the extension '.txt'; say --to with one of: "
                                   "surynek_solution, kei18_result, paths, graphrec"));
    writeFile(at("bad.csv"), "step,robot,from,to\n0,0,0,5\n");
    EXPECT_THAT(complaint({at("bad.csv"), at("s.txt"), {}, scenario, "paths"}),
                testing::HasSubstr("bad.csv:2: step 0: robot 0"));
    (void)convertFile({scenario, at("x.instance"), {}, {}, {}});
    EXPECT_THAT(complaint({at("moves.csv"), at("s.json"), {}, at("x.instance"), "tracker_json"}),
                testing::HasSubstr("'tracker_json' cannot hold this: the tracker wants to know"));
}

} // namespace
} // namespace mrpp
