/// A sweep over robots has one graph in each repetition, and the robots of a smaller case are the first of a
/// larger one: for every generator and for maps, however the robots are counted.

#include "framework/Catalog.h"
#include "framework/system/File.h"
#include "problems/Problems.h"
#include "problems/generators/Generator.h"
#include "yaml/ProblemList.h"
#include "yaml/YamlConfig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <unistd.h>

namespace mrpp::test
{
namespace
{

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

/// Each case of a sweep, in its order, by repetition.
using Cases = std::map<std::int64_t, std::vector<Instance>>;

/// A plan's cases, made as a run makes them.
Cases casesOf(const std::string &problem, const std::filesystem::path &folder)
{
    BenchmarkPlan plan;
    plan.repetitions = 3;
    plan.points = readProblems(parseYaml("problems:\n  - " + problem, "plan.yaml").find("problems")->items(),
                               {.catalog = &catalog(), .searchPaths = {folder}});
    plan.planners = {{"one", "one", {}}, {"other", "other", {}}};
    Cases cases;
    std::map<std::int64_t, std::shared_ptr<const Graph>> graphs;
    for (const RunSpec &run : expand(plan))
    {
        const Problem &point = *plan.points[run.point].problem;
        const auto graph = point.makeGraph(run.graphSeed);
        const auto first = graphs.emplace(run.repetition, graph).first->second;
        EXPECT_EQ(graph->fingerprint(), first->fingerprint()) << run.caseId;
        Instance instance = point.makeInstance(graph, point.robotCount(*graph), run.instanceSeed);
        if (run.planner == 0)
            cases[run.repetition].push_back(std::move(instance));
        else
            EXPECT_EQ(instance.fingerprint(), cases[run.repetition].back().fingerprint()) << run.caseId;
    }
    return cases;
}

bool begins(const std::vector<Vertex> &whole, const std::vector<Vertex> &part)
{
    return part.size() < whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

enum class Keeps
{
    startsAndGoals,
    starts,
};

void expectGrowth(const Cases &cases, Keeps keeps)
{
    EXPECT_EQ(cases.size(), 3U);
    std::set<std::string> different;
    for (const auto &[repetition, sweep] : cases)
    {
        ASSERT_EQ(sweep.size(), 3U);
        for (std::size_t i = 1; i < sweep.size(); ++i)
        {
            EXPECT_TRUE(begins(sweep[i].starts, sweep[i - 1].starts));
            EXPECT_TRUE(keeps == Keeps::starts || begins(sweep[i].goals, sweep[i - 1].goals));
        }
        different.insert(sweep.back().fingerprint());
    }
    EXPECT_EQ(different.size(), 3U) << "repetitions differ";
}

class Sweep : public ::testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::temp_directory_path() /
                  ("mrpp-sweep-" + std::to_string(::getpid()) + "-" + GetParam());
        writeFile(folder_ / "hall.map",
                  "type octile\nheight 4\nwidth 8\nmap\n........\n.@.@@.@.\n........\n.@....@.\n");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// A sweep over robots on the family, with further settings.
    [[nodiscard]] Cases cases(const std::string &settings) const
    {
        if (GetParam() == "map")
            return casesOf("public_benchmark: {map: hall.map, " + settings + "}", folder_);
        return casesOf("fg_vr: {graph: " + GetParam() + ", " + settings + "}", folder_);
    }

    std::filesystem::path folder_;
};

TEST_P(Sweep, OverRobotsKeepsGraphAndRobots)
{
    for (const char *sweep :
         {"robots: [1, 2, 5]", "occupancy: [0.25, 0.5, 1]", "occupancy: {from: 0.3, to: 0.9, step: 0.3}"})
    {
        SCOPED_TRACE(sweep);
        expectGrowth(cases(sweep), Keeps::startsAndGoals);
    }
}

TEST_P(Sweep, OverFreeVerticesKeepsGraphAndRobots)
{
    Cases sweep = cases("free: [1, 3, 5]");
    for (auto &[repetition, instances] : sweep)
        std::reverse(instances.begin(), instances.end());
    expectGrowth(sweep, Keeps::startsAndGoals);
}

TEST_P(Sweep, OfWellFormedInstancesKeepsGraphAndRobots)
{
    expectGrowth(cases("robots: [0, 1, 2], well_formed: true"), Keeps::startsAndGoals);
}

TEST_P(Sweep, OfSolvableInstancesKeepsGraphAndStarts)
{
    expectGrowth(cases("robots: [1, 2, 5], solvable: true"), Keeps::starts);
}

std::vector<std::string> families()
{
    std::vector<std::string> names = generatorNames(catalog());
    names.emplace_back("map");
    return names;
}

INSTANTIATE_TEST_SUITE_P(Families, Sweep, ::testing::ValuesIn(families()),
                         [](const auto &family) { return family.param; });

TEST(SweepOverRobots, OfAGeneratorAsAProblemKeepsGraphAndRobots)
{
    for (const std::string &family : generatorNames(catalog()))
    {
        SCOPED_TRACE(family);
        expectGrowth(casesOf(family + ": {robots: [1, 2, 5]}", {}), Keeps::startsAndGoals);
    }
}

} // namespace
} // namespace mrpp::test
