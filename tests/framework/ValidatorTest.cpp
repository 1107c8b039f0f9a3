#include "framework/evaluation/Validator.h"
#include "tests/support/RandomCases.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace mrpp
{
namespace
{

constexpr MotionRule kRules[] = {MotionRule::pebble, MotionRule::parallel, MotionRule::following,
                                 MotionRule::rotation};

/// A triangle 0–1–2 with a tail 2–3–4.
std::shared_ptr<const Graph> triangleWithTail()
{
    return Graph::fromEdges(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}});
}

Verdict check(const Instance &instance, std::vector<TimedMove> rows, MotionRule rule = MotionRule::rotation)
{
    return validate(instance, rows, rule);
}

void expectIllegal(const Verdict &verdict, const std::string &violation, std::size_t badMove)
{
    EXPECT_FALSE(verdict.legal);
    EXPECT_FALSE(verdict.valid());
    EXPECT_EQ(verdict.violation, violation);
    EXPECT_EQ(verdict.badMove, badMove);
}

TEST(Validator, AcceptsAValidSolution)
{
    const Instance instance{triangleWithTail(), {0, 3}, {2, 4}};
    const Verdict verdict =
        validate(instance, Solution({{1, 3, 4}, {0, 0, 1}, {0, 1, 2}}), MotionRule::pebble);
    EXPECT_TRUE(verdict.valid());
    EXPECT_EQ(verdict.violation, "");
    EXPECT_EQ(verdict.atGoal, 2U);
    EXPECT_EQ(verdict.badMove, 3U) << "the number of moves, as none is bad";
}

TEST(Validator, NoMovesAreRightWhereEveryRobotIsAtItsGoal)
{
    EXPECT_TRUE(validate({triangleWithTail(), {0, 3}, {0, 3}}, Solution(), MotionRule::pebble).valid());
    EXPECT_TRUE(validate({triangleWithTail(), {}, {}}, Schedule(), MotionRule::pebble).valid());
    EXPECT_TRUE(check({triangleWithTail(), {}, {}}, {}).valid());
}

TEST(Validator, SaysWhichRobotEndsElsewhere)
{
    const Instance instance{triangleWithTail(), {0, 3, 4}, {0, 1, 4}};
    const Verdict still = validate(instance, Solution(), MotionRule::pebble);
    EXPECT_TRUE(still.legal);
    EXPECT_FALSE(still.complete);
    EXPECT_FALSE(still.valid());
    EXPECT_EQ(still.atGoal, 2U);
    EXPECT_EQ(still.violation, "robot 1 ends on vertex 3, its goal is 1 (it never moves)");

    const Verdict halfWay =
        validate(instance, Solution({{0, 0, 1}, {0, 1, 0}, {1, 3, 2}}), MotionRule::pebble);
    EXPECT_EQ(halfWay.violation, "robot 1 ends on vertex 2, its goal is 1 (its last move is step 2)");
    EXPECT_EQ(halfWay.badMove, 3U);
}

TEST(Validator, NamesWhatIsWrongWithAMove)
{
    const Instance instance{triangleWithTail(), {0, 3}, {1, 4}};
    const auto refuse = [&](const Move &move, const std::string &why)
    {
        for (const MotionRule rule : kRules)
            expectIllegal(validate(instance, Solution({{1, 3, 4}, move, {0, 0, 1}}), rule), "step 1: " + why,
                          1);
    };
    refuse({0, 0, 4}, "robot 0 cannot go from 0 to 4: there is no edge");
    refuse({0, 1, 2}, "robot 0 cannot go from 1 to 2: it stands on vertex 0");
    refuse({0, 0, 0}, "robot 0 cannot go from 0 to 0: a move changes the vertex, and waits are not written");
    refuse({7, 0, 1}, "there is no robot 7; robots are numbered from 0, and there are 2");
    refuse({0, 0, 9},
           "robot 0 cannot go from 0 to 9: there is no vertex 9; vertices are numbered from 0, and "
           "there are 5");
    refuse({0, 12, 1}, "robot 0 cannot go from 12 to 1: there is no vertex 12; vertices are numbered from 0, "
                       "and there are 5");
    refuse({kNoRobot, kNoVertex, kNoVertex},
           "there is no robot 4294967295; robots are numbered from 0, and there are 2");
    const Instance close{triangleWithTail(), {2, 3}, {3, 2}};
    expectIllegal(validate(close, Solution({{0, 2, 3}}), MotionRule::rotation),
                  "step 0: robot 0 cannot go from 2 to 3: robot 1 stands there", 0);
}

