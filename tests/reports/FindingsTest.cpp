#include "reports/summary/Findings.h"
#include "tests/reports/Campaigns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace mrpp
{
namespace
{

using namespace mrpp::testing;
using ::testing::HasSubstr;

/// Twenty points of two repetitions; the second planner needs a third more moves, and fails where `fails`
/// says.
ResultTable sweep(const std::vector<std::string> &planners,
                  const std::function<bool(const RunRecord &)> &fails)
{
    FakeCampaign campaign("found", 2);
    for (const std::string &name : planners)
        campaign.planner(name);
    std::vector<double> values;
    for (int i = 1; i <= 20; ++i)
        values.push_back(i);
    campaign.sweep("fg_vr", "grid", "robots", values, [](double) { return gridInstance(4, 1); });
    return campaign.run(
        [&](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, 0);
            const auto place = static_cast<std::int64_t>(*record.sweepValue);
            record.pathLength = 100 * place + 10 * record.repetition;
            // From 18 on the second planner is the better one.
            if (planner == 1)
                record.pathLength = *record.pathLength * (place <= 18 ? 4 : 2) / 3 + place % 3;
            if (planner == 1 && fails(record))
                record.status = PlannerStatus::timeout;
        });
}

const auto kNever = [](const RunRecord &) { return false; };

TEST(Findings, SayWhoNeedsFewerMovesWithNumbers)
{
    const Findings findings = findingsOf(caseTable(sweep({"push_and_rotate", "push_and_swap"}, kNever)));
    const CostFinding &moves = findings.costs.front();
    EXPECT_EQ(moves.first, "push_and_rotate");
    EXPECT_EQ(moves.pointsLess, 18U);
    EXPECT_EQ(moves.points, 20U);
    EXPECT_EQ(moves.comparison.pairs, 40U);
    EXPECT_EQ(moves.comparison.firstLess, 36U);
    EXPECT_TRUE(moves.isSignificant());
    EXPECT_THAT(
        moves.sentence(),
        HasSubstr(
            "push_and_rotate (pebble) needs fewer moves than push_and_swap (pebble) on 18 of 20 points, "
            "median ratio 0.75, 95 % CI 0.75–0.75 (40 instances that both solved, less on 36, more on "
            "4; Wilcoxon signed-rank p < 0.001, Holm-corrected; rank-biserial correlation 0."));
    EXPECT_THAT(findings.sentences(),
                ::testing::Contains(
                    "Not tested for what they solve: push_and_rotate (pebble) and push_and_swap (pebble) "
                    "(only 0 of 40 instances by one of them alone; a test needs 6)."));
}

TEST(Findings, SayWhoSolvesMore)
{
    const auto fails = [](const RunRecord &run) { return *run.sweepValue > 12; };
    const Findings findings = findingsOf(caseTable(sweep({"a", "b"}, fails)));
    ASSERT_EQ(findings.success.size(), 1U);
    EXPECT_EQ(findings.success[0].onlyFirst, 16U);
    EXPECT_NEAR(findings.success[0].p.value(), 2.0 / 65536, 1e-12);
    EXPECT_THAT(findings.success[0].sentence(),
                HasSubstr("a (pebble) solves more than b (pebble): 16 instances that b (pebble) does not, "
                          "against 0 the other way; "
                          "100.0 % [91.2, 100.0] against 60.0 % [44.6, 73.7] of 40 instances"));
    EXPECT_EQ(findings.costs[0].comparison.pairs, 24U); // the others are no pairs
}

TEST(Findings, RefuseWhereThereIsTooLittle)
{
    const auto fails = [](const RunRecord &run) { return *run.sweepValue > 2; };
    const Findings findings = findingsOf(caseTable(sweep({"a", "b"}, fails)));
    EXPECT_FALSE(findings.costs[0].p);
    EXPECT_FALSE(findings.costs[0].comparison.ratioInterval); // of four
    EXPECT_THAT(
        findings.sentences(),
        ::testing::Contains("Not tested for moves: a (pebble) and b (pebble) (only 4 of 4 pairs differ; a "
                            "test needs 6)."));
}

TEST(Findings, HolmCountsEveryTest)
{
    const Findings three = findingsOf(caseTable(sweep({"a", "b", "c"}, kNever)));
    EXPECT_EQ(three.success.size(), 3U);
    EXPECT_EQ(three.costs.size(), 9U);
    // a and c are the same: all pairs tie, so that nothing is tested.
    EXPECT_EQ(three.costs[1].comparison.test.refusal, "only 0 of 40 pairs differ; a test needs 6");
    EXPECT_NEAR(*three.costs[0].p, 2 * *three.costs[0].comparison.test.p, 1e-15);
}

/// Two planners on a hundred instances, or as many copies of one.
ResultTable hundred(const FakeCampaign::Outcome &outcome, bool areCopies = false,
                    MotionRule second = MotionRule::pebble)
{
    FakeCampaign campaign("hundred", 100);
    campaign.planner("A").planner("B", second).problem("m", "p", gridInstance(4, 1));
    return campaign.run(
        [&](RunRecord &record, std::size_t planner)
        {
            solveSmoothly(record, 0);
            record.instanceFingerprint = areCopies ? "one" : std::to_string(record.repetition);
            outcome(record, planner);
        });
}

TEST(Findings, TakeTheirDirectionFromTheStatistic)
{
    // A is a little shorter on 52 instances and much longer on the others: the ranks are in favour of B.
    const Findings findings = findingsOf(caseTable(hundred(
        [](RunRecord &record, std::size_t planner)
        {
            record.pathLength = planner == 1 ? 100 : record.repetition < 52 ? 96 : 200;
            record.makespan = 5;
            record.time = 1;
        })));
    const CostFinding &moves = findings.costs.front();
    EXPECT_TRUE(moves.isSignificant());
    EXPECT_FALSE(moves.isClear());
    EXPECT_EQ(moves.first, "B");
    for (const std::string &sentence : findings.sentences())
        EXPECT_THAT(sentence, ::testing::Not(HasSubstr("fewer moves")));
    EXPECT_THAT(
        moves.sentence(),
        HasSubstr(
            "B (pebble) and A (pebble) differ in moves without a clear direction: the signed ranks are in "
            "favour of the first (rank-biserial correlation 0."));
    EXPECT_THAT(moves.sentence(), HasSubstr("its median ratio to the second is 1.04"));
}

TEST(Findings, OfCopiesOfOneInstanceAreNotTested)
{
    const Findings findings = findingsOf(caseTable(hundred(
        [](RunRecord &record, std::size_t planner)
        {
            record.pathLength = planner == 1 ? 100 : 79;
            record.time = (planner == 1 ? 2 : 1) * (1 + 0.01 * static_cast<double>(record.repetition));
        },
        true)));
    EXPECT_EQ(findings.costs.front().comparison.pairs, 1U);
    for (const CostFinding &finding : findings.costs)
        EXPECT_FALSE(finding.p);
    for (const SuccessFinding &finding : findings.success)
        EXPECT_FALSE(finding.p);
    EXPECT_EQ(findings.success.front().cases, 1U);
    EXPECT_NEAR(findings.costs.back().comparison.medianRatio, 0.5, 1e-12); // of the copies' median times
}

TEST(Findings, CountProofsApartFromWhatIsSolved)
{
    // A tenth has no solution: B proves it, A gives up.
    const Findings findings = findingsOf(caseTable(hundred(
        [](RunRecord &record, std::size_t planner)
        {
            if (record.repetition >= 10)
                return;
            record.status = planner == 1 ? PlannerStatus::infeasible : PlannerStatus::gave_up;
            record.solvable = "no";
        })));
    ASSERT_EQ(findings.success.size(), 2U);
    EXPECT_EQ(findings.success[0].kind, SuccessFinding::Kind::solved);
    EXPECT_EQ(findings.success[0].cases, 90U);
    EXPECT_EQ(findings.success[0].firstAnswered, 90U);
    EXPECT_EQ(findings.success[0].secondAnswered, 90U);
    EXPECT_EQ(findings.success[1].kind, SuccessFinding::Kind::proved);
    EXPECT_EQ(findings.success[1].cases, 10U);
    EXPECT_EQ(findings.success[1].first, "B");
    EXPECT_THAT(findings.success[1].sentence(),
                HasSubstr("B (pebble) proves more instances unsolvable than A (pebble): 10 "
                          "that A (pebble) does not, against 0 the other way"));
}

TEST(Findings, LeaveOutWhatOneOfThemIsNotFor)
{
    const Findings findings = findingsOf(caseTable(hundred(
        [](RunRecord &record, std::size_t planner)
        {
            if (planner == 1 && record.repetition < 60)
                record.status = PlannerStatus::unsupported;
        })));
    EXPECT_EQ(findings.success.front().cases, 40U);
    EXPECT_FALSE(findings.success.front().p);
}

TEST(Findings, SayWhereMotionRulesDiffer)
{
    const Findings findings =
        findingsOf(caseTable(hundred([](RunRecord &, std::size_t) {}, false, MotionRule::rotation)));
    EXPECT_THAT(findings.sentences().front(),
                HasSubstr("obey different motion rules (pebble: A; rotation: B)"));
    EXPECT_EQ(findingsOf(caseTable(hundred([](RunRecord &, std::size_t) {}))).caveat, "");
}

TEST(Findings, DoNotCallPlannersFasterByLessThanATenth)
{
    const auto timed = [](double factor)
    {
        return findingsOf(caseTable(hundred(
                              [factor](RunRecord &record, std::size_t planner)
                              {
                                  record.pathLength = 10;
                                  record.makespan = 5;
                                  record.time = (planner == 1 ? factor : 1) *
                                                (1 + 0.01 * static_cast<double>(record.repetition));
                              })))
            .sentences();
    };
    EXPECT_THAT(timed(1.2), ::testing::Contains(HasSubstr("A (pebble) is faster than B (pebble)")));
    EXPECT_THAT(timed(1.05), ::testing::Not(::testing::Contains(HasSubstr("is faster"))));
    EXPECT_THAT(timed(1.05),
                ::testing::Contains(HasSubstr("Differences in time that are more than chance, but less than "
                                              "a tenth: A (pebble) and B (pebble) (median ratio 0.95, p < "
                                              "0.001).")));
}

TEST(RatioText, ShowsWhatTellsARatioFromNothingAndFromOne)
{
    EXPECT_EQ(ratioText(1), "1");
    EXPECT_EQ(ratioText(0), "0");
    EXPECT_EQ(ratioText(0.714), "0.71");
    EXPECT_EQ(ratioText(12.345), "12.35");
    EXPECT_EQ(ratioText(1.0003), "1.0003");
    EXPECT_EQ(ratioText(0.9996), "0.9996");
    EXPECT_EQ(ratioText(0.0004), "0.0004");
    EXPECT_EQ(ratioText(1e-12), "1e-12");
    EXPECT_EQ(ratioText(std::numeric_limits<double>::infinity()), "∞");
}

TEST(Findings, OfOnePlannerAreNone)
{
    EXPECT_TRUE(findingsOf(caseTable(sweep({"a"}, kNever))).sentences().empty());
}

} // namespace
} // namespace mrpp
