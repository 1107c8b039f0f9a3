/// Well-formed instances, judged by a search of each robot's own.

#include "problems/WellFormedInstance.h"
#include "framework/Catalog.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"
#include "problems/Problems.h"
#include "problems/generators/Generator.h"
#include "problems/generators/Grid.h"
#include "tests/problems/Generated.h"
#include "tests/support/BruteForce.h"
#include "tests/support/CpuClock.h"
#include "yaml/ProblemList.h"
#include "yaml/YamlConfig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <queue>
#include <set>
#include <unistd.h>

namespace mrpp::test
{
namespace
{

using ::testing::HasSubstr;

/// Whether the robot has a path that passes through no start or goal of another one.
bool hasPath(const Instance &instance, Robot robot)
{
    std::vector<bool> closed(instance.graph->vertexCount(), false);
    for (Robot other = 0; other < instance.robotCount(); ++other)
        if (other != robot)
            closed[instance.starts[other]] = closed[instance.goals[other]] = true;
    if (closed[instance.starts[robot]])
        return false;
    std::queue<Vertex> queue({instance.starts[robot]});
    closed[instance.starts[robot]] = true;
    for (; !queue.empty(); queue.pop())
    {
        if (queue.front() == instance.goals[robot])
            return true;
        for (const Vertex u : instance.graph->neighbors(queue.front()))
        {
            if (!closed[u])
                queue.push(u);
            closed[u] = true;
        }
    }
    return false;
}

bool isWellFormed(const Instance &instance)
{
    for (Robot r = 0; r < instance.robotCount(); ++r)
        if (!hasPath(instance, r))
            return false;
    return !instance.defect();
}

std::string complaintOf(const std::shared_ptr<const Graph> &graph, std::size_t robots)
{
    try
    {
        static_cast<void>(wellFormedInstance(graph, robots, 1));
    }
    catch (const DoesNotFit &error)
    {
        return error.what();
    }
    return "nothing is wrong";
}

const Catalog &catalog()
{
    static const Catalog kCatalog = []
    {
        Catalog filled;
        registerProblems(filled);
        return filled;
    }();
    return kCatalog;
}

std::vector<ProblemPoint> points(const std::string &problems)
{
    return readProblems(parseYaml("problems:\n" + problems, "plan.yaml").find("problems")->items(),
                        {.catalog = &catalog()});
}

class WellFormed : public ::testing::TestWithParam<std::string>
{};

TEST_P(WellFormed, IsWhatEveryGeneratorsRobotsAre)
{
    const auto sweep =
        points("  - fg_vr: {graph: " + GetParam() + ", robots: [1, 2, 4, 8], well_formed: true}");
    std::size_t found = 0;
    for (Seed seed = 0; seed < 20; ++seed)
    {
        const auto graph = sweep.front().problem->makeGraph(seed);
        Instance before{graph, {}, {}};
        for (const ProblemPoint &point : sweep)
        {
            try
            {
                Instance instance =
                    point.problem->makeInstance(graph, point.problem->robotCount(*graph), seed);
                ++found;
                ASSERT_TRUE(isWellFormed(instance)) << "seed " << seed;
                ASSERT_TRUE(std::equal(before.starts.begin(), before.starts.end(), instance.starts.begin()));
                ASSERT_TRUE(std::equal(before.goals.begin(), before.goals.end(), instance.goals.begin()));
                before = std::move(instance);
            }
            catch (const DoesNotFit &)
            {
                ASSERT_GT(point.problem->robotCount(*graph), 1U) << "one robot has no other in its way";
            }
        }
    }
    EXPECT_GE(found, 40U) << "one and two robots are no trouble anywhere";
}

INSTANTIATE_TEST_SUITE_P(
    Generators, WellFormed,
    ::testing::Values("{biconnected: {initial_cycle: 9, handles: 9, max_handle_length: 6}}", "random",
                      "isthmus", "tree", "{cycle_leaves: {cycle_size: 9}}",
                      "{grid: {side: 6, obstacles: 0.2}}", "maze", "rooms",
                      "{warehouse: {columns: 2, rows: 3, margin: 3}}"));

TEST(WellFormedInstance, MeetsEveryOneThatThereIs)
{
    const auto graph = make<Grid>({{"width", "3"}, {"height", "2"}})->makeGraph(1);
    std::set<std::vector<Vertex>> all;
    for (Vertex a = 0; a < 6; ++a)
        for (Vertex b = 0; b < 6; ++b)
            for (Vertex c = 0; c < 6; ++c)
                for (Vertex d = 0; d < 6; ++d)
                    if (std::set{a, b, c, d}.size() == 4 && isWellFormed({graph, {a, b}, {c, d}}))
                        all.insert({a, b, c, d});
    std::set<std::vector<Vertex>> drawn;
    for (Seed seed = 0; seed < 5000; ++seed)
    {
        const Instance instance = wellFormedInstance(graph, 2, seed);
        drawn.insert({instance.starts[0], instance.starts[1], instance.goals[0], instance.goals[1]});
    }
    EXPECT_GT(all.size(), 100U);
    EXPECT_LT(all.size(), 360U) << "some are not well-formed";
    EXPECT_EQ(drawn, all);
}

TEST(WellFormedInstance, HasASolutionOnePebbleAtATime)
{
    for (Seed seed = 0; seed < 100; ++seed)
    {
        const auto graph = make<Grid>({{"width", "4"}, {"height", "2"}})->makeGraph(seed);
        EXPECT_TRUE(isSolvable(wellFormedInstance(graph, 1 + seed % 2, seed), MotionRule::pebble)) << seed;
    }
}

TEST(WellFormedInstance, SaysWhereNoneWasFound)
{
    const auto star = Graph::fromEdges(4, {{0, 1}, {0, 2}, {0, 3}});
    EXPECT_EQ(complaintOf(star, 1), "nothing is wrong");
    EXPECT_EQ(complaintOf(star, 2),
              "no well-formed instance of 2 robots was found, only of 1 (there may be one; "
              "fewer robots are likelier)");
    EXPECT_EQ(
        complaintOf(star, 3),
        "no well-formed instance has 3 robots in a component of 4 vertices: it needs two for each robot");
    EXPECT_EQ(complaintOf(Graph::fromEdges(0, {}), 0), "nothing is wrong");
    EXPECT_THAT(complaintOf(Graph::fromEdges(0, {}), 1), HasSubstr("of 0 vertices"));
    EXPECT_THAT(complaintOf(Graph::fromEdges(1, {}), 1), HasSubstr("of 1 vertices"));
    const auto wheel = Graph::fromEdges(9, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}, {0, 7}, {0, 8}});
    EXPECT_EQ(complaintOf(wheel, 4), "nothing is wrong") << "all around, through the middle";
}

