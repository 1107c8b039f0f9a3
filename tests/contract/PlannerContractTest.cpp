/// \file
/// What every registered planner must do, whatever it promises beyond that.

#include "framework/evaluation/Validator.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/support/BruteForce.h"
#include "tests/support/RandomCases.h"

#include <chrono>

namespace mrpp
{
namespace
{

const Catalog &catalog()
{
    static const Catalog kCatalog = test::everythingRegistered();
    return kCatalog;
}

class EveryPlanner : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override { planner_ = catalog().planners.create(GetParam()); }

    /// Runs the planner and checks that it told the truth. Nothing where it does not take the instance.
    std::optional<PlannerStatus> run(const Instance &instance, Seed seed = 1, double seconds = 20)
    {
        if (const auto reason = planner_->reasonToReject(instance))
        {
            EXPECT_FALSE(reason->empty());
            return std::nullopt;
        }
        planner_->setInstance(std::make_shared<Instance>(instance));
        planner_->setSeed(seed);
        planner_->setup();
        const PlannerStatus status = planner_->solve(TerminationCondition::after(seconds));
        const Verdict verdict = validate(instance, planner_->solution(), planner_->specs().motion);
        switch (status)
        {
        case PlannerStatus::solved:
            EXPECT_TRUE(verdict.valid()) << verdict.violation;
            break;
        case PlannerStatus::partial:
            EXPECT_TRUE(verdict.legal) << verdict.violation;
            EXPECT_FALSE(planner_->reason().empty());
            break;
        case PlannerStatus::infeasible:
            EXPECT_TRUE(planner_->specs().provesInfeasibility);
            EXPECT_FALSE(planner_->reason().empty());
            break;
        case PlannerStatus::gave_up:
        case PlannerStatus::unsupported:
            EXPECT_FALSE(planner_->reason().empty());
            break;
        case PlannerStatus::timeout:
            break;
        default:
            ADD_FAILURE() << "a planner cannot end as " << toString(status);
        }
        return status;
    }

    std::unique_ptr<Planner> planner_;
};

TEST_P(EveryPlanner, SaysWhatItIs)
{
    EXPECT_FALSE(planner_->specs().citation.empty());
    EXPECT_FALSE(planner_->specs().completeFor.empty());
    for (const auto &parameter : planner_->parameters().all())
    {
        EXPECT_FALSE(parameter.help.empty()) << parameter.name;
        EXPECT_NO_THROW(planner_->parameters().set(parameter.name, parameter.defaultValue)) << parameter.name;
    }
}

TEST_P(EveryPlanner, TellsTheTruthAboutTheSmallProblems)
{
    const auto problem = catalog().problems.create("small_benchmark");
    for (const char *name :
         {"tree", "tunnel", "string", "corners", "corners_published", "connector", "loop_chain",
          "tree_with_cycle_leaves", "biconnected", "theta", "grid", "polygon"})
    {
        SCOPED_TRACE(name);
        run(test::smallProblem(catalog(), name));
    }
}

TEST_P(EveryPlanner, TellsTheTruthAboutRandomInstancesOfEveryDensity)
{
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t vertices = 1 + random.below(30);
        const auto graph = test::randomConnectedGraph(vertices, random.below(10), seed);
        run(randomInstance(graph, random.below(vertices + 1), seed), seed, 2);
    }
}

TEST_P(EveryPlanner, NeverSolvesTheImpossibleNorProvesThePossibleImpossible)
{
    for (Seed seed = 1; seed <= 300; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t vertices = 2 + random.below(5);
        const auto graph = test::randomConnectedGraph(vertices, random.below(4), seed);
        const Instance instance = randomInstance(graph, 1 + random.below(vertices), seed);
        const auto status = run(instance, seed);
        const bool solvable = test::isSolvable(instance, planner_->specs().motion);
        if (status == PlannerStatus::solved)
        {
            EXPECT_TRUE(solvable);
        }
        if (status == PlannerStatus::infeasible)
        {
            EXPECT_FALSE(solvable);
        }
    }
}

TEST_P(EveryPlanner, NeedsNoMoveWhereEverybodyIsAtHome)
{
    for (const std::size_t robots : {0U, 1U, 5U, 11U, 12U})
    {
        SCOPED_TRACE(robots);
        Instance instance = randomInstance(test::gridGraph(4, 3), robots, 3);
        instance.goals = instance.starts;
        const auto status = run(instance);
        if (status == PlannerStatus::solved)
        {
            EXPECT_TRUE(planner_->solution().empty());
        }
    }
}

TEST_P(EveryPlanner, SurvivesGraphsWithoutEdgesAndSeveralComponents)
{
    run({Graph::fromEdges(0, std::initializer_list<std::pair<Vertex, Vertex>>{}), {}, {}});
    run({Graph::fromEdges(1, std::initializer_list<std::pair<Vertex, Vertex>>{}), {0}, {0}});
    run({Graph::fromEdges(3, std::initializer_list<std::pair<Vertex, Vertex>>{}), {0, 1}, {0, 1}});
    const auto two = Graph::fromEdges(8, {{0, 1}, {1, 2}, {1, 3}, {4, 5}, {5, 6}, {5, 7}});
    run({two, {0, 1, 4}, {1, 0, 7}});
    EXPECT_NE(run({two, {0, 1}, {1, 6}}), PlannerStatus::solved);
}

TEST_P(EveryPlanner, GivesTheSameSolutionForTheSameSeed)
{
    const Instance instance = randomInstance(test::gridGraph(8, 8), 30, 9);
    if (!run(instance, 5))
        GTEST_SKIP() << "does not take this instance";
    const Solution first = planner_->solution();
    run(randomInstance(test::gridGraph(5, 5), 6, 2), 8);
    run(instance, 5);
    EXPECT_EQ(planner_->solution(), first);
    const auto fresh = catalog().planners.create(GetParam());
    fresh->setInstance(std::make_shared<Instance>(instance));
    fresh->setSeed(5);
    fresh->setup();
    EXPECT_EQ(fresh->solve({}), PlannerStatus::solved);
    EXPECT_EQ(fresh->solution(), first);
}

TEST_P(EveryPlanner, StopsSoonAfterItIsTold)
{
    for (const std::size_t side : {3U, 60U})
    {
        const Instance instance = randomInstance(test::gridGraph(side, side), side * side - 2, 4);
        if (planner_->reasonToReject(instance))
            continue;
        planner_->setInstance(std::make_shared<Instance>(instance));
        planner_->setup();
        const auto start = std::chrono::steady_clock::now();
        const PlannerStatus status = planner_->solve(TerminationCondition::after(0));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), 1.0);
        EXPECT_TRUE(status == PlannerStatus::timeout || status == PlannerStatus::solved) << toString(status);
    }
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryPlanner, testing::ValuesIn(catalog().planners.names()),
                         test::nameOf);

} // namespace
} // namespace mrpp
