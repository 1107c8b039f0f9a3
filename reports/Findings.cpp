#include "reports/Findings.h"

#include "framework/support/Proportion.h"
#include "framework/support/Quantiles.h"
#include "reports/drawing/Text.h"

#include <array>
#include <fmt/format.h>
#include <map>

namespace mrpp
{

namespace
{

struct Measure
{
    const char *column;
    const char *less;  ///< what the better planner does
    const char *about; ///< for sentences about what was not shown
};

constexpr std::array<Measure, 3> kMeasures = {{
    {"path_length", "needs fewer moves than", "moves"},
    {"makespan", "needs fewer parallel steps than", "parallel steps"},
    {"time", "is faster than", "time"},
}};

const Measure &measureOf(const std::string &column)
{
    for (const Measure &measure : kMeasures)
        if (column == measure.column)
            return measure;
    return kMeasures.front();
}

std::string percentText(std::size_t part, std::size_t whole)
{
    const Interval interval = wilsonInterval(part, whole);
    return fmt::format("{:.1f} % [{:.1f}, {:.1f}]",
                       100 * static_cast<double>(part) / static_cast<double>(whole), 100 * interval.low,
                       100 * interval.high);
}

CostFinding compareCosts(const std::vector<CaseTable> &points, std::size_t a, std::size_t b,
                         const char *column)
{
    std::vector<double> first;
    std::vector<double> second;
    std::size_t pointCount = 0;
    std::size_t firstWins = 0;
    std::size_t secondWins = 0;
    for (const CaseTable &point : points)
    {
        std::vector<double> ownFirst;
        std::vector<double> ownSecond;
        for (const Case &one : point.cases)
        {
            const auto x = costOf(one.runs[a], column);
            const auto y = costOf(one.runs[b], column);
            if (!x || !y)
                continue;
            ownFirst.push_back(*x);
            ownSecond.push_back(*y);
        }
        if (ownFirst.empty())
            continue;
        ++pointCount;
        first.insert(first.end(), ownFirst.begin(), ownFirst.end());
        second.insert(second.end(), ownSecond.begin(), ownSecond.end());
        const double x = median(std::move(ownFirst));
        const double y = median(std::move(ownSecond));
        firstWins += x < y ? 1 : 0;
        secondWins += y < x ? 1 : 0;
    }
    CostFinding finding;
    finding.column = column;
    finding.points = pointCount;
    finding.comparison = comparePairs(first, second);
    const PairedComparison &forward = finding.comparison;
    const bool isTurned =
        forward.medianRatio != 1 ? forward.medianRatio > 1 : forward.secondLess > forward.firstLess;
    if (isTurned)
        finding.comparison = comparePairs(second, first);
    finding.first = points.front().planners[isTurned ? b : a];
    finding.second = points.front().planners[isTurned ? a : b];
    finding.pointsLess = isTurned ? secondWins : firstWins;
    return finding;
}

SuccessFinding compareSuccess(const CaseTable &cases, std::size_t a, std::size_t b)
{
    SuccessFinding finding;
    for (const Case &one : cases.cases)
    {
        if (one.runs[a] == nullptr || one.runs[b] == nullptr)
            continue;
        ++finding.cases;
        const bool x = one.runs[a]->solved();
        const bool y = one.runs[b]->solved();
        finding.firstSolved += x ? 1 : 0;
        finding.secondSolved += y ? 1 : 0;
        finding.onlyFirst += x && !y ? 1 : 0;
        finding.onlySecond += y && !x ? 1 : 0;
    }
    finding.first = cases.planners[a];
    finding.second = cases.planners[b];
    if (finding.onlySecond > finding.onlyFirst)
    {
        std::swap(finding.first, finding.second);
        std::swap(finding.firstSolved, finding.secondSolved);
        std::swap(finding.onlyFirst, finding.onlySecond);
    }
    finding.p = signTest(finding.onlyFirst, finding.onlySecond);
    return finding;
}

void correct(Findings &findings)
{
    std::vector<double> p;
    for (const SuccessFinding &finding : findings.success)
        p.push_back(finding.p);
    std::vector<double> adjusted = holmAdjusted(p);
    for (std::size_t i = 0; i < adjusted.size(); ++i)
        findings.success[i].p = adjusted[i];
    p.clear();
    for (const CostFinding &finding : findings.costs)
        if (finding.comparison.test.p)
            p.push_back(*finding.comparison.test.p);
    adjusted = holmAdjusted(p);
    std::size_t next = 0;
    for (CostFinding &finding : findings.costs)
        if (finding.comparison.test.p)
            finding.p = adjusted[next++];
}

std::string pairText(const std::string &first, const std::string &second)
{
    return oneLine(first) + " and " + oneLine(second);
}

} // namespace

std::string pText(double p)
{
    return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", p);
}

std::string CostFinding::sentence() const
{
    const std::string interval = comparison.ratioInterval
                                     ? fmt::format(", 95 % CI {:.2f}–{:.2f}", comparison.ratioInterval->low,
                                                   comparison.ratioInterval->high)
                                     : fmt::format(", no interval of {} pairs", comparison.pairs);
    return fmt::format(
        "{} {} {} on {} of {}, median ratio {:.2f}{} ({} that both solved, fewer on {}, more on {}; "
        "Wilcoxon signed-rank {}, Holm-corrected; A12 = {:.2f}).",
        oneLine(first), measureOf(column).less, oneLine(second), pointsLess, counted(points, "point"),
        comparison.medianRatio, interval, counted(comparison.pairs, "case"), comparison.firstLess,
        comparison.secondLess, pText(p.value_or(1)), comparison.a12);
}

std::string SuccessFinding::sentence() const
{
    return fmt::format(
        "{} solves more than {}: {} that {} does not, against {} the other way; {} against {} of {} "
        "(Wilson intervals; McNemar exact {}, Holm-corrected).",
        oneLine(first), oneLine(second), counted(onlyFirst, "case"), oneLine(second), onlySecond,
        percentText(firstSolved, cases), percentText(secondSolved, cases), counted(cases, "case"), pText(p));
}

std::vector<std::string> Findings::sentences() const
{
    std::vector<std::string> list;
    std::string same;
    for (const SuccessFinding &finding : success)
        if (finding.isSignificant())
            list.push_back(finding.sentence());
        else
            same += (same.empty() ? "" : "; ") + pairText(finding.first, finding.second);
    if (!same.empty())
        list.push_back("No difference in what they solve is shown between " + same + ".");
    for (const Measure &measure : kMeasures)
    {
        same.clear();
        std::string untested;
        for (const CostFinding &finding : costs)
        {
            if (finding.column != measure.column)
                continue;
            const std::string pair = pairText(finding.first, finding.second);
            if (finding.isSignificant())
                list.push_back(finding.sentence());
            else if (finding.p)
                same += fmt::format("{}{} ({})", same.empty() ? "" : "; ", pair, pText(*finding.p));
            else
                untested += fmt::format("{}{} ({})", untested.empty() ? "" : "; ", pair,
                                        finding.comparison.test.refusal);
        }
        if (!same.empty())
            list.push_back(fmt::format("No difference in {} is shown between {}.", measure.about, same));
        if (!untested.empty())
            list.push_back(fmt::format("Not tested for {}: {}.", measure.about, untested));
    }
    return list;
}

Findings findingsOf(const CaseTable &cases)
{
    Findings findings;
    const std::vector<CaseTable> points = cases.byPoint();
    if (points.empty())
        return findings;
    for (std::size_t a = 0; a < cases.planners.size(); ++a)
        for (std::size_t b = a + 1; b < cases.planners.size(); ++b)
            if (SuccessFinding finding = compareSuccess(cases, a, b); finding.cases > 0)
                findings.success.push_back(std::move(finding));
    for (const Measure &measure : kMeasures)
        for (std::size_t a = 0; a < cases.planners.size(); ++a)
            for (std::size_t b = a + 1; b < cases.planners.size(); ++b)
                findings.costs.push_back(compareCosts(points, a, b, measure.column));
    correct(findings);
    return findings;
}

} // namespace mrpp