TEST(Validator, RefusesASwapUnderEveryRule)
{
    const Instance instance{triangleWithTail(), {4, 2, 3}, {4, 3, 2}};
    for (const MotionRule rule : kRules)
    {
        expectIllegal(check(instance, {{0, 1, 2, 3}, {0, 2, 3, 2}}, rule),
                      "step 0: robots 1 and 2 swap along the edge 2–3", 0);
        expectIllegal(check(instance, {{0, 2, 3, 2}, {0, 1, 2, 3}}, rule),
                      "step 0: robots 1 and 2 swap along the edge 2–3", 0);
    }
}

TEST(Validator, RefusesTwoRobotsOnOneVertex)
{
    const Instance instance{triangleWithTail(), {0, 3}, {2, 3}};
    expectIllegal(check(instance, {{0, 0, 0, 2}, {0, 1, 3, 2}}), "step 0: robots 0 and 1 both enter vertex 2",
                  1);
}

TEST(Validator, RefusesTwoMovesOfARobotInOneStep)
{
    const Instance instance{triangleWithTail(), {0}, {2}};
    expectIllegal(check(instance, {{0, 0, 0, 1}, {0, 0, 1, 2}}), "step 0: robot 0 moves twice, to 1 and to 2",
                  1);
}

TEST(Validator, SaysUnderWhichWiderRuleAStepWouldBeLegal)
{
    const Instance apart{triangleWithTail(), {0, 3}, {1, 4}};
    const std::vector<TimedMove> atOnce = {{0, 0, 0, 1}, {0, 1, 3, 4}};
    expectIllegal(
        check(apart, atOnce, MotionRule::pebble),
        "step 0: robots 0 and 1 move at once; the rule 'pebble' does not allow that, 'parallel' would", 1);
    EXPECT_TRUE(check(apart, atOnce, MotionRule::parallel).valid());

    const Instance queue{triangleWithTail(), {2, 3}, {3, 4}};
    const std::vector<TimedMove> follow = {{0, 0, 2, 3}, {0, 1, 3, 4}};
    expectIllegal(
        check(queue, follow, MotionRule::pebble),
        "step 0: robots 0 and 1 move at once; the rule 'pebble' does not allow that, 'following' would", 1);
    expectIllegal(
        check(queue, follow, MotionRule::parallel),
        "step 0: robot 0 enters vertex 3 in the step in which robot 1 leaves it; the rule 'parallel' "
        "does not allow that, 'following' would",
        0);
    EXPECT_TRUE(check(queue, follow, MotionRule::following).valid());

    const Instance ring{triangleWithTail(), {4, 0, 1, 2}, {4, 1, 2, 0}};
    const std::vector<TimedMove> turn = {{0, 3, 2, 0}, {0, 1, 0, 1}, {0, 2, 1, 2}};
    for (const MotionRule rule : {MotionRule::pebble, MotionRule::parallel, MotionRule::following})
        expectIllegal(check(ring, turn, rule),
                      "step 0: robots 3, 1 and 2 turn on a closed cycle; the rule '" +
                          std::string(toString(rule)) + "' does not allow that, 'rotation' would",
                      0);
    EXPECT_TRUE(check(ring, turn, MotionRule::rotation).valid());
}

TEST(Validator, TellsACycleFromAChainThatRunsIntoAnEmptyVertex)
{
    // Robots on 1, 2, 3 move to 2, 3, 4 while vertex 0 is empty: nothing is closed.
    const Instance chain{triangleWithTail(), {1, 2, 3}, {2, 3, 4}};
    EXPECT_TRUE(check(chain, {{0, 0, 1, 2}, {0, 1, 2, 3}, {0, 2, 3, 4}}, MotionRule::following).valid());
}

