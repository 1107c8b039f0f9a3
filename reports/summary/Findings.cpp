#include "reports/summary/Findings.h"

#include "framework/statistics/Proportion.h"
#include "framework/statistics/Quantiles.h"
#include "reports/picture/Text.h"
#include "reports/summary/Aggregate.h"

#include <array>
#include <cmath>
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
            const auto x = one.answers[a].cost(column);
            const auto y = one.answers[b].cost(column);
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
    const bool isTurned = finding.comparison.rankBiserial() < 0;
    if (isTurned)
        finding.comparison = comparePairs(second, first);
    const CaseTable &table = points.front();
    finding.first = table.planners[isTurned ? b : a];
    finding.second = table.planners[isTurned ? a : b];
    finding.firstRule = table.rules[isTurned ? b : a];
    finding.secondRule = table.rules[isTurned ? a : b];
    finding.pointsLess = isTurned ? secondWins : firstWins;
    return finding;
}

/// Nothing where no instance is of that kind.
std::optional<SuccessFinding> compareSuccess(const CaseTable &cases, std::size_t a, std::size_t b,
                                             SuccessFinding::Kind kind)
{
    const bool proofs = kind == SuccessFinding::Kind::proved;
    const auto concerns = [proofs](const Answer &answer) {
        return answer.isFinished() && answer.outcome() != Outcome::doesNotApply &&
               answer.unsolvable() == proofs;
    };
    const auto answered = [proofs](const Answer &answer)
    { return proofs ? answer.outcome() == Outcome::proved : answer.solved(); };
    SuccessFinding finding;
    finding.kind = kind;
    for (const Case &one : cases.cases)
    {
        if (!concerns(one.answers[a]) || !concerns(one.answers[b]))
            continue;
        ++finding.cases;
        const bool x = answered(one.answers[a]);
        const bool y = answered(one.answers[b]);
        finding.firstAnswered += x ? 1 : 0;
        finding.secondAnswered += y ? 1 : 0;
        finding.onlyFirst += x && !y ? 1 : 0;
        finding.onlySecond += y && !x ? 1 : 0;
    }
    if (finding.cases == 0)
        return std::nullopt;
    const bool isTurned = finding.onlySecond > finding.onlyFirst;
    finding.first = cases.planners[isTurned ? b : a];
    finding.second = cases.planners[isTurned ? a : b];
    finding.firstRule = cases.rules[isTurned ? b : a];
    finding.secondRule = cases.rules[isTurned ? a : b];
    if (isTurned)
    {
        std::swap(finding.firstAnswered, finding.secondAnswered);
        std::swap(finding.onlyFirst, finding.onlySecond);
    }
    const std::size_t discordant = finding.onlyFirst + finding.onlySecond;
    if (discordant >= kLeastForSignTest)
        finding.p = signTest(finding.onlyFirst, finding.onlySecond);
    else
        finding.refusal = fmt::format("only {} of {} by one of them alone; a test needs {}", discordant,
                                      counted(finding.cases, "instance"), kLeastForSignTest);
    return finding;
}

void correct(Findings &findings)
{
    std::vector<double> p;
    for (const SuccessFinding &finding : findings.success)
        if (finding.p)
            p.push_back(*finding.p);
    std::vector<double> adjusted = holmAdjusted(p);
    std::size_t next = 0;
    for (SuccessFinding &finding : findings.success)
        if (finding.p)
            finding.p = adjusted[next++];
    p.clear();
    for (const CostFinding &finding : findings.costs)
        if (finding.comparison.test.p)
            p.push_back(*finding.comparison.test.p);
    adjusted = holmAdjusted(p);
    next = 0;
    for (CostFinding &finding : findings.costs)
        if (finding.comparison.test.p)
            finding.p = adjusted[next++];
}

template <class Finding>
std::string firstName(const Finding &finding)
{
    return withRule(oneLine(finding.first), finding.firstRule);
}
template <class Finding>
std::string secondName(const Finding &finding)
{
    return withRule(oneLine(finding.second), finding.secondRule);
}

