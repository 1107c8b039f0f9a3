/// \file
/// What every registered problem family must do.

#include "framework/analysis/Components.h"
#include "framework/system/File.h"
#include "problems/generators/Generator.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/contract/UnderLimits.h"

#include <filesystem>
#include <map>
#include <unistd.h>

namespace mrpp
{
namespace
{

const Catalog &catalog()
{
    static const Catalog kCatalog = test::everythingRegistered();
    return kCatalog;
}

Config settings(std::initializer_list<std::pair<const char *, const char *>> entries)
{
    std::vector<Config::Entry> list;
    for (const auto &[key, value] : entries)
    {
        Config::Entry entry;
        entry.key = key;
        entry.value = Config::scalar(value);
        list.push_back(std::move(entry));
    }
    return Config::map(std::move(list));
}

/// Settings of a one-factor model on a small grid.
Config onGrid(const char *key, const char *value)
{
    std::vector<Config::Entry> graph(1);
    graph.front().key = "grid";
    graph.front().value = settings({{"width", "4"}, {"height", "3"}});
    Config whole = settings({{"graph", ""}, {key, value}});
    whole.entries().front().value = Config::map(std::move(graph));
    return whole;
}

/// Settings with which a family can be tried, for files in the scratch folder. A new family adds a line.
const std::map<std::string, Config> &samples()
{
    static const std::map<std::string, Config> kSamples = {
        {"fully_controlled", settings({{"graph", "triangle.graphml"}, {"instance", "triangle.instance"}})},
        {"small_benchmark", Config::scalar("connector")},
        {"public_benchmark", settings({{"map", "room.map"}, {"robots", "4"}})},
        {"fg_vr", onGrid("free", "2")},
        {"fr_vg", onGrid("occupancy", "0.7")},
        {"biconnected", settings({{"initial_cycle", "4"}, {"handles", "3"}, {"free", "2"}})},
        {"random", settings({{"vertices", "12"}, {"edges", "17"}, {"robots", "6"}})},
        {"isthmus", settings({{"vertices", "20"}, {"longest_isthmus", "4"}, {"free", "6"}})},
        {"tree", settings({{"vertices", "15"}, {"occupancy", "0.5"}})},
        {"cycle_leaves", settings({{"cycle_size", "3"}, {"bridge_length", "2"}, {"robots", "3"}})},
        {"grid", settings({{"width", "5"}, {"height", "3"}, {"obstacles", "0.3"}, {"free", "3"}})},
        {"maze", settings({{"width", "9"}, {"height", "7"}, {"occupancy", "0.2"}})},
        {"rooms", settings({{"width", "11"}, {"height", "8"}, {"room", "3"}, {"robots", "9"}})},
        {"roadmap", settings({{"vertices", "20"}, {"robots", "6"}})},
        {"warehouse", settings({{"columns", "2"}, {"rows", "2"}, {"margin", "2"}, {"robots", "9"}})},
    };
    return kSamples;
}

class EveryProblem : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::temp_directory_path() /
                  ("mrpp-problem-contract-" + std::to_string(::getpid()) + "-" + GetParam());
        writeFile(folder_ / "triangle.graphml",
                  R"(<graphml xmlns="http://graphml.graphdrawing.org/xmlns"><graph edgedefault="undirected">
<node id="a"/><node id="b"/><node id="c"/><edge source="a" target="b"/><edge source="b" target="c"/>
<edge source="c" target="a"/></graph></graphml>)");
        writeFile(folder_ / "triangle.instance", "graph = triangle.graphml\nagent: start = 0, goal = 2\n");
        writeFile(folder_ / "room.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@..\n...@\n");
        ASSERT_TRUE(samples().contains(GetParam())) << "add sample settings for this family";
        const auto generator = makeGenerator(catalog(), GetParam());
        if (generator && !generator->missing().empty())
            GTEST_SKIP() << generator->missing();
        problem_ = make();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::unique_ptr<Problem> make() const
    {
        auto problem = catalog().problems.create(GetParam());
        problem->configure(samples().at(GetParam()), {.catalog = &catalog(), .searchPaths = {folder_}});
        return problem;
    }

    std::filesystem::path folder_;
    std::unique_ptr<Problem> problem_;
};

TEST_P(EveryProblem, MakesWellFormedInstances)
{
    test::underLimits(
        [&]
        {
            EXPECT_FALSE(problem_->name().empty());
            EXPECT_NO_THROW(problem_->check());
            for (Seed seed = 1; seed <= 20; ++seed)
            {
                const auto graph = problem_->makeGraph(seed);
                const Instance instance = problem_->makeInstance(graph, problem_->robotCount(*graph), seed);
                EXPECT_EQ(instance.graph, graph);
                EXPECT_EQ(instance.defect(), std::nullopt);
                EXPECT_EQ(instance.robotCount(), problem_->robotCount(*graph));
                const Components components(*graph);
                for (Robot r = 0; r < instance.robotCount(); ++r)
                    EXPECT_EQ(components.of(instance.starts[r]), components.of(instance.goals[r]));
            }
        });
}

TEST_P(EveryProblem, MakesTheSameInstanceForTheSameSeed)
{
    test::underLimits(
        [&]
        {
            const auto again = make();
            EXPECT_EQ(again->identity(), problem_->identity());
            const auto first = problem_->makeGraph(7);
            const auto second = again->makeGraph(7);
            EXPECT_EQ(first->fingerprint(), second->fingerprint());
            EXPECT_EQ(problem_->makeInstance(first, problem_->robotCount(*first), 8).fingerprint(),
                      again->makeInstance(second, again->robotCount(*second), 8).fingerprint());
        });
}

TEST_P(EveryProblem, ExtendsASmallerInstanceToALargerOne)
{
    test::underLimits(
        [&]
        {
            if (!problem_->takesRobotCount())
                GTEST_SKIP() << "has its own robots";
            const auto graph = problem_->makeGraph(3);
            const Instance small = problem_->makeInstance(graph, 2, 5);
            const Instance large = problem_->makeInstance(graph, 5, 5);
            for (Robot r = 0; r < 2; ++r)
            {
                EXPECT_EQ(small.starts[r], large.starts[r]);
                EXPECT_EQ(small.goals[r], large.goals[r]);
            }
            EXPECT_THROW(static_cast<void>(problem_->makeInstance(graph, graph->vertexCount() + 1, 5)),
                         InputError);
        });
}

TEST_P(EveryProblem, RefusesSettingsThatItDoesNotHave)
{
    test::underLimits(
        [&]
        {
            const auto problem = catalog().problems.create(GetParam());
            EXPECT_THROW(problem->configure(settings({{"no_such_setting", "1"}}), {.catalog = &catalog()}),
                         InputError);
            EXPECT_THROW(problem->configure(Config(), {.catalog = &catalog()}), InputError);
        });
}

TEST_P(EveryProblem, NamesTheFilesThatItReads)
{
    test::underLimits(
        [&]
        {
            for (const auto &file : problem_->inputFiles())
                EXPECT_TRUE(std::filesystem::exists(file)) << file;
            if (problem_->inputFiles().empty())
                return;
            std::filesystem::remove_all(folder_);
            EXPECT_THROW(problem_->check(), InputError);
            EXPECT_THROW(static_cast<void>(make()->makeGraph(1)), InputError);
        });
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryProblem, testing::ValuesIn(catalog().problems.names()),
                         test::nameOf);

} // namespace
} // namespace mrpp
