#include "reports/summary/CampaignComparison.h"

#include "framework/statistics/Proportion.h"
#include "framework/support/Config.h"
#include "reports/Answer.h"
#include "reports/document/Csv.h"
#include "reports/document/PdfPages.h"
#include "reports/picture/Text.h"
#include "reports/summary/Aggregate.h"
#include "reports/summary/Findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <unordered_map>

namespace mrpp
{

namespace
{

using Verdict = ComparedMeasure::Verdict;

constexpr std::array<const char *, 3> kColumns = {"path_length", "makespan", "time"};
constexpr double kLevel = 0.05;

bool isDefect(const RunRecord &run)
{
    return run.status == PlannerStatus::invalid || run.status == PlannerStatus::crash;
}

/// Whether this pair may have ended otherwise by the machine's mood alone. \param limits of the two campaigns
bool isFlapping(const RunRecord &a, const RunRecord &b, std::pair<double, double> limits, double from)
{
    const auto nearly = [from](const RunRecord &run, double limit)
    { return run.solved() && run.time.value_or(0) >= from * limit; };
    return (a.status == PlannerStatus::timeout && nearly(b, limits.second)) ||
           (b.status == PlannerStatus::timeout && nearly(a, limits.first));
}

bool isAnswered(const RunRecord &run)
{
    return outcomeOf(run.status) == Outcome::solved || outcomeOf(run.status) == Outcome::proved;
}

bool isAnswered(const Answer &answer)
{
    return answer.outcome() == Outcome::solved || answer.outcome() == Outcome::proved;
}

/// One planner on one instance in both campaigns.
struct Pair
{
    Answer first;
    Answer second;
    bool flaps = false; ///< in any of its runs
};

ComparedMeasure compareAnswers(const std::vector<Pair> &pairs, bool withFlapping)
{
    ComparedMeasure measure;
    measure.column = withFlapping ? ComparedMeasure::kAnswered : ComparedMeasure::kAnsweredClearly;
    for (const Pair &pair : pairs)
    {
        if (pair.flaps && !withFlapping)
            continue;
        const bool before = isAnswered(pair.first);
        const bool now = isAnswered(pair.second);
        measure.onlyFirst += before && !now ? 1 : 0;
        measure.onlySecond += now && !before ? 1 : 0;
    }
    if (measure.differing() >= kLeastForSignTest)
        measure.p = signTest(measure.onlyFirst, measure.onlySecond);
    else
        measure.refusal = fmt::format("only {} of {} pairs ended otherwise; a test needs {}",
                                      measure.differing(), pairs.size(), kLeastForSignTest);
    return measure;
}

ComparedMeasure compareCosts(const std::vector<Pair> &pairs, const char *column)
{
    std::vector<double> first;
    std::vector<double> second;
    for (const Pair &pair : pairs)
    {
        const auto a = pair.first.cost(column);
        const auto b = pair.second.cost(column);
        if (!a || !b)
            continue;
        first.push_back(*a);
        second.push_back(*b);
    }
    ComparedMeasure measure;
    measure.column = column;
    measure.costs = comparePairs(second, first); // ratios above 1: became worse
    measure.p = measure.costs.test.p;
    measure.refusal = measure.costs.test.refusal;
    return measure;
}

std::vector<ComparedMeasure> measuresOf(const std::vector<Pair> &pairs)
{
    std::vector<ComparedMeasure> measures = {compareAnswers(pairs, true), compareAnswers(pairs, false)};
    if (measures[1].differing() == measures[0].differing() || !measures[1].p)
        measures.pop_back(); // the same test, or none
    for (const char *column : kColumns)
        measures.push_back(compareCosts(pairs, column));
    return measures;
}

/// The pairs of one planner, together and by problem.
class PlannerPairs
{
public:
    void add(std::size_t instance, const RunRecord &first, const RunRecord &second, bool flaps)
    {
        for (const std::string &problem : {std::string(), first.model + "/" + first.problem})
        {
            Group &group = groups_[problem];
            const auto [known, isNew] = group.byInstance.try_emplace(instance, group.pairs.size());
            if (isNew)
                group.pairs.emplace_back();
            Pair &pair = group.pairs[known->second];
            pair.first.add(first);
            pair.second.add(second);
            pair.flaps = pair.flaps || flaps;
        }
    }

    [[nodiscard]] std::size_t instances() const { return groups_.at("").pairs.size(); }

