/// The families whose instances come from files.

#include "framework/analysis/Components.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/FullyControlled.h"
#include "problems/PublicBenchmark.h"
#include "problems/formats/Formats.h"
#include "problems/formats/GraphMl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace mrpp
{
namespace
{

using testing::HasSubstr;

using Settings = std::vector<std::pair<std::string, std::string>>;

Config config(const Settings &settings)
{
    std::vector<Config::Entry> entries;
    for (const auto &[key, value] : settings)
    {
        Config::Entry &entry = entries.emplace_back();
        entry.key = key;
        entry.where = {"plan.yaml", 4, 7};
        entry.value = Config::scalar(value, {"plan.yaml", 4, 20});
    }
    return Config::map(std::move(entries), {"plan.yaml", 4, 5});
}

/// Two rooms of 3 x 3 and 2 x 3 cells that nothing joins.
constexpr const char *kTwoRooms = "type octile\nheight 3\nwidth 6\nmap\n...@..\n...@..\n...@..\n";

class Families : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("mrpp_families_" + std::to_string(::getpid())) / test->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        writeFile(folder_ / "rooms.map", kTwoRooms);
        writeFile(folder_ / "path.graphml", formatGraphMl(*Graph::fromEdges(3, {{0, 1}, {1, 2}})));
        writeFile(folder_ / "path.instance", "graph = path.graphml\nagent: start = 0, goal = 1\n"
                                             "agent: start = 1, goal = 2\n");
        writeFile(folder_ / "rooms.scen", "version 1\n0\trooms.map\t6\t3\t0\t0\t2\t2\t2.8\n"
                                          "0\trooms.map\t6\t3\t1\t0\t0\t0\t1\n"
                                          "0\trooms.map\t6\t3\t0\t0\t1\t1\t1\n");
    }
    void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

    template <class Family>
    std::unique_ptr<Family> make(const Settings &settings) const
    {
        auto problem = std::make_unique<Family>();
        problem->configure(config(settings), {nullptr, {folder_}});
        return problem;
    }

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

TEST_F(Families, FullyControlledReadsGraphAndInstance)
{
    for (const Settings &settings : {Settings{{"graph", "path.graphml"}, {"instance", "path.instance"}},
                                     Settings{{"instance", "path.instance"}}})
    {
        const auto problem = make<FullyControlled>(settings);
        problem->check();
        EXPECT_EQ(problem->name(), "path");
        EXPECT_FALSE(problem->takesRobotCount());
        EXPECT_EQ(problem->inputFiles(), (std::vector{folder_ / "path.graphml", folder_ / "path.instance"}));
        const auto graph = problem->makeGraph(3);
        EXPECT_EQ(problem->robotCount(*graph), 2);
        const Instance instance = problem->makeInstance(graph, 2, 5);
        EXPECT_EQ(instance.graph, graph);
        EXPECT_EQ(instance.starts, (std::vector<Vertex>{0, 1}));
        EXPECT_EQ(instance.goals, (std::vector<Vertex>{1, 2}));
        EXPECT_THROW((void)problem->makeInstance(graph, 3, 5), InputError);
    }
    FullyControlled scalar;
    scalar.configure(Config::scalar("path.instance"), {nullptr, {folder_}});
    scalar.check();
}

TEST_F(Families, FullyControlledTakesAScenarioOnAMap)
{
    writeFile(folder_ / "two.scen", "version 1\n0\trooms.map\t6\t3\t0\t0\t2\t2\t2.8\n");
    const auto problem = make<FullyControlled>({{"graph", "rooms.map"}, {"instance", "two.scen"}});
    problem->check();
    EXPECT_EQ(problem->makeInstance(problem->makeGraph(0), 1, 0).goals, std::vector<Vertex>{12});
}

TEST_F(Families, SettingsAreCheckedBeforeFiles)
{
    EXPECT_THAT(complaint(
                    [this] {
                        (void)make<FullyControlled>({{"graph", "path.graphml"}});
                    }),
                HasSubstr("plan.yaml:4:5: fully_controlled needs an 'instance'"));
    EXPECT_THAT(complaint(
                    [this] {
                        (void)make<PublicBenchmark>({{"robots", "3"}});
                    }),
                HasSubstr("plan.yaml:4:5: public_benchmark needs a 'map'"));
    EXPECT_THAT(complaint(
                    [this] {
                        (void)make<PublicBenchmark>({{"mpa", "rooms.map"}});
                    }),
                HasSubstr("plan.yaml:4:7: unknown key 'mpa'; did you mean 'map'?"));
    EXPECT_THAT(complaint(
                    [this] {
                        (void)make<FullyControlled>({{"instance", "i"}, {"robots", "3"}});
                    }),
                HasSubstr("unknown key 'robots'"));
    EXPECT_THAT(complaint(
                    [this] {
                        (void)make<PublicBenchmark>({{"map", "rooms.map"}, {"passability", "lor"}});
                    }),
                HasSubstr("did you mean 'lorr'?"));
}

TEST_F(Families, FilesAreOpenedByCheckOnly)
{
    const auto controlled = make<FullyControlled>({{"instance", "none.instance"}});
    EXPECT_EQ(controlled->name(), "none");
    EXPECT_THAT(complaint([&] { controlled->check(); }), HasSubstr("there is no such file"));

    const auto map = make<PublicBenchmark>({{"map", "none.map"}, {"robots", "3"}});
    EXPECT_EQ(map->name(), "none");
    EXPECT_EQ(map->inputFiles(), std::vector{folder_ / "none.map"});
    EXPECT_THAT(complaint([&] { map->check(); }), HasSubstr("none.map: there is no such map"));
    EXPECT_THAT(complaint([&] { map->check(); }), HasSubstr("https://movingai.com/benchmarks"));
}

TEST_F(Families, CheckSaysWhereAFileIsMalformed)
{
    writeFile(folder_ / "path.instance", "graph = path.graphml\nagent: start = 0, goal = 3\n");
    EXPECT_THAT(complaint(
                    [this] {
                        make<FullyControlled>({{"instance", "path.instance"}})->check();
                    }),
                HasSubstr("path.instance:2:26: there is no vertex 3"));
    writeFile(folder_ / "rooms.map", "type octile\nheight 3\nwidth 6\nmap\n...@..\n...@.\n...@..\n");
    EXPECT_THAT(complaint(
                    [this] {
                        make<PublicBenchmark>({{"map", "rooms.map"}, {"robots", "1"}})->check();
                    }),
                HasSubstr("rooms.map:6:6: the row has 5 cells"));
}

TEST_F(Families, PublicBenchmarkDrawsRobotsInsideTheLargestComponent)
{
    const auto problem = make<PublicBenchmark>({{"map", "rooms.map"}, {"robots", "9"}});
    problem->check();
    EXPECT_EQ(problem->name(), "rooms");
    const auto graph = problem->makeGraph(0);
    const Components components(*graph);
    ASSERT_EQ(components.count(), 2);
    std::set<std::vector<Vertex>> drawn;
    for (Seed seed = 0; seed < 50; ++seed)
    {
        const Instance instance = problem->makeInstance(graph, problem->robotCount(*graph), seed);
        EXPECT_EQ(instance.defect(), std::nullopt);
        for (std::size_t r = 0; r < 9; ++r)
        {
            EXPECT_EQ(components.of(instance.starts[r]), components.largest());
            EXPECT_EQ(components.of(instance.goals[r]), components.largest());
        }
        const Instance fewer = problem->makeInstance(graph, 4, seed);
        EXPECT_TRUE(std::equal(fewer.starts.begin(), fewer.starts.end(), instance.starts.begin()));
        EXPECT_TRUE(std::equal(fewer.goals.begin(), fewer.goals.end(), instance.goals.begin()));
        EXPECT_EQ(problem->makeInstance(graph, 9, seed).starts, instance.starts);
        drawn.insert(instance.starts);
    }
    EXPECT_EQ(drawn.size(), 50);
}

TEST_F(Families, RobotsThatDoNotFitAreRefusedByCheck)
{
    const auto checked = [this](const char *key, const char *value) {
        return complaint([&] { make<PublicBenchmark>({{"map", "rooms.map"}, {key, value}})->check(); });
    };
    EXPECT_EQ(checked("robots", "9"), "nothing was wrong");
    EXPECT_THAT(checked("robots", "10"), HasSubstr("10 robots do not fit the largest component"));
    EXPECT_THAT(checked("robots", "16"), HasSubstr("does not fit a graph of 15 vertices"));
    EXPECT_EQ(checked("free", "6"), "nothing was wrong");
    EXPECT_THAT(checked("free", "2"), HasSubstr("13 robots do not fit"));
    EXPECT_EQ(checked("occupancy", "0.6"), "nothing was wrong");
    EXPECT_THAT(checked("occupancy", "0.8"), HasSubstr("12 robots do not fit"));
    EXPECT_THAT(complaint(
                    [this] {
                        make<PublicBenchmark>({{"map", "rooms.map"}})->check();
                    }),
                HasSubstr("give robots, free or occupancy"));
}

TEST_F(Families, PublicBenchmarkTakesTheFirstRecordsOfAScenario)
{
    const auto problem =
        make<PublicBenchmark>({{"map", "rooms.map"}, {"scenario", "rooms.scen"}, {"robots", "2"}});
    problem->check();
    EXPECT_EQ(problem->inputFiles(), (std::vector{folder_ / "rooms.map", folder_ / "rooms.scen"}));
    const auto graph = problem->makeGraph(0);
    const Instance instance = problem->makeInstance(graph, problem->robotCount(*graph), 4);
    EXPECT_EQ(instance.starts, (std::vector<Vertex>{0, 1}));
    EXPECT_EQ(instance.goals, (std::vector<Vertex>{12, 0}));
    EXPECT_EQ(instance.graph, graph);

    const auto checked = [this](const char *robots)
    {
        return complaint(
            [&] {
                make<PublicBenchmark>({{"map", "rooms.map"}, {"scenario", "rooms.scen"}, {"robots", robots}})
                    ->check();
            });
    };
    EXPECT_THAT(checked("3"),
                HasSubstr("rooms.scen:4:17: the start (0, 0) is the start of the record in line 2"));
    EXPECT_THAT(checked("4"), HasSubstr("rooms.scen: there are 3 records, fewer than the 4 robots"));
    EXPECT_THAT(complaint(
                    [this] {
                        make<PublicBenchmark>({{"map", "rooms.map"}, {"scenario", "rooms.scen"}})->check();
                    }),
                HasSubstr("rooms.scen:4:17"));
}

TEST(QuickstartMap, IsOneComponent)
{
    const LoadedGraph loaded =
        loadGraph(std::filesystem::path(MRPP_SOURCE_DIR) / "yaml/plans/quickstart.map");
    ASSERT_TRUE(loaded.map);
    EXPECT_EQ(loaded.map->width, 24);
    EXPECT_EQ(loaded.map->height, 16);
    EXPECT_EQ(Components(*loaded.graph).count(), 1);
}

} // namespace
} // namespace mrpp