TEST(Validator, SolutionsTurnCyclesUnderRotationOnly)
{
    const Move turn[] = {{0, 0, 1}, {1, 1, 2}, {2, 2, 0}};
    Solution solution;
    solution.append({3, 3, 4});
    solution.appendRotation(turn);
    const Instance instance{triangleWithTail(), {0, 1, 2, 3}, {1, 2, 0, 4}};
    EXPECT_TRUE(validate(instance, solution, MotionRule::rotation).valid());
    expectIllegal(
        validate(instance, solution, MotionRule::following),
        "step 1: robots 0, 1 and 2 turn on a closed cycle; the rule 'following' does not allow that, "
        "'rotation' would",
        1);
}

TEST(Validator, ARotationOfASolutionMustBeClosed)
{
    const Move chain[] = {{1, 3, 4}, {0, 2, 3}};
    Solution solution;
    solution.appendRotation(chain);
    expectIllegal(validate({triangleWithTail(), {2, 3}, {3, 4}}, solution, MotionRule::rotation),
                  "step 0: robot 1 goes from 3 to 4 in a rotation, but no robot of it leaves vertex 4", 0);
}

TEST(Validator, StepsOfRowsCountUpFromZero)
{
    const Instance instance{triangleWithTail(), {0}, {2}};
    EXPECT_TRUE(check(instance, {{0, 0, 0, 1}, {1, 0, 1, 2}}).valid());
    expectIllegal(check(instance, {{1, 0, 0, 1}, {2, 0, 1, 2}}),
                  "the first step is 1; steps are numbered from 0", 0);
    expectIllegal(check(instance, {{0, 0, 0, 1}, {2, 0, 1, 2}}),
                  "step 2 comes after step 0; steps go up by one, without gaps", 1);
    expectIllegal(check(instance, {{0, 0, 0, 1}, {1, 0, 1, 2}, {0, 0, 2, 3}}),
                  "step 0 comes after step 1; steps go up by one, without gaps", 2);
    expectIllegal(check(instance, {{-1, 0, 0, 1}}), "the first step is -1; steps are numbered from 0", 0);
}

TEST(Validator, AnyNumbersAreSafe)
{
    constexpr std::int64_t kLow = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t kHigh = std::numeric_limits<std::int64_t>::max();
    const Instance instance{triangleWithTail(), {0, 1}, {1, 0}};
    for (const std::int64_t number : {kLow, std::int64_t{-1}, std::int64_t{5}, std::int64_t{1} << 32, kHigh})
    {
        EXPECT_FALSE(check(instance, {{number, 0, 0, 2}}).legal);
        EXPECT_FALSE(check(instance, {{0, number, 0, 2}}).legal);
        EXPECT_FALSE(check(instance, {{0, 0, number, 2}}).legal);
        EXPECT_FALSE(check(instance, {{0, 0, 0, number}}).legal);
        EXPECT_FALSE(check(instance, {{0, 1, 1, 2}, {0, number, number, number}}).legal);
    }
}

TEST(Validator, AMalformedInstanceIsNoAnswersFault)
{
    const Verdict verdict = validate({triangleWithTail(), {0, 0}, {1, 2}}, Solution(), MotionRule::pebble);
    expectIllegal(verdict, "the instance is malformed: robots 0 and 1 have the same start, vertex 0", 0);
}

TEST(Validator, StepsOfASchedulesWaitingAreLegal)
{
    Schedule schedule;
    schedule.appendStep({});
    EXPECT_TRUE(validate({triangleWithTail(), {0}, {0}}, schedule, MotionRule::pebble).valid());
}