    /// Of all problems together only what is no test of one of them alone.
    [[nodiscard]] std::vector<ComparedMeasure> measures() const
    {
        std::vector<ComparedMeasure> all;
        std::map<std::string, std::size_t> contributing; // problems with pairs that differ, by column
        std::vector<ComparedMeasure> byProblem;
        for (const auto &[problem, group] : groups_)
            for (ComparedMeasure &measure : measuresOf(group.pairs))
            {
                measure.problem = problem;
                if (!problem.empty() && measure.differing() > 0)
                    ++contributing[measure.column];
                (problem.empty() ? all : byProblem).push_back(std::move(measure));
            }
        std::erase_if(all, [&](const ComparedMeasure &measure) { return contributing[measure.column] < 2; });
        std::move(byProblem.begin(), byProblem.end(), std::back_inserter(all));
        return all;
    }

private:
    struct Group
    {
        std::vector<Pair> pairs;
        std::unordered_map<std::size_t, std::size_t> byInstance;
    };
    std::map<std::string, Group> groups_; // by problem; "" for all
};

Verdict verdictOf(const ComparedMeasure &measure, double timeTolerance)
{
    using Direction = PairedComparison::Direction;
    if (!measure.isCost())
        return measure.onlyFirst > measure.onlySecond ? Verdict::worse : Verdict::better;
    const Direction direction = measure.costs.direction();
    if (direction == Direction::none)
        return Verdict::same;
    if (direction == Direction::unclear)
        return Verdict::unclear;
    const double ratio = measure.costs.medianRatio;
    const double tolerance = 1 + timeTolerance;
    if (measure.column == "time" && ratio <= tolerance && ratio >= 1 / tolerance)
        return Verdict::same;
    return direction == Direction::first ? Verdict::better : Verdict::worse;
}

void judge(CampaignComparison &comparison, const ComparisonOptions &options)
{
    std::vector<double> p;
    for (const ComparedMeasure &measure : comparison.measures)
        if (measure.p)
            p.push_back(*measure.p);
    const std::vector<double> adjusted = holmAdjusted(p);
    std::size_t next = 0;
    for (ComparedMeasure &measure : comparison.measures)
    {
        if (!measure.p)
            continue;
        measure.p = adjusted[next++];
        if (*measure.p < kLevel)
            measure.verdict = verdictOf(measure, options.timeTolerance);
    }
}

std::string place(const ComparedMeasure &measure)
{
    return withRule(oneLine(measure.planner), measure.rule) +
           (measure.problem.empty() ? " on everything" : " on " + oneLine(measure.problem));
}

std::string verdictName(Verdict verdict)
{
    switch (verdict)
    {
    case Verdict::worse:
        return "worse";
    case Verdict::better:
        return "better";
    case Verdict::unclear:
        return "unclear";
    case Verdict::same:
        break;
    }
    return "";
}

PdfTableCell::Emphasis emphasisOf(Verdict verdict)
{
    return verdict == Verdict::worse    ? PdfTableCell::Emphasis::warning
           : verdict == Verdict::better ? PdfTableCell::Emphasis::best
                                        : PdfTableCell::Emphasis::none;
}

} // namespace

std::size_t ComparedMeasure::differing() const
{
    return isCost() ? costs.test.pairs : onlyFirst + onlySecond;
}

std::string ComparedMeasure::sentence() const
{
    if (!isCost())
        return fmt::format("{}: {}{} solved before alone, {} now alone ({})", place(*this),
                           counted(onlyFirst, "instance"),
                           column == kAnswered ? "" : ", those near the time limit aside,", onlySecond,
                           pText(p.value_or(1)));
    const std::string interval = costs.ratioInterval
                                     ? fmt::format(", 95 % CI {}–{}", ratioText(costs.ratioInterval->low),
                                                   ratioText(costs.ratioInterval->high))
                                     : std::string();
    const std::string numbers =
        fmt::format("{}: {} more, {} less; signed-rank {}", counted(costs.pairs, "pair"), costs.secondLess,
                    costs.firstLess, pText(p.value_or(1)));
    const char *byRanks = costs.rankBiserial() > 0 ? "less" : "more";
    if (verdict == Verdict::unclear)
        return fmt::format(
            "{}: {} differs without a clear direction: {} by the signed ranks (rank-biserial correlation "
            "{:.2f}), median ratio {}{} ({})",
            place(*this), spaced(column), byRanks, costs.rankBiserial(), ratioText(costs.medianRatio),
            interval, numbers);
    if (costs.medianRatio == 1) // most pairs are equal
        return fmt::format("{}: {} {} wherever it differs, as a rule{} ({})", place(*this), spaced(column),
                           byRanks, interval, numbers);
    return fmt::format("{}: {} {} times as large{} ({})", place(*this), spaced(column),
                       ratioText(costs.medianRatio), interval, numbers);
}

bool CampaignComparison::hasRegression() const
{
    return !newlyInvalid.empty() ||
           std::any_of(measures.begin(), measures.end(),
                       [](const ComparedMeasure &measure) { return measure.verdict == Verdict::worse; });
}

CampaignComparison compareCampaigns(const ResultTable &first, const ResultTable &second,
                                    const ComparisonOptions &options)
{
    CampaignComparison comparison;
    const auto keyOf = [](const RunRecord &run) { return run.caseId + '\n' + run.planner; };
    std::unordered_map<std::string, const RunRecord *> partners;
    for (const RunRecord &run : second.records())
        partners.emplace(keyOf(run), &run);
    InstanceNumbers instances(first.records());
    std::map<std::string, PlannerPairs> planners;
    const std::pair limits(first.plan().limits.time, second.plan().limits.time);
    for (const RunRecord &run : first.records())
    {
        const auto partner = partners.find(keyOf(run));
        if (partner == partners.end())
        {
            ++comparison.onlyFirst;
            continue;
        }
        ComparedRun pair{&run, partner->second};
        partners.erase(partner);
        if (!run.instanceFingerprint.empty() && !pair.second->instanceFingerprint.empty() &&
            run.instanceFingerprint != pair.second->instanceFingerprint)
        {
            ++comparison.otherInstances;
            continue;
        }
        ++comparison.pairs;
        pair.flaps = isFlapping(run, *pair.second, limits, options.flappingFrom);
        comparison.flapping += pair.flaps ? 1 : 0;
        if (isAnswered(run) != isAnswered(*pair.second))
            comparison.changedEnds.push_back(pair);
        if (isDefect(*pair.second) && !isDefect(run))
            comparison.newlyInvalid.push_back(pair);
        planners[run.planner].add(instances.of(run), run, *pair.second, pair.flaps);
    }
    comparison.onlySecond = partners.size();
    for (const Configured &planner : first.plan().planners)
    {
        const auto own = planners.find(planner.name);
        if (own == planners.end())
            continue;
        comparison.instances += own->second.instances();
        for (ComparedMeasure &measure : own->second.measures())
        {
            measure.planner = planner.name;
            measure.rule = toString(planner.motion);
            comparison.measures.push_back(std::move(measure));
        }
    }
    judge(comparison, options);
    return comparison;
}

std::string comparisonCsv(const CampaignComparison &comparison)
{
    CsvTable table;
    for (const char *name :
         {"planner", "rule", "problem", "measure", "pairs", "more", "less", "median_ratio", "ratio_low",
          "ratio_high", "rank_biserial", "only_before", "only_now", "p_holm", "verdict", "not_tested"})
        table.cell(name);
    table.endRow();
    for (const ComparedMeasure &measure : comparison.measures)
    {
        const bool isCost = measure.isCost();
        const PairedComparison &costs = measure.costs;
        const auto number = [&](bool has, double value)
        { table.cell(has && std::isfinite(value) ? formatNumber(value) : std::string()); };
        table.cell(measure.planner);
        table.cell(measure.rule);
        table.cell(measure.problem);
        table.cell(measure.column);
        number(isCost, static_cast<double>(costs.pairs));
        number(isCost, static_cast<double>(costs.secondLess));
        number(isCost, static_cast<double>(costs.firstLess));
        number(isCost && costs.pairs > 0, costs.medianRatio);
        number(costs.ratioInterval.has_value(), costs.ratioInterval.value_or(Interval()).low);
        number(costs.ratioInterval.has_value(), costs.ratioInterval.value_or(Interval()).high);
        number(isCost && costs.pairs > 0, costs.rankBiserial());
        number(!isCost, static_cast<double>(measure.onlyFirst));
        number(!isCost, static_cast<double>(measure.onlySecond));
        number(measure.p.has_value(), measure.p.value_or(1));
        table.cell(verdictName(measure.verdict));
        table.cell(measure.refusal);
        table.endRow();
    }
    return table.text();
}

std::string comparisonPdf(const CampaignComparison &comparison, const std::vector<std::string> &differences,
                          const Provenance &first, const Provenance &second)
{
    constexpr std::size_t kRunsShown = 200;
    PdfPages pages("Comparison of " + first.campaign, fmt::format("{} · mrppsim compare", first.campaign));
    pages.title(first.campaign, "Two campaigns compared: before and now");
    const auto origin = [](const Provenance &p)
    {
        return fmt::format("{}, mrppsim {} {}, {} {}, on {} ({}), plan {}", p.started, p.version, p.revision,
                           p.compiler, p.buildType, p.host, p.cpu, p.planFingerprint);
    };
    pages.facts(
        {{"Before", origin(first)},
         {"Now", origin(second)},
         {"Pairs", fmt::format("{} runs of the same planner on the same instance, {} without copies",
                               comparison.pairs, comparison.instances)},
         {"Without a partner", fmt::format("{} before, {} now", comparison.onlyFirst, comparison.onlySecond)},
         {"Other instances", std::to_string(comparison.otherInstances) + " pairs left out"},
         {"Flapping timeouts", std::to_string(comparison.flapping) + " pairs, tested with the others"}});
    pages.section("What differs between them");
    if (differences.empty())
        pages.paragraph("Neither settings and limits nor program and machine, as far as they are recorded.");
    for (const std::string &difference : differences)
        pages.paragraph("• " + difference);
    for (const Verdict verdict : {Verdict::worse, Verdict::better, Verdict::unclear})
    {
        pages.section(verdict == Verdict::worse    ? "Regressions"
                      : verdict == Verdict::better ? "Improvements"
                                                   : "Changes without a clear direction");
        bool anything = false;
        for (const ComparedMeasure &measure : comparison.measures)
            if (measure.verdict == verdict)
            {
                pages.paragraph("• " + measure.sentence() + ".");
                anything = true;
            }
        if (verdict == Verdict::worse && !comparison.newlyInvalid.empty())
            pages.paragraph(fmt::format("• {} with a wrong answer or a crash that had none before.",
                                        counted(comparison.newlyInvalid.size(), "run")));
        else if (!anything)
            pages.paragraph("None beyond chance.");
    }
    pages.chapter("Tests");
    pages.paragraph("Copies of an instance are one pair. Median ratios are those of now over before on the "
                    "instances that both "
                    "solved; p-values (McNemar's exact test of what was solved or proved, Wilcoxon's "
                    "signed-rank test of costs) "
                    "carry Holm's correction over all of them. A dash: too few pairs differ to test. All "
                    "problems together stand "
                    "only where that is another test than those of single problems.");
    std::vector<std::vector<PdfTableCell>> rows;
    for (const ComparedMeasure &measure : comparison.measures)
    {
        const bool isCost = measure.isCost();
        rows.push_back({{withRule(measure.planner, measure.rule)},
                        {measure.problem.empty() ? "all" : measure.problem},
                        {spaced(measure.column)},
                        {isCost ? std::to_string(measure.costs.pairs) : ""},
                        {std::to_string(isCost ? measure.costs.secondLess : measure.onlyFirst)},
                        {std::to_string(isCost ? measure.costs.firstLess : measure.onlySecond)},
                        {isCost && measure.costs.pairs > 0 ? ratioText(measure.costs.medianRatio) : "–"},
                        {measure.p ? fmt::format("{:.3f}", *measure.p) : "–"},
                        {verdictName(measure.verdict), emphasisOf(measure.verdict)}});
    }
    pages.table({{"Planner"},
                 {"Problem"},
                 {"Measure"},
                 {"Pairs", true},
                 {"Worse", true},
                 {"Better", true},
                 {"Median ratio", true},
                 {"p", true},
                 {"Verdict"}},
                rows);
    if (!comparison.changedEnds.empty())
    {
        pages.chapter("Runs that ended otherwise");
        rows.clear();
        for (const ComparedRun &run : comparison.changedEnds)
            if (rows.size() < kRunsShown)
                rows.push_back({{run.first->planner},
                                {run.first->caseId},
                                {spaced(toString(run.first->status))},
                                {spaced(toString(run.second->status))},
                                {run.flaps ? "near the time limit" : run.second->reason},
                                {run.second->runKey}});
        pages.table({{"Planner"}, {"Case"}, {"Before"}, {"Now"}, {"Reason"}, {"Key now"}}, rows);
        if (comparison.changedEnds.size() > kRunsShown)
            pages.paragraph(fmt::format("… and {} more.", comparison.changedEnds.size() - kRunsShown));
    }
    return pages.finish(second.finished);
}

} // namespace mrpp
