/// \file
/// What every registered planner must do, whatever it promises beyond that.

#include "framework/evaluation/Validator.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/contract/UnderLimits.h"
#include "tests/support/BruteForce.h"
#include "tests/support/PollWatch.h"
#include "tests/support/RandomCases.h"

#include <algorithm>

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
    test::underLimits(
        [&]
        {
            EXPECT_FALSE(planner_->specs().citation.empty());
            EXPECT_FALSE(planner_->specs().completeFor.empty());
            for (const auto &parameter : planner_->parameters().all())
            {
                EXPECT_FALSE(parameter.help.empty()) << parameter.name;
                EXPECT_NO_THROW(planner_->parameters().set(parameter.name, parameter.defaultValue))
                    << parameter.name;
            }
        });
}

TEST_P(EveryPlanner, TellsTheTruthAboutTheSmallProblems)
{
    test::underLimits(
        [&]
        {
            const auto problem = catalog().problems.create("small_benchmark");
            for (const char *name :
                 {"tree", "tunnel", "string", "corners", "corners_published", "connector", "loop_chain",
                  "tree_with_cycle_leaves", "biconnected", "theta", "grid", "polygon"})
            {
                SCOPED_TRACE(name);
                run(test::smallProblem(catalog(), name));
            }
        });
}

TEST_P(EveryPlanner, TellsTheTruthAboutRandomInstancesOfEveryDensity)
{
    test::underLimits(
        [&]
        {
            for (Seed seed = 1; seed <= 300; ++seed)
            {
                SCOPED_TRACE("seed " + std::to_string(seed));
                Random random(seed);
                const std::size_t vertices = 1 + random.below(30);
                const auto graph = test::randomConnectedGraph(vertices, random.below(10), seed);
                run(randomInstance(graph, random.below(vertices + 1), seed), seed, 2);
            }
        });
}

TEST_P(EveryPlanner, NeverSolvesTheImpossibleNorProvesThePossibleImpossible)
{
    test::underLimits(
        [&]
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
                if (status && planner_->specs().complete)
                {
                    EXPECT_EQ(status == PlannerStatus::solved, solvable);
                }
            }
        });
}

TEST_P(EveryPlanner, SolvesWhateverItTakesIfItIsComplete)
{
    test::underLimits(
        [&]
        {
            if (!planner_->specs().complete)
                GTEST_SKIP() << "is not complete";
            for (Seed seed = 1; seed <= 300; ++seed)
            {
                SCOPED_TRACE("seed " + std::to_string(seed));
                Random random(seed);
                const std::size_t vertices = 3 + random.below(40);
                const auto graph = test::randomConnectedGraph(vertices, random.below(vertices), seed);
                const std::size_t free = 1 + random.below(std::min<std::size_t>(6, vertices - 1));
                const auto status = run(test::randomSolvableInstance(graph, vertices - free, seed), seed);
                if (status)
                {
                    EXPECT_EQ(status, PlannerStatus::solved) << planner_->reason();
                }
            }
        });
}

TEST_P(EveryPlanner, NeedsNoMoveWhereEverybodyIsAtHome)
{
    test::underLimits(
        [&]
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
        });
}

TEST_P(EveryPlanner, SurvivesGraphsWithoutEdgesAndSeveralComponents)
{
    test::underLimits(
        [&]
        {
            run({Graph::fromEdges(0, std::initializer_list<std::pair<Vertex, Vertex>>{}), {}, {}});
            run({Graph::fromEdges(1, std::initializer_list<std::pair<Vertex, Vertex>>{}), {0}, {0}});
            run({Graph::fromEdges(3, std::initializer_list<std::pair<Vertex, Vertex>>{}), {0, 1}, {0, 1}});
            const auto two = Graph::fromEdges(8, {{0, 1}, {1, 2}, {1, 3}, {4, 5}, {5, 6}, {5, 7}});
            run({two, {0, 1, 4}, {1, 0, 7}});
            EXPECT_NE(run({two, {0, 1}, {1, 6}}), PlannerStatus::solved);
        });
}

TEST_P(EveryPlanner, GivesTheSameSolutionForTheSameSeed)
{
    test::underLimits(
        [&]
        {
            const Instance instance = randomInstance(test::gridGraph(8, 8), 30, 9);
            const auto status = run(instance, 5);
            if (!status)
                GTEST_SKIP() << "does not take this instance";
            EXPECT_TRUE(status == PlannerStatus::solved || status == PlannerStatus::partial)
                << planner_->reason();
            const Solution first = planner_->solution();
            run(randomInstance(test::gridGraph(5, 5), 6, 2), 8);
            run(instance, 5);
            EXPECT_EQ(planner_->solution(), first);
            const auto fresh = catalog().planners.create(GetParam());
            fresh->setInstance(std::make_shared<Instance>(instance));
            fresh->setSeed(5);
            fresh->setup();
            EXPECT_EQ(fresh->solve({}), status);
            EXPECT_EQ(fresh->solution(), first);
        });
}

TEST_P(EveryPlanner, StopsWithinFiftyMillisecondsOfAnyLimit)
{
    test::underLimits(
        [&]
        {
            const auto tree = test::randomConnectedGraph(20'000, 0, 3);
            const auto sparse = test::randomConnectedGraph(1'000, 300, 3);
            const Instance instances[] = {
                randomInstance(test::gridGraph(3, 3), 7, 4),
                randomInstance(test::gridGraph(60, 60), 3598, 4),
                randomInstance(test::gridGraph(60, 60), 3599, 4),
                randomInstance(test::gridGraph(300, 200), 3000, 4),
                test::randomWalks(tree, 10'000, 200'000, 5).instance,
                test::randomSolvedCase(sparse, 990, 20'000, 5).instance,
                test::randomSolvedCase(sparse, 999, 20'000, 5).instance,
            };
            for (const Instance &instance : instances)
            {
                SCOPED_TRACE(std::to_string(instance.robotCount()) + " robots on " +
                             std::to_string(instance.graph->vertexCount()) + " vertices");
                if (planner_->reasonToReject(instance))
                    continue;
                for (const double limit : {0.0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3})
                {
                    planner_->setInstance(std::make_shared<Instance>(instance));
                    planner_->setup();
                    test::PollWatch watch(limit);
                    const PlannerStatus status =
                        planner_->solve(TerminationCondition::when([&watch] { return watch.poll(); }));
                    watch.poll();
                    EXPECT_LT(watch.longest(), test::kPromptly)
                        << "limit of " << limit << " s, " << toString(status);
                    if (status != PlannerStatus::timeout)
                        break;
                }
            }
        });
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryPlanner, testing::ValuesIn(catalog().planners.names()),
                         test::nameOf);

} // namespace
} // namespace mrpp