TEST(WellFormedInstance, IsOfTheLargestComponentAndTheSeed)
{
    const auto graph = Graph::fromEdges(7, {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {2, 6}});
    const Instance instance = wellFormedInstance(graph, 2, 5);
    EXPECT_TRUE(isWellFormed(instance));
    for (Robot r = 0; r < 2; ++r)
        EXPECT_TRUE(instance.starts[r] >= 2 && instance.goals[r] >= 2);
    EXPECT_EQ(instance.fingerprint(), wellFormedInstance(graph, 2, 5).fingerprint());
    EXPECT_EQ(wellFormedInstance(make<Grid>({{"side", "9"}})->makeGraph(1), 9, 1).fingerprint(),
              "fe14af59d8905c685fce7dcbe25ce246");
}

TEST(WellFormedInstance, FillsLargeGraphsInSeconds)
{
    const auto graph = make<Grid>({{"side", "1000"}})->makeGraph(1);
    const double before = cpuSeconds();
    const Instance instance = wellFormedInstance(graph, 20'000, 3);
    EXPECT_LT(cpuSeconds() - before, 30);
    for (Robot r = 0; r < instance.robotCount(); r += 2500)
        EXPECT_TRUE(hasPath(instance, r));
}

TEST(WellFormedInstance, IsDrawnOnMaps)
{
    const auto file =
        std::filesystem::temp_directory_path() / ("mrpp-well-formed-" + std::to_string(::getpid()) + ".map");
    writeFile(file, "type octile\nheight 4\nwidth 6\nmap\n......\n.@@.@.\n......\n.@@.@.\n");
    const auto sweep =
        points("  - public_benchmark: {map: '" + file.string() + "', robots: [1, 2, 3], well_formed: true}");
    const auto graph = sweep.front().problem->makeGraph(1);
    for (Seed seed = 0; seed < 50; ++seed)
        EXPECT_TRUE(isWellFormed(sweep[1].problem->makeInstance(graph, 2, seed))) << seed;
    EXPECT_NO_THROW(sweep[2].problem->check());
    std::filesystem::remove(file);
    EXPECT_THROW(points("  - public_benchmark: {map: a.map, scenario: a.scen, well_formed: true}"),
                 PlanError);
}

} // namespace
} // namespace mrpp::test