/// "a and b; c and d".
class PairList
{
public:
    template <class Finding>
    void add(const Finding &finding, const std::string &remark = "")
    {
        text_ += (text_.empty() ? "" : "; ") + firstName(finding) + " and " + secondName(finding) +
                 (remark.empty() ? "" : " (" + remark + ")");
    }
    /// \param words with {} for the list
    void sayIn(std::vector<std::string> &sentences, const std::string &words) const
    {
        if (!text_.empty())
            sentences.push_back(fmt::format(fmt::runtime(words), text_));
    }

private:
    std::string text_;
};

void saySuccess(std::vector<std::string> &list, const std::vector<SuccessFinding> &findings,
                SuccessFinding::Kind kind, const std::string &what)
{
    PairList same;
    PairList untested;
    for (const SuccessFinding &finding : findings)
    {
        if (finding.kind != kind)
            continue;
        if (finding.isSignificant())
            list.push_back(finding.sentence());
        else if (finding.p)
            same.add(finding, pText(*finding.p));
        else
            untested.add(finding, finding.refusal);
    }
    same.sayIn(list, "No difference in what they " + what + " is shown between {}.");
    untested.sayIn(list, "Not tested for what they " + what + ": {}.");
}

void sayCosts(std::vector<std::string> &list, const std::vector<CostFinding> &findings,
              const Measure &measure)
{
    PairList small;
    PairList same;
    PairList untested;
    for (const CostFinding &finding : findings)
    {
        if (finding.column != measure.column)
            continue;
        const PairedComparison &comparison = finding.comparison;
        if (finding.isSignificant() && finding.isClear() && finding.isSmall())
            small.add(finding, fmt::format("median ratio {}, {}", ratioText(comparison.medianRatio),
                                           pText(*finding.p)));
        else if (finding.isSignificant())
            list.push_back(finding.sentence());
        else if (finding.p)
            same.add(finding, pText(*finding.p));
        else
            untested.add(finding, comparison.test.refusal);
    }
    small.sayIn(list, fmt::format("Differences in {} that are more than chance, but less than a tenth: {{}}.",
                                  measure.about));
    same.sayIn(list, fmt::format("No difference in {} is shown between {{}}.", measure.about));
    untested.sayIn(list, fmt::format("Not tested for {}: {{}}.", measure.about));
}

std::string caveatOf(const CaseTable &cases)
{
    std::map<std::string, std::string> planners; // by rule
    for (std::size_t p = 0; p < cases.planners.size(); ++p)
    {
        std::string &list = planners[cases.rules[p]];
        list += (list.empty() ? "" : ", ") + oneLine(cases.planners[p]);
    }
    if (planners.size() < 2)
        return "";
    std::string text;
    for (const auto &[rule, list] : planners)
        text.append(text.empty() ? "" : "; ").append(rule).append(": ").append(list);
    return "The planners' solutions obey different motion rules (" + text +
           "): a wider rule allows moves that a narrower one forbids, so differences between them are of "
           "rule and "
           "planner together.";
}

} // namespace

std::string pText(double p)
{
    return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", p);
}

std::string ratioText(double ratio)
{
    if (std::isinf(ratio))
        return "∞";
    if (ratio == 1 || ratio == 0)
        return fmt::format("{:.0f}", ratio);
    constexpr int kMostDecimals = 9;
    const double distance = std::min(ratio, std::abs(ratio - 1));
    for (int decimals = 2; decimals < kMostDecimals; ++decimals)
        if (distance >= std::pow(10.0, -decimals))
            return fmt::format("{:.{}f}", ratio, decimals);
    return fmt::format("{:.3g}", ratio);
}

bool CostFinding::isClear() const
{
    using Direction = PairedComparison::Direction;
    return comparison.direction() == Direction::first || comparison.direction() == Direction::second;
}

