#include "reports/PdfReport.h"

#include "framework/system/File.h"
#include "reports/document/PdfPages.h"
#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/Gnuplot.h"
#include "reports/layouts/CampaignLayouts.h"
#include "reports/picture/PdfFile.h"
#include "reports/picture/Text.h"
#include "reports/summary/Findings.h"
#include "reports/summary/KeyFacts.h"
#include "reports/summary/SummaryTables.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kFigureHeight = 640;   // points
constexpr double kHalfPageHeight = 280; // points: two and their captions fill a page
constexpr double kHalvedAtMost = 410;   // points: higher figures would become too small
constexpr double kHalfPage = 345;       // points, of such a figure with its caption
constexpr double kPictureChapter = 420; // points, of a heading with the first picture
constexpr double kLayoutHeight = 560;   // points, of a layout that has the width for itself
constexpr double kPairWidth = 234;      // points, of each of two layouts beside each other
constexpr double kPairHeight = 300;     // points, at most
constexpr double kLeastScale = 0.54;    // of such a pair: in smaller ones numbers cannot be read

constexpr const char *kPlanFile = "plan.yaml"; // in the campaign's folder, as all of these
constexpr const char *kRunsFile = "results.csv";
constexpr const char *kFigures = "figures";
constexpr const char *kLayouts = "layouts";

/// Whether the plan asks for a report, so that its files lie beside this one.
bool wants(const ResultTable &results, std::string_view report)
{
    const auto &reports = results.plan().reports;
    return std::find(reports.begin(), reports.end(), report) != reports.end();
}

/// Where the figures and the table of a subject are.
std::string figuresOf(const std::string &subject)
{
    return "figures of " + subject;
}
std::string tableOf(const std::string &subject)
{
    return "table of " + subject;
}

void addTitlePage(PdfPages &pages, const ResultTable &results, const Provenance &provenance)
{
    const auto &records = results.records();
    const auto solved = static_cast<std::size_t>(
        std::count_if(records.begin(), records.end(), [](const RunRecord &run) { return run.solved(); }));
    std::string runs = fmt::format("{} finished of {} planned: {} solved, {} not", records.size(),
                                   results.plannedRuns(), solved, records.size() - solved);
    std::vector<std::string> rules;
    for (const Configured &planner : results.plan().planners)
        rules.push_back(withRule(oneLine(planner.name), toString(planner.motion)));
    if (records.size() < results.plannedRuns())
        runs += "; the campaign is not finished";

    pages.title(results.plan().campaign, "Multi-robot path planning on graphs: benchmark report");
    const auto orUnknown = [](const std::string &text)
    { return text.empty() ? std::string("unknown") : text; };
    pages.facts({
        {"Runs", runs, wants(results, "csv") ? kRunsFile : ""},
        {"Repetitions", std::to_string(results.plan().repetitions)},
        {"Motion rule", fmt::format("{} at most; the planners': {}", toString(results.plan().motion),
                                    fmt::join(rules, ", "))},
        {"Limits of a run",
         fmt::format("{:g} s, {:g} MB", results.plan().limits.time, results.plan().limits.memory)},
        {"Seed", std::to_string(results.plan().seed)},
        {"Plan file",
         orUnknown(provenance.planFile) +
             (provenance.planFingerprint.empty() ? "" : ", fingerprint " + provenance.planFingerprint),
         kPlanFile},
        {"Started", orUnknown(provenance.started)},
        {"Finished", provenance.finished.empty() ? "not yet" : provenance.finished},
        {"Program", fmt::format("mrppsim {}{}", provenance.version,
                                provenance.revision.empty() ? "" : ", revision " + provenance.revision)},
        {"Built with",
         fmt::format("{}, {}", orUnknown(provenance.compiler), orUnknown(provenance.buildType))},
        {"Machine",
         fmt::format("{}: {}, {}, {:.1f} GB", orUnknown(provenance.host), orUnknown(provenance.cpu),
                     counted(static_cast<std::size_t>(std::max<std::int64_t>(provenance.cores, 0)), "core"),
                     provenance.memory / 1000)},
        {"System", orUnknown(provenance.system)},
        {"Libraries", fmt::format("{}", fmt::join(provenance.libraries, ", "))},
    });
    if (records.empty())
    {
        pages.paragraph("No run has finished yet.");
        return;
    }
    pages.section("In short");
    for (const std::string &fact : keyFacts(results))
        pages.paragraph(fact);
    const SummaryTable planners = plannerTable(records, results.plan().limits.time);
    pages.section(planners.title);
    pages.table(planners.columns, planners.rows);
    pages.paragraph(
        "Copies of an instance count once. Behind a planner's name: the motion rule of its solutions. Solved "
        "(%), its interval (Wilson) and PAR are over the instances that have a solution under that rule and "
        "to which the planner applies; PAR-2 and PAR-10 are mean times where one that failed counts 2 or 10 "
        "times the limit.");
    pages.section("Contents");
    pages.contents();
}

void addFindings(PdfPages &pages, const ResultTable &results)
{
    const std::vector<std::string> sentences = findingsOf(caseTable(results)).sentences();
    if (sentences.empty())
        return;
    pages.chapter("Findings");
    pages.paragraph("Planners are compared pair by pair on the same instances, of which copies count once: "
                    "costs on those that both "
                    "solved, by Wilcoxon's signed-rank test of the logarithms of their ratios, which also "
                    "says who needs less, "
                    "with the median ratio and its interval between order statistics; what they solve on "
                    "those that have a "
                    "solution under both motion rules and to which both apply, by McNemar's exact test. All "
                    "p-values carry Holm's "
                    "correction. The rank-biserial correlation is the first planner's share of the rank sum "
                    "minus the second's: 1 "
                    "where it always needs less, 0 where they are alike. Instances of one sweep share their "
                    "graph, so small "
                    "p-values overstate how much was learned.");
    for (const std::string &sentence : sentences)
        pages.paragraph("• " + sentence);
}

