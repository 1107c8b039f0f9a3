#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/support/Error.h"
#include "tests/support/RandomCases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

using ::testing::ElementsAre;

template <class Action>
std::string complaintOf(Action &&action)
{
    try
    {
        action();
    }
    catch (const InputError &error)
    {
        return error.complaint();
    }
    return "no error";
}

// The literals were computed outside this program from the definitions of seed, generator and shuffle.
TEST(RandomInstance, IsTheSameOnEveryMachine)
{
    const Instance instance = randomInstance(test::gridGraph(6, 1), 3, 5);
    EXPECT_THAT(instance.starts, ElementsAre(4, 0, 1));
    EXPECT_THAT(instance.goals, ElementsAre(1, 2, 4));
}

TEST(RandomInstance, TheRobotsOfASmallerAreTheFirstOfALarger)
{
    const auto graph = test::gridGraph(5, 5);
    const Instance all = randomInstance(graph, 25, 9);
    for (std::size_t robots = 0; robots <= 25; ++robots)
    {
        const Instance some = randomInstance(graph, robots, 9);
        EXPECT_EQ(some.starts,
                  std::vector(all.starts.begin(), all.starts.begin() + static_cast<std::ptrdiff_t>(robots)));
        EXPECT_EQ(some.goals,
                  std::vector(all.goals.begin(), all.goals.begin() + static_cast<std::ptrdiff_t>(robots)));
        EXPECT_EQ(some.defect(), std::nullopt);
    }
}

TEST(RandomInstance, LiesInTheLargestComponent)
{
    // Components {0, 1}, {2, …, 6} and {7}.
    const auto graph = Graph::fromEdges(8, {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {5, 6}});
    for (Seed seed = 0; seed < 30; ++seed)
    {
        const Instance instance = randomInstance(graph, 4, seed);
        EXPECT_EQ(instance.defect(), std::nullopt);
        for (const auto &vertices : {instance.starts, instance.goals})
            for (const Vertex v : vertices)
                EXPECT_TRUE(v >= 2 && v <= 6) << v;
    }
}

TEST(RandomInstance, RefusesMoreRobotsThanFit)
{
    const auto graph = Graph::fromEdges(8, {{0, 1}, {2, 3}, {3, 4}, {4, 5}, {5, 6}});
    EXPECT_EQ(randomInstance(graph, 5, 1).robotCount(), 5U);
    EXPECT_EQ(complaintOf([&] { (void)randomInstance(graph, 6, 1); }),
              "6 robots do not fit the largest component, which has 5 of the graph's 8 vertices");
    EXPECT_EQ(randomInstance(Graph::fromEdges(0, {}), 0, 1).robotCount(), 0U);
}

TEST(RobotCount, IsGivenInThreeWays)
{
    using By = RobotCount::By;
    EXPECT_EQ(RobotCount::key("robots"), By::robots);
    EXPECT_EQ(RobotCount::key("free"), By::free);
    EXPECT_EQ(RobotCount::key("occupancy"), By::occupancy);
    EXPECT_EQ(RobotCount::key("agents"), std::nullopt);
    EXPECT_EQ((RobotCount{By::robots, 7}.resolve(10)), 7U);
    EXPECT_EQ((RobotCount{By::free, 3}.resolve(10)), 7U);
    EXPECT_EQ((RobotCount{By::occupancy, 0.98}.resolve(50)), 49U) << "not 48, as 0.98 is no binary fraction";
    EXPECT_EQ((RobotCount{By::occupancy, 0.99}.resolve(50)), 49U) << "rounded down";
    EXPECT_EQ((RobotCount{By::occupancy, 1}.resolve(10)), 10U);
    EXPECT_EQ((RobotCount{By::free, 10}.resolve(10)), 0U);
}

TEST(RobotCount, RefusesWhatDoesNotFit)
{
    using By = RobotCount::By;
    EXPECT_EQ(complaintOf(
                  [] {
                      (void)RobotCount{By::robots, 11}.resolve(10);
                  }),
              "robots = 11 does not fit a graph of 10 vertices");
    EXPECT_EQ(complaintOf(
                  [] {
                      (void)RobotCount{By::free, 11}.resolve(10);
                  }),
              "free = 11 does not fit a graph of 10 vertices");
    EXPECT_EQ(complaintOf(
                  [] {
                      (void)RobotCount{By::occupancy, 1.5}.resolve(10);
                  }),
              "occupancy = 1.5 does not fit a graph of 10 vertices");
    EXPECT_EQ(complaintOf(
                  [] {
                      (void)RobotCount{By::robots, 2.5}.resolve(10);
                  }),
              "robots = 2.5 does not fit a graph of 10 vertices");
    EXPECT_EQ(complaintOf(
                  [] {
                      (void)RobotCount{By::robots, -1}.resolve(10);
                  }),
              "robots = -1 does not fit a graph of 10 vertices");
}