bool CostFinding::isSmall() const
{
    return column == "time" && comparison.medianRatio > 1 / kLeastTimeRatio &&
           comparison.medianRatio < kLeastTimeRatio;
}

std::string CostFinding::sentence() const
{
    const std::string interval =
        comparison.ratioInterval ? fmt::format(", 95 % CI {}–{}", ratioText(comparison.ratioInterval->low),
                                               ratioText(comparison.ratioInterval->high))
                                 : fmt::format(", no interval of {} pairs", comparison.pairs);
    const std::string counts =
        fmt::format("{} that both solved, less on {}, more on {}", counted(comparison.pairs, "instance"),
                    comparison.firstLess, comparison.secondLess);
    const std::string test = fmt::format("Wilcoxon signed-rank {}, Holm-corrected", pText(p.value_or(1)));
    if (!isClear())
        return fmt::format(
            "{} and {} differ in {} without a clear direction: the signed ranks are in favour of the "
            "first (rank-biserial correlation {:.2f}), but its median ratio to the second is {}{} ({}; "
            "{}).",
            firstName(*this), secondName(*this), measureOf(column).about, comparison.rankBiserial(),
            ratioText(comparison.medianRatio), interval, counts, test);
    return fmt::format("{} {} {} on {} of {}, median ratio {}{} ({}; {}; rank-biserial correlation {:.2f}).",
                       firstName(*this), measureOf(column).less, secondName(*this), pointsLess,
                       counted(points, "point"), ratioText(comparison.medianRatio), interval, counts, test,
                       comparison.rankBiserial());
}

std::string SuccessFinding::sentence() const
{
    const std::string test =
        fmt::format("Wilson intervals; McNemar exact {}, Holm-corrected", pText(p.value_or(1)));
    const std::string one = firstName(*this);
    const std::string other = secondName(*this);
    const std::string answered =
        fmt::format("{} against {}", percentText(firstAnswered, cases), percentText(secondAnswered, cases));
    if (kind == Kind::proved)
        return fmt::format(
            "{} proves more instances unsolvable than {}: {} that {} does not, against {} the other way; "
            "{} of {} without a solution ({}).",
            one, other, onlyFirst, other, onlySecond, answered, counted(cases, "instance"), test);
    return fmt::format(
        "{} solves more than {}: {} that {} does not, against {} the other way; {} of {} that have a "
        "solution and to which both apply ({}).",
        one, other, counted(onlyFirst, "instance"), other, onlySecond, answered, counted(cases, "instance"),
        test);
}

std::vector<std::string> Findings::sentences() const
{
    std::vector<std::string> list;
    if (!caveat.empty())
        list.push_back(caveat);
    saySuccess(list, success, SuccessFinding::Kind::solved, "solve");
    saySuccess(list, success, SuccessFinding::Kind::proved, "prove unsolvable");
    for (const Measure &measure : kMeasures)
        sayCosts(list, costs, measure);
    return list;
}

Findings findingsOf(const CaseTable &cases)
{
    Findings findings;
    const std::vector<CaseTable> points = cases.byPoint();
    if (points.empty() || cases.planners.size() < 2)
        return findings;
    findings.caveat = caveatOf(cases);
    for (const SuccessFinding::Kind kind : {SuccessFinding::Kind::solved, SuccessFinding::Kind::proved})
        for (std::size_t a = 0; a < cases.planners.size(); ++a)
            for (std::size_t b = a + 1; b < cases.planners.size(); ++b)
                if (auto finding = compareSuccess(cases, a, b, kind))
                    findings.success.push_back(std::move(*finding));
    for (const Measure &measure : kMeasures)
        for (std::size_t a = 0; a < cases.planners.size(); ++a)
            for (std::size_t b = a + 1; b < cases.planners.size(); ++b)
                findings.costs.push_back(compareCosts(points, a, b, measure.column));
    correct(findings);
    return findings;
}

} // namespace mrpp
