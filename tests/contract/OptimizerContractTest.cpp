/// \file
/// What every registered optimizer must do.

#include "framework/evaluation/Validator.h"
#include "tests/contract/EverythingRegistered.h"
#include "tests/contract/UnderLimits.h"
#include "tests/support/RandomCases.h"

namespace mrpp
{
namespace
{

const Catalog &catalog()
{
    static const Catalog kCatalog = test::everythingRegistered();
    return kCatalog;
}

class EveryOptimizer : public testing::TestWithParam<std::string>
{};

TEST_P(EveryOptimizer, NeverLengthensOrBreaksASolution)
{
    test::underLimits(
        [&]
        {
            const auto optimizer = catalog().optimizers.create(GetParam());
            for (Seed seed = 1; seed <= 200; ++seed)
            {
                SCOPED_TRACE("seed " + std::to_string(seed));
                Random random(seed);
                const std::size_t vertices = 3 + random.below(25);
                const auto graph = test::randomConnectedGraph(vertices, random.below(12), seed);
                const std::size_t robots = random.below(vertices);
                for (const bool rotations : {false, true})
                {
                    const auto solved = rotations
                                            ? test::randomSolvedCaseWithRotations(graph, robots, 300, seed)
                                            : test::randomSolvedCase(graph, robots, 300, seed);
                    const MotionRule rule = rotations ? MotionRule::rotation : MotionRule::pebble;
                    for (const bool stopped : {false, true})
                    {
                        const auto ptc =
                            stopped ? TerminationCondition::after(0) : TerminationCondition::never();
                        const Solution improved = optimizer->improve(solved.instance, solved.solution, ptc);
                        const Verdict verdict = validate(solved.instance, improved, rule);
                        EXPECT_TRUE(verdict.valid()) << verdict.violation;
                        EXPECT_LE(improved.pathLength(), solved.solution.pathLength());
                        EXPECT_LE(improved.actionCount(), solved.solution.actionCount());
                    }
                }
            }
        });
}

TEST_P(EveryOptimizer, IsDeterministic)
{
    test::underLimits(
        [&]
        {
            const auto optimizer = catalog().optimizers.create(GetParam());
            const auto solved = test::randomSolvedCase(test::gridGraph(9, 9), 60, 5000, 4);
            EXPECT_EQ(optimizer->improve(solved.instance, solved.solution, {}),
                      catalog().optimizers.create(GetParam())->improve(solved.instance, solved.solution, {}));
        });
}

TEST_P(EveryOptimizer, TakesAnEmptySolution)
{
    test::underLimits(
        [&]
        {
            const auto optimizer = catalog().optimizers.create(GetParam());
            const Instance instance{test::gridGraph(2, 2), {0, 1}, {0, 1}};
            EXPECT_TRUE(optimizer->improve(instance, Solution(), {}).empty());
        });
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryOptimizer, testing::ValuesIn(catalog().optimizers.names()),
                         test::nameOf);

} // namespace
} // namespace mrpp