/// A path whose length is a parameter.
class Path final : public Problem
{
public:
    Path()
    {
        declareParam("length", length_, "1:100", "vertices");
        declareParam("label", label_, "", "name");
    }
    [[nodiscard]] std::string name() const override { return label_; }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed) const override
    {
        return test::gridGraph(static_cast<std::size_t>(length_), 1);
    }

private:
    std::int64_t length_ = 5;
    std::string label_ = "path";
};

Config settings(std::vector<std::pair<std::string, std::string>> entries)
{
    std::vector<Config::Entry> list;
    std::size_t line = 0;
    for (auto &[key, value] : entries)
    {
        ++line;
        list.push_back({std::move(key),
                        {"plan.yaml", line, 1},
                        Config::scalar(std::move(value), {"plan.yaml", line, 9})});
    }
    return Config::map(std::move(list), {"plan.yaml", 1, 1});
}

std::string refusal(const Config &config)
{
    try
    {
        Path().configure(config, {});
    }
    catch (const PlanError &error)
    {
        return error.what();
    }
    return "no error";
}

TEST(Problem, TakesItsSettings)
{
    Path problem;
    problem.configure(settings({{"length", "8"}, {"free", "2"}}), {});
    const auto graph = problem.makeGraph(1);
    EXPECT_EQ(graph->vertexCount(), 8U);
    EXPECT_EQ(problem.robotCount(*graph), 6U);
    EXPECT_EQ(problem.makeInstance(graph, 6, 1).robotCount(), 6U);
}

TEST(Problem, AScalarIsTheFirstParameter)
{
    Path problem;
    problem.configure(Config::scalar("9"), {});
    EXPECT_EQ(problem.makeGraph(1)->vertexCount(), 9U);
    EXPECT_THROW((void)problem.robotCount(*problem.makeGraph(1)), InputError);
}

TEST(Problem, IdentityForgetsTheNumberOfRobotsOnly)
{
    const auto identity = [](const Config &config)
    {
        Path problem;
        problem.configure(config, {});
        return problem.identity();
    };
    EXPECT_EQ(identity(settings({{"length", "8"}, {"robots", "2"}})), R"({"length":"8"})");
    EXPECT_EQ(identity(settings({{"occupancy", "0.5"}, {"length", "8"}})), R"({"length":"8"})");
    EXPECT_NE(identity(settings({{"length", "8"}, {"robots", "2"}})),
              identity(settings({{"length", "9"}, {"robots", "2"}})));
}

TEST(Problem, RefusesWhatIsWrongAtItsPlace)
{
    EXPECT_EQ(refusal(settings({{"lenght", "8"}})),
              "plan.yaml:1:1: unknown key 'lenght'; did you mean 'length'?");
    EXPECT_EQ(refusal(settings({{"length", "0"}})),
              "plan.yaml:1:9: parameter 'length' must lie in 1:100, but is 0");
    EXPECT_EQ(refusal(settings({{"robots", "2"}, {"free", "3"}})),
              "plan.yaml:2:1: 'free' says a second time how many robots there are; give one of robots, free, "
              "occupancy");
    EXPECT_EQ(refusal(settings({{"robots", "-2"}})), "plan.yaml:1:9: 'robots' cannot be negative");
    EXPECT_EQ(refusal(settings({{"robots", "2.5"}})), "plan.yaml:1:9: 'robots' takes a whole number");
    EXPECT_EQ(refusal(settings({{"occupancy", "1.5"}})), "plan.yaml:1:9: an occupancy lies between 0 and 1");
    EXPECT_EQ(refusal(Config::list({}, {"plan.yaml", 4, 2})),
              "plan.yaml:4:2: a problem takes a map of settings");
    EXPECT_EQ(refusal(Config::map({{"length", {}, Config::list({}, {"plan.yaml", 4, 2})}})),
              "plan.yaml:4:2: 'length' takes one value");
}

} // namespace
} // namespace mrpp