void addTables(PdfPages &pages, const ResultTable &results)
{
    constexpr std::size_t kFailureRows = 80;
    if (results.records().empty())
        return;
    pages.chapter("Results");
    pages.paragraph("Solved: of how many distinct instances that have a solution under the planner's motion "
                    "rule and to which it "
                    "applies. Every cost is the median over the same instances for all planners of a row's "
                    "place: those that all "
                    "have finished, unless they have no solution; without an answer a planner stands above "
                    "all costs, and where it "
                    "solved no more than half there is no median (a dash). Bold: the best median among the "
                    "planners that solved "
                    "the most instances there, times that differ by less than a tenth or 0.1 ms being alike. "
                    "Quartiles are in "
                    "summary.csv, single runs in results.csv.");
    for (const SummaryTable &table : summaryTables(results.records()))
    {
        pages.section(table.title, tableOf(table.title));
        pages.reference("figures", figuresOf(table.title));
        pages.table(table.columns, table.rows);
    }
    const SummaryTable failures = failureTable(results.records(), kFailureRows);
    pages.chapter("Runs without a solution");
    if (failures.rows.empty())
        pages.paragraph("Every run ended with a valid solution.");
    else
    {
        pages.paragraph("Failures, proofs that there is no solution (infeasible), and instances to which a "
                        "planner does not apply "
                        "(unsupported), grouped by planner, end and message. To see one again, run `mrppsim "
                        "replay . KEY` in this "
                        "report's folder, with the key in its row.");
        pages.table(failures.columns, failures.rows);
    }
}

void addFigures(PdfPages &pages, const ResultTable &results, const std::filesystem::path &figures)
{
    const auto [drawn, complaints] = campaignFigures(results);
    if (drawn.empty() && complaints.empty())
        return;
    pages.chapter("Figures", kPictureChapter);
    for (const std::string &complaint : complaints)
        pages.paragraph(complaint + ".");
    const std::vector<DrawnFigure> pictures = drawFigures(drawn, figures);
    std::string subject;
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        if (!drawn[i].subject.empty() && drawn[i].subject != subject)
            pages.reference("table of " + drawn[i].subject, tableOf(drawn[i].subject), kHalfPage);
        subject = drawn[i].subject;
        PdfDrawing drawing{pictures[i].picture.pdf, pictures[i].missing, drawn[i].caption,
                           wants(results, "charts") ? fmt::format("{}/{}.csv", kFigures, drawn[i].name) : "",
                           subject.empty() ? "" : figuresOf(subject)};
        const bool isLow = drawing.missing.empty() && pageSize(drawing.pdf).second <= kHalvedAtMost;
        pages.drawings({std::move(drawing)}, 1, isLow ? kHalfPageHeight : kFigureHeight);
    }
}

bool fitsBeside(const std::string &pdf)
{
    const auto [width, height] = pageSize(pdf);
    return kLeastScale * width <= kPairWidth && kLeastScale * height <= kPairHeight;
}

void addLayouts(PdfPages &pages, const ResultTable &results, const std::filesystem::path &layouts)
{
    const std::vector<LayoutPlan> plans = plannedLayouts(results);
    if (plans.empty())
        return;
    pages.chapter("Instances", kPictureChapter);
    pages.paragraph(
        "Every problem's first instance, of a sweep the smallest and the largest point. Routes are those of "
        "the "
        "first solution that was kept. The structure of a graph is its isthmuses (edges on no cycle) and its "
        "blocks, each a first cycle to which handles are added one after another. Key steps are the start, "
        "the "
        "end, and of each part of the schedule between them the moment at which most robots are at their "
        "goals.");
    std::vector<PdfDrawing> pair;
    const auto flush = [&]
    {
        if (!pair.empty())
            pages.drawings(pair, 2, kPairHeight);
        pair.clear();
    };
    for (const LayoutPlan &plan : plans)
    {
        for (Layout &layout : drawLayouts(results, plan, layouts))
        {
            PdfDrawing drawing{
                std::move(layout.picture.pdf), layout.missing, layout.caption,
                wants(results, "layouts") ? fmt::format("{}/{}.svg", kLayouts, layout.name) : "", ""};
            if (drawing.missing.empty() && !fitsBeside(drawing.pdf))
            {
                flush();
                pages.drawings({drawing}, 1, kLayoutHeight);
                continue;
            }
            pair.push_back(std::move(drawing));
            if (pair.size() == 2)
                flush();
        }
        flush();
    }
}

} // namespace

std::vector<std::filesystem::path> PdfReport::write(const ResultTable &results, const Provenance &provenance,
                                                    const std::filesystem::path &folder) const
{
    const std::filesystem::path file = folder / "report.pdf";
    PdfPages pages(results.plan().campaign,
                   fmt::format("{} · mrppsim {}", results.plan().campaign, provenance.version));
    addTitlePage(pages, results, provenance);
    addFindings(pages, results);
    addTables(pages, results);
    addFigures(pages, results, folder / kFigures);
    addLayouts(pages, results, folder / kLayouts);
    pages.chapter("Plan");
    pages.verbatim(results.plan().text);
    writeFile(file, pages.finish(provenance.finished));
    return {file};
}

} // namespace mrpp
