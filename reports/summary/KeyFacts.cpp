#include "reports/summary/KeyFacts.h"

#include "framework/PlannerStatus.h"
#include "framework/statistics/Quantiles.h"
#include "reports/picture/Text.h"
#include "reports/summary/CaseTable.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace mrpp
{

namespace
{

constexpr std::size_t kNamedPlanners = 6;

/// "a", "a and b", "a, b and c"; of many the first few and how many more.
std::string listed(const std::vector<std::string> &items)
{
    const std::size_t named = std::min(items.size(), kNamedPlanners);
    std::string text;
    for (std::size_t i = 0; i < named; ++i)
        text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    if (named < items.size())
        text += fmt::format(" and {} more", items.size() - named);
    return text;
}

std::string howRunsEnded(const ResultTable &results, const CaseTable &cases)
{
    std::map<PlannerStatus, std::size_t> ends;
    for (const RunRecord &run : results.records())
        ++ends[run.status];
    std::vector<std::string> others;
    for (const auto &[status, count] : ends)
        if (status != PlannerStatus::solved)
            others.push_back(fmt::format("{} {}", count, spaced(toString(status))));
    std::string text =
        fmt::format("Of {} on {}, {} solved", counted(results.records().size(), "finished run"),
                    counted(cases.cases.size(), "distinct instance"), ends[PlannerStatus::solved]);
    text += others.empty() ? "." : "; the others: " + fmt::format("{}.", fmt::join(others, ", "));
    const auto unsolvable = static_cast<std::size_t>(
        std::ranges::count_if(results.records(), [](const RunRecord &run) { return run.unsolvable(); }));
    if (unsolvable > 0)
        text +=
            fmt::format(" {} had no solution under the planner's motion rule.", counted(unsolvable, "run"));
    if (results.records().size() < results.plannedRuns())
        text += fmt::format(" {} still missing, so all of this may change.",
                            counted(results.plannedRuns() - results.records().size(), "planned run"));
    return text;
}

/// What each planner answered, of those instances alone that every planner has finished.
struct Answered
{
    std::size_t solved = 0;
    std::size_t counted = 0; ///< that it could have solved: see Answer::counts()
    std::size_t proved = 0;
    std::size_t unsolvable = 0; ///< and to which it applies
};

Answered answeredBy(std::size_t planner, const CaseTable &finished)
{
    Answered answered;
    for (const Case &one : finished.cases)
    {
        const Answer &answer = one.answers[planner];
        answered.solved += answer.solved() ? 1 : 0;
        answered.counted += answer.counts() ? 1 : 0;
        answered.proved += answer.outcome() == Outcome::proved ? 1 : 0;
        answered.unsolvable += answer.unsolvable() && answer.outcome() != Outcome::doesNotApply ? 1 : 0;
    }
    return answered;
}

std::string whoSolvedMost(const CaseTable &finished)
{
    if (finished.cases.empty())
        return "No instance was finished by every planner, so their success cannot be compared.";
    std::vector<std::pair<std::size_t, std::string>> solved; // with the number, for the order
    std::vector<std::string> proved;
    for (std::size_t p = 0; p < finished.planners.size(); ++p)
    {
        const Answered answered = answeredBy(p, finished);
        solved.emplace_back(answered.solved,
                            fmt::format("{} {} of {}", finished.name(p), answered.solved, answered.counted));
        if (answered.unsolvable > 0)
            proved.push_back(
                fmt::format("{} {} of {}", finished.name(p), answered.proved, answered.unsolvable));
    }
    std::stable_sort(solved.begin(), solved.end(),
                     [](const auto &a, const auto &b) { return a.first > b.first; });
    std::vector<std::string> items;
    for (const auto &[count, text] : solved)
        items.push_back(oneLine(text));
    for (std::string &text : proved)
        text = oneLine(text);
    std::string text = fmt::format("Solved, of the {} that {} finished, where there is a solution under the "
                                   "planner's motion rule and it applies: {}.",
                                   counted(finished.cases.size(), "instance"),
                                   finished.planners.size() == 1 ? "it" : "all planners", listed(items));
    if (!proved.empty())
        text += fmt::format(" Proved, of those without a solution: {}.", listed(proved));
    return text;
}

std::string howLongPathsAre(const CaseTable &finished)
{
    const CommonCases common = commonCases(finished, "path_length", "path_length_lower_bound");
    const bool isAlone = finished.planners.size() == 1;
    if (common.planners.empty())
        return isAlone
                   ? "There is no solution whose path length could be compared with a lower bound."
                   : fmt::format(
                         "No two planners have solved {} instances with a positive lower bound in common, so "
                         "their path lengths are not compared here.",
                         kLeastInCommon);
    std::vector<std::pair<double, std::string>> medians;
    for (const std::size_t p : common.planners)
    {
        std::vector<double> ratios;
        for (const Case *one : common.cases)
            ratios.push_back(*one->answers[p].cost("path_length") /
                             *one->answers[p].cost("path_length_lower_bound"));
        const Quartiles middle = quartiles(std::move(ratios)).value_or(Quartiles());
        std::string text = fmt::format("{} {:.2f}", oneLine(finished.name(p)), middle.median);
        if (middle.hasBand())
            text += fmt::format(" [{:.2f}, {:.2f}]", middle.q1, middle.q3);
        medians.emplace_back(middle.median, std::move(text));
    }
    std::stable_sort(medians.begin(), medians.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<std::string> items;
    for (auto &[median, text] : medians)
        items.push_back(std::move(text));
    std::string text = fmt::format(
        "Median path length over its lower bound [quartiles], before optimizing, on the instances that {} "
        "solved (n = {}): {}.",
        isAlone                  ? "it"
        : common.leftOut.empty() ? "every planner"
                                 : "all of these planners",
        common.cases.size(), listed(items));
    std::vector<std::string> leftOut;
    for (const std::size_t p : common.leftOut)
        leftOut.push_back(oneLine(finished.name(p)));
    if (!leftOut.empty())
        text += fmt::format(" Not among them, for having solved too few of the same: {}.", listed(leftOut));
    return text;
}

} // namespace

std::vector<std::string> keyFacts(const ResultTable &results)
{
    if (results.records().empty())
        return {};
    const CaseTable cases = caseTable(results);
    const CaseTable finished = cases.finished();
    return {howRunsEnded(results, cases), whoSolvedMost(finished), howLongPathsAre(finished)};
}

} // namespace mrpp
