#include "reports/KeyFacts.h"

#include "framework/PlannerStatus.h"
#include "reports/Aggregate.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace mrpp
{

namespace
{

constexpr std::size_t kNamedPlanners = 6;

/// The runs on one instance, one of each planner.
using Cases = std::map<std::string, std::vector<const RunRecord *>>;

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

std::string howRunsEnded(const ResultTable &results)
{
    std::map<PlannerStatus, std::size_t> ends;
    for (const RunRecord &run : results.records())
        ++ends[run.status];
    std::vector<std::string> others;
    for (const auto &[status, count] : ends)
        if (status != PlannerStatus::solved)
            others.push_back(fmt::format("{} {}", count, spaced(toString(status))));
    std::string text = fmt::format("Of {}, {} solved", counted(results.records().size(), "finished run"),
                                   ends[PlannerStatus::solved]);
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

/// \param cases that every planner has finished
std::string whoSolvedMost(const std::vector<std::string> &planners, const Cases &cases)
{
    if (cases.empty())
        return "No case was finished by every planner, so their success cannot be compared.";
    std::map<std::string, std::size_t> solved;
    for (const auto &[name, runs] : cases)
        for (const RunRecord *run : runs)
            solved[run->planner] += run->solved() ? 1 : 0;
    std::size_t most = 0;
    for (const auto &[planner, count] : solved)
        most = std::max(most, count);
    if (planners.size() == 1)
        return fmt::format("{} solved {} of {}.", oneLine(planners.front()), most,
                           counted(cases.size(), "case"));
    if (most == 0)
        return fmt::format("No planner solved any of the {} that all finished.",
                           counted(cases.size(), "case"));
    std::vector<std::string> winners;
    for (const std::string &planner : planners)
        if (solved[planner] == most)
            winners.push_back(oneLine(planner));
    if (winners.size() == planners.size())
        return fmt::format("All planners solved equally many of the {} that all finished: {} each.",
                           counted(cases.size(), "case"), most);
    return fmt::format("Most of the {} that all planners finished {} solved by {}: {}{}.",
                       counted(cases.size(), "case"), "were", listed(winners), most,
                       winners.size() > 1 ? " each" : "");
}

/// \param cases that every planner has finished
std::string howLongPathsAre(const std::vector<std::string> &planners, const Cases &cases)
{
    std::map<std::string, std::vector<double>> ratios;
    std::size_t compared = 0;
    for (const auto &[name, runs] : cases)
    {
        const bool counts = std::all_of(runs.begin(), runs.end(),
                                        [](const RunRecord *run) {
                                            return run->solved() && run->pathLength &&
                                                   run->pathLengthLowerBound.value_or(0) > 0;
                                        });
        if (!counts)
            continue;
        ++compared;
        for (const RunRecord *run : runs)
            ratios[run->planner].push_back(static_cast<double>(*run->pathLength) /
                                           static_cast<double>(*run->pathLengthLowerBound));
    }
    if (compared == 0)
        return planners.size() == 1
                   ? "There is no solution whose path length could be compared with a lower bound."
                   : "No case with a positive lower bound was solved by every planner, so their path "
                     "lengths cannot be compared.";
    std::vector<std::pair<double, std::string>> medians;
    for (const std::string &planner : planners)
        if (const auto summary = quartiles(ratios[planner]))
            medians.emplace_back(summary->median, planner);
    std::stable_sort(medians.begin(), medians.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<std::string> items;
    for (const auto &[median, planner] : medians)
        items.push_back(fmt::format("{} {:.2f}", oneLine(planner), median));
    return fmt::format("Median path length over its lower bound, before optimizing, on the cases that {} "
                       "solved (n = {}): {}.",
                       planners.size() == 1 ? "it" : "every planner", compared, listed(items));
}

} // namespace

std::vector<std::string> keyFacts(const ResultTable &results)
{
    if (results.records().empty())
        return {};
    std::vector<std::string> planners;
    for (const Configured &planner : results.plan().planners)
        planners.push_back(planner.name);
    Cases cases;
    for (const RunRecord &run : results.records())
        cases[run.caseId].push_back(&run);
    std::erase_if(cases, [&](const auto &entry) { return entry.second.size() != planners.size(); });
    return {howRunsEnded(results), whoSolvedMost(planners, cases), howLongPathsAre(planners, cases)};
}

} // namespace mrpp