/// The rules word by word, all pairs of moves, one step. Nothing is shared with the validator.
bool isLegalStep(const Graph &graph, const std::vector<Vertex> &position, const std::vector<TimedMove> &step,
                 MotionRule rule)
{
    for (const TimedMove &move : step)
    {
        if (move.robot < 0 || move.robot >= static_cast<std::int64_t>(position.size()) || move.to < 0 ||
            move.to >= static_cast<std::int64_t>(graph.vertexCount()) ||
            move.from != static_cast<std::int64_t>(position[static_cast<std::size_t>(move.robot)]))
            return false;
        bool joined = false;
        for (const Graph::Edge &edge : graph.edges())
            joined = joined || (edge.a == move.from && edge.b == move.to) ||
                     (edge.b == move.from && edge.a == move.to);
        if (!joined)
            return false;
        for (const TimedMove &other : step)
        {
            const bool same = &other == &move;
            if (!same && (other.robot == move.robot || other.to == move.to ||
                          (other.from == move.to && other.to == move.from)))
                return false;
        }
        for (std::size_t robot = 0; robot < position.size(); ++robot)
        {
            if (static_cast<std::int64_t>(position[robot]) != move.to)
                continue;
            bool leaves = false;
            for (const TimedMove &other : step)
                leaves = leaves || other.robot == static_cast<std::int64_t>(robot);
            if (!leaves || rule < MotionRule::following)
                return false;
        }
    }
    if (rule == MotionRule::pebble && step.size() > 1)
        return false;
    if (rule == MotionRule::rotation)
        return true;
    // Take away, again and again, a move whose target no other one leaves; closed cycles stay.
    std::vector<TimedMove> rest = step;
    for (bool changed = true; changed;)
    {
        changed = false;
        for (std::size_t i = 0; i < rest.size() && !changed; ++i)
        {
            bool free = true;
            for (const TimedMove &other : rest)
                free = free && other.from != rest[i].to;
            if (free)
            {
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
                changed = true;
            }
        }
    }
    return rest.empty();
}

bool isRight(const Instance &instance, const std::vector<TimedMove> &rows, MotionRule rule)
{
    std::vector<Vertex> position = instance.starts;
    std::int64_t step = 0;
    for (std::size_t first = 0; first < rows.size(); ++step)
    {
        std::vector<TimedMove> now;
        for (; first < rows.size() && rows[first].step == step; ++first)
            now.push_back(rows[first]);
        if (now.empty() || !isLegalStep(*instance.graph, position, now, rule))
            return false;
        for (const TimedMove &move : now)
            position[static_cast<std::size_t>(move.robot)] = static_cast<Vertex>(move.to);
    }
    return position == instance.goals;
}

std::vector<TimedMove> rowsOf(const Schedule &schedule)
{
    std::vector<TimedMove> rows;
    std::int64_t number = 0;
    for (std::size_t step = 0; step < schedule.makespan(); ++step)
    {
        for (const Move &move : schedule.step(step))
            rows.push_back({number, move.robot, move.from, move.to});
        number += schedule.step(step).empty() ? 0 : 1;
    }
    return rows;
}

/// One row changed, dropped or repeated.
std::vector<TimedMove> mutate(std::vector<TimedMove> rows, const Instance &instance)
{
    const auto index = *rc::gen::inRange<std::size_t>(0, rows.size());
    TimedMove &row = rows[index];
    const auto robots = static_cast<std::int64_t>(instance.robotCount());
    const auto vertices = static_cast<std::int64_t>(instance.graph->vertexCount());
    const auto at = rows.begin() + static_cast<std::ptrdiff_t>(index);
    switch (*rc::gen::inRange(0, 7))
    {
    case 0:
        row.robot = *rc::gen::distinctFrom(rc::gen::inRange<std::int64_t>(-1, robots + 1), row.robot);
        break;
    case 1:
        row.from = *rc::gen::distinctFrom(rc::gen::inRange<std::int64_t>(-1, vertices + 1), row.from);
        break;
    case 2:
        row.to = *rc::gen::distinctFrom(rc::gen::inRange<std::int64_t>(-1, vertices + 1), row.to);
        break;
    case 3:
        row.step =
            *rc::gen::distinctFrom(rc::gen::inRange<std::int64_t>(row.step - 2, row.step + 3), row.step);
        break;
    case 4:
        rows.erase(at);
        break;
    case 5:
        rows.insert(at, TimedMove(row));
        break;
    default:
        // Dropped, and the steps behind it close up.
        if (const bool alone = (index == 0 || rows[index - 1].step != row.step) &&
                               (index + 1 == rows.size() || rows[index + 1].step != row.step);
            alone)
            for (std::size_t i = index + 1; i < rows.size(); ++i)
                --rows[i].step;
        rows.erase(at);
    }
    return rows;
}

