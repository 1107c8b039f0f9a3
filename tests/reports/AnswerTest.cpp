#include "reports/Answer.h"

#include <gtest/gtest.h>

namespace mrpp
{
namespace
{

RunRecord run(PlannerStatus status, std::optional<double> time = {})
{
    RunRecord record;
    record.status = status;
    record.time = time;
    return record;
}

Answer answerOf(const std::vector<RunRecord> &runs)
{
    Answer answer;
    for (const RunRecord &record : runs)
        answer.add(record);
    return answer;
}

using enum PlannerStatus;

TEST(Answer, OfCopiesIsTheirMedian)
{
    const std::vector<RunRecord> runs = {run(solved, 5), run(solved, 1), run(solved, 2), run(solved, 3)};
    const Answer answer = answerOf(runs);
    EXPECT_TRUE(answer.solved());
    EXPECT_EQ(answer.runs(), 4U);
    EXPECT_EQ(answer.cost("time"), 2.5);
    EXPECT_EQ(answer.cost("path_length"), std::nullopt);
}

TEST(Answer, OfCopiesIsWhatMoreThanHalfOfThemGave)
{
    const std::vector<RunRecord> most = {run(timeout, 9), run(solved, 1), run(solved, 2)};
    EXPECT_TRUE(answerOf(most).solved());
    EXPECT_EQ(answerOf(most).cost("time"), 2); // 1, 2 and a failure above both
    const std::vector<RunRecord> half = {run(solved, 1), run(timeout, 9)};
    EXPECT_FALSE(answerOf(half).solved());
    EXPECT_EQ(answerOf(half).status(), timeout);
    EXPECT_EQ(answerOf(half).cost("time"), std::nullopt);
    const std::vector<RunRecord> mixed = {run(solved, 1), run(timeout, 9), run(gave_up), run(gave_up)};
    EXPECT_EQ(answerOf(mixed).status(), gave_up);
}

TEST(Answer, KnowsWhatCounts)
{
    RunRecord hopeless = run(gave_up);
    hopeless.solvable = "no";
    const std::vector<RunRecord> runs = {run(solved), run(infeasible), run(unsupported), run(timeout),
                                         hopeless};
    std::vector<bool> counts;
    for (const RunRecord &record : runs)
    {
        Answer answer;
        answer.add(record);
        counts.push_back(answer.counts());
    }
    EXPECT_EQ(counts, (std::vector<bool>{true, false, false, true, false}));
    EXPECT_EQ(outcomeOf(infeasible), Outcome::proved);
    EXPECT_EQ(outcomeOf(unsupported), Outcome::doesNotApply);
    EXPECT_EQ(outcomeOf(partial), Outcome::failed);
    EXPECT_FALSE(Answer().isFinished());
    EXPECT_FALSE(Answer().solved());
}

TEST(InstanceNumbers, AreThoseOfFingerprintsElseOfCases)
{
    std::vector<RunRecord> runs(5);
    runs[0].caseId = "m/p/0";
    runs[0].instanceFingerprint = "a";
    runs[1].caseId = "m/p/1";
    runs[1].instanceFingerprint = "a";
    runs[2].caseId = "m/p/1"; // a crash that never said what its instance was
    runs[3].caseId = "m/q/0";
    runs[4].caseId = "m/q/1";
    InstanceNumbers numbers(runs);
    std::vector<std::size_t> all;
    for (const RunRecord &record : runs)
        all.push_back(numbers.of(record));
    EXPECT_EQ(all, (std::vector<std::size_t>{0, 0, 0, 1, 2}));
}

} // namespace
} // namespace mrpp
