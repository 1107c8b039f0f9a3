#include "reports/CampaignComparison.h"

#include "framework/support/Config.h"
#include "framework/support/Proportion.h"
#include "reports/CaseTable.h"
#include "reports/Findings.h"
#include "reports/drawing/Csv.h"
#include "reports/drawing/PdfPages.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
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

/// Whether this pair may have ended otherwise by the machine's mood alone.
bool isFlapping(const RunRecord &a, const RunRecord &b, double limit, double from)
{
    const auto nearly = [&](const RunRecord &run)
    { return run.solved() && run.time.value_or(0) >= from * limit; };
    return (a.status == PlannerStatus::timeout && nearly(b)) ||
           (b.status == PlannerStatus::timeout && nearly(a));
}

void addMeasures(CampaignComparison &comparison, const std::string &planner, const std::string &problem,
                 const std::vector<ComparedRun> &runs, const std::vector<bool> &flaps)
{
    ComparedMeasure solved;
    solved.planner = planner;
    solved.problem = problem;
    solved.column = "solved";
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        if (flaps[i])
            continue;
        solved.onlyFirst += runs[i].first->solved() && !runs[i].second->solved() ? 1 : 0;
        solved.onlySecond += runs[i].second->solved() && !runs[i].first->solved() ? 1 : 0;
    }
    solved.p = signTest(solved.onlyFirst, solved.onlySecond);
    comparison.measures.push_back(std::move(solved));
    for (const char *column : kColumns)
    {
        std::vector<double> first;
        std::vector<double> second;
        for (const ComparedRun &run : runs)
        {
            const auto a = costOf(run.first, column);
            const auto b = costOf(run.second, column);
            if (!a || !b)
                continue;
            first.push_back(*a);
            second.push_back(*b);
        }
        ComparedMeasure measure;
        measure.planner = planner;
        measure.problem = problem;
        measure.column = column;
        measure.costs = comparePairs(second, first); // ratios above 1: became worse
        measure.p = measure.costs.test.p;
        measure.refusal = measure.costs.test.refusal;
        comparison.measures.push_back(std::move(measure));
    }
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
        if (*measure.p >= kLevel)
            continue;
        if (measure.column == "solved")
        {
            measure.verdict = measure.onlyFirst > measure.onlySecond ? Verdict::worse : Verdict::better;
            continue;
        }
        const double tolerance = measure.column == "time" ? 1 + options.timeTolerance : 1;
        const double ratio = measure.costs.medianRatio;
        if (ratio > tolerance || (ratio == 1 && measure.costs.secondLess > measure.costs.firstLess))
            measure.verdict = Verdict::worse;
        else if (ratio < 1 / tolerance || (ratio == 1 && measure.costs.firstLess > measure.costs.secondLess))
            measure.verdict = Verdict::better;
    }
}

std::string place(const ComparedMeasure &measure)
{
    return oneLine(measure.planner) +
           (measure.problem.empty() ? " on everything" : " on " + oneLine(measure.problem));
}

std::string verdictName(Verdict verdict)
{
    return verdict == Verdict::worse ? "worse" : verdict == Verdict::better ? "better" : "";
}

PdfTableCell::Emphasis emphasisOf(Verdict verdict)
{
    return verdict == Verdict::worse    ? PdfTableCell::Emphasis::warning
           : verdict == Verdict::better ? PdfTableCell::Emphasis::best
                                        : PdfTableCell::Emphasis::none;
}

} // namespace

std::string ComparedMeasure::sentence() const
{
    if (column == "solved")
        return fmt::format("{}: {} solved before alone, {} now alone ({})", place(*this),
                           counted(onlyFirst, "run"), onlySecond, pText(p.value_or(1)));
    const std::string interval =
        costs.ratioInterval
            ? fmt::format(", 95 % CI {:.3f}–{:.3f}", costs.ratioInterval->low, costs.ratioInterval->high)
            : std::string();
    return fmt::format("{}: {} {:.3f} times as large{} ({}: {} more, {} less; {})", place(*this),
                       spaced(column), costs.medianRatio, interval, counted(costs.pairs, "pair"),
                       costs.secondLess, costs.firstLess, pText(p.value_or(1)));
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
    std::map<std::string, std::size_t> order; // planners in the first plan's order
    for (const Configured &planner : first.plan().planners)
        order.emplace(planner.name, order.size());

    struct Group
    {
        std::vector<ComparedRun> runs;
        std::vector<bool> flaps;
    };
    std::map<std::pair<std::size_t, std::string>, Group> groups; // by planner, problem; "" for all
    const double limit = std::min(first.plan().limits.time, second.plan().limits.time);
    for (const RunRecord &run : first.records())
    {
        const auto partner = partners.find(keyOf(run));
        if (partner == partners.end())
        {
            ++comparison.onlyFirst;
            continue;
        }
        const ComparedRun pair{&run, partner->second};
        partners.erase(partner);
        if (!run.instanceFingerprint.empty() && !pair.second->instanceFingerprint.empty() &&
            run.instanceFingerprint != pair.second->instanceFingerprint)
        {
            ++comparison.otherInstances;
            continue;
        }
        ++comparison.pairs;
        const bool flaps = isFlapping(run, *pair.second, limit, options.flappingFrom);
        comparison.flapping += flaps ? 1 : 0;
        if (!flaps && run.solved() != pair.second->solved())
            comparison.changedEnds.push_back(pair);
        if (isDefect(*pair.second) && !isDefect(run))
            comparison.newlyInvalid.push_back(pair);
        for (const std::string &problem : {std::string(), run.model + "/" + run.problem})
        {
            Group &group = groups[{order.at(run.planner), problem}];
            group.runs.push_back(pair);
            group.flaps.push_back(flaps);
        }
    }
    comparison.onlySecond = partners.size();
    for (const auto &[key, group] : groups)
        addMeasures(comparison, group.runs.front().first->planner, key.second, group.runs, group.flaps);
    judge(comparison, options);
    return comparison;
}