test::ScheduledCase arbitraryCase(MotionRule rule)
{
    const auto seed = *rc::gen::arbitrary<Seed>();
    const auto vertices = *rc::gen::inRange<std::size_t>(3, 14);
    const auto robots = *rc::gen::inRange<std::size_t>(1, vertices + 1);
    const auto extra = *rc::gen::inRange<std::size_t>(0, vertices);
    return test::randomScheduledCase(test::randomConnectedGraph(vertices, extra, seed), robots, 15, rule,
                                     seed);
}

RC_GTEST_PROP(Validator, FindsEveryMutationThatMakesAnAnswerWrong, ())
{
    const auto rule = *rc::gen::elementOf(std::vector(std::begin(kRules), std::end(kRules)));
    const auto test = arbitraryCase(rule);
    const std::vector<TimedMove> rows = rowsOf(test.schedule);
    RC_ASSERT(check(test.instance, rows, rule).violation.empty());
    RC_PRE(!rows.empty());
    const std::vector<TimedMove> mutated = mutate(rows, test.instance);
    const Verdict verdict = check(test.instance, mutated, rule);
    RC_ASSERT(verdict.valid() == isRight(test.instance, mutated, rule));
    RC_ASSERT(verdict.valid() == verdict.violation.empty());
    RC_CLASSIFY(verdict.valid(), "still right");
}

RC_GTEST_PROP(Validator, JudgesAnswersOfOneRuleUnderEveryOther, ())
{
    const auto made = *rc::gen::elementOf(std::vector(std::begin(kRules), std::end(kRules)));
    const auto test = arbitraryCase(made);
    for (const MotionRule rule : kRules)
    {
        const Verdict verdict = check(test.instance, rowsOf(test.schedule), rule);
        RC_ASSERT(verdict.valid() == isRight(test.instance, rowsOf(test.schedule), rule));
        RC_ASSERT(verdict.valid() == validate(test.instance, test.schedule, rule).valid());
        if (rule >= made)
            RC_ASSERT(verdict.valid());
        else if (!verdict.valid())
            RC_ASSERT(verdict.violation.find("' would") != std::string::npos);
    }
}

RC_GTEST_PROP(Validator, NamesTheFirstBadMoveOfASequence, ())
{
    const auto seed = *rc::gen::arbitrary<Seed>();
    const auto test =
        test::randomSolvedCase(test::gridGraph(4, 3), *rc::gen::inRange<std::size_t>(1, 12), 30, seed);
    std::vector<Move> moves(test.solution.moves().begin(), test.solution.moves().end());
    RC_PRE(!moves.empty());
    const auto index = *rc::gen::inRange<std::size_t>(0, moves.size());
    switch (*rc::gen::inRange(0, 3))
    {
    case 0:
        moves.erase(moves.begin() + static_cast<std::ptrdiff_t>(index));
        break;
    case 1:
        moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(index), Move(moves[index]));
        break;
    default:
        moves[index].to = *rc::gen::inRange<Vertex>(0, 13);
    }
    std::vector<Vertex> position = test.instance.starts;
    std::size_t bad = 0;
    for (; bad < moves.size(); ++bad)
    {
        const TimedMove row{0, moves[bad].robot, moves[bad].from, moves[bad].to};
        if (!isLegalStep(*test.instance.graph, position, {row}, MotionRule::pebble))
            break;
        position[moves[bad].robot] = moves[bad].to;
    }
    const Verdict verdict = validate(test.instance, Solution(moves), MotionRule::pebble);
    RC_ASSERT(verdict.badMove == bad);
    RC_ASSERT(verdict.legal == (bad == moves.size()));
    RC_ASSERT(verdict.complete == (position == test.instance.goals));
}

} // namespace
} // namespace mrpp