std::string comparisonCsv(const CampaignComparison &comparison)
{
    CsvTable table;
    for (const char *name :
         {"planner", "problem", "measure", "pairs", "more", "less", "median_ratio", "ratio_low", "ratio_high",
          "a12", "only_before", "only_now", "p_holm", "verdict", "not_tested"})
        table.cell(name);
    table.endRow();
    for (const ComparedMeasure &measure : comparison.measures)
    {
        const bool isCost = measure.column != "solved";
        const PairedComparison &costs = measure.costs;
        const auto number = [&](bool has, double value)
        { table.cell(has ? formatNumber(value) : std::string()); };
        table.cell(measure.planner);
        table.cell(measure.problem);
        table.cell(measure.column);
        number(isCost, static_cast<double>(costs.pairs));
        number(isCost, static_cast<double>(costs.secondLess));
        number(isCost, static_cast<double>(costs.firstLess));
        number(isCost && costs.pairs > 0, costs.medianRatio);
        number(costs.ratioInterval.has_value(), costs.ratioInterval.value_or(Interval()).low);
        number(costs.ratioInterval.has_value(), costs.ratioInterval.value_or(Interval()).high);
        number(isCost && costs.pairs > 0, costs.a12);
        number(!isCost, static_cast<double>(measure.onlyFirst));
        number(!isCost, static_cast<double>(measure.onlySecond));
        number(measure.p.has_value(), measure.p.value_or(1));
        table.cell(verdictName(measure.verdict));
        table.cell(measure.refusal);
        table.endRow();
    }
    return table.text();
}

std::string comparisonPdf(const CampaignComparison &comparison, const Provenance &first,
                          const Provenance &second)
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
         {"Pairs", fmt::format("{} runs of the same planner on the same instance", comparison.pairs)},
         {"Without a partner", fmt::format("{} before, {} now", comparison.onlyFirst, comparison.onlySecond)},
         {"Other instances", std::to_string(comparison.otherInstances) + " pairs left out"},
         {"Flapping timeouts", std::to_string(comparison.flapping) + " pairs, not counted as changes"}});
    for (const Verdict verdict : {Verdict::worse, Verdict::better})
    {
        pages.section(verdict == Verdict::worse ? "Regressions" : "Improvements");
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
    pages.paragraph(
        "Median ratios are those of now over before on the runs that both solved; p-values carry Holm's "
        "correction over all of them. A dash: too few pairs differ to test.");
    std::vector<std::vector<PdfTableCell>> rows;
    for (const ComparedMeasure &measure : comparison.measures)
    {
        const bool isCost = measure.column != "solved";
        rows.push_back(
            {{measure.planner},
             {measure.problem.empty() ? "all" : measure.problem},
             {spaced(measure.column)},
             {isCost ? std::to_string(measure.costs.pairs) : ""},
             {std::to_string(isCost ? measure.costs.secondLess : measure.onlyFirst)},
             {std::to_string(isCost ? measure.costs.firstLess : measure.onlySecond)},
             {isCost && measure.costs.pairs > 0 ? fmt::format("{:.3f}", measure.costs.medianRatio) : "–"},
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
                                {run.second->reason},
                                {run.second->runKey}});
        pages.table({{"Planner"}, {"Case"}, {"Before"}, {"Now"}, {"Reason"}, {"Key now"}}, rows);
        if (comparison.changedEnds.size() > kRunsShown)
            pages.paragraph(fmt::format("… and {} more.", comparison.changedEnds.size() - kRunsShown));
    }
    return pages.finish(second.finished);
}

} // namespace mrpp
