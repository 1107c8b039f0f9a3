#include "cli/Commands.h"
#include "cli/Reporting.h"
#include "framework/store/ResultStore.h"
#include "framework/support/ReadableText.h"
#include "framework/system/File.h"
#include "reports/Answer.h"
#include "reports/summary/CampaignComparison.h"
#include "reports/summary/CampaignDifferences.h"

#include <algorithm>
#include <iostream>

namespace mrpp
{

namespace
{

/// One of the two campaigns.
struct Side
{
    ResultTable table;
    Provenance provenance;
    AskedParts asked;

    Side(const std::filesystem::path &folder, Catalog &catalog)
        : Side(folder, catalog, {folder, ResultStore::Access::read})
    {}

    [[nodiscard]] ComparedCampaign compared() const { return {table.plan(), provenance, asked}; }

private:
    Side(const std::filesystem::path &folder, Catalog &catalog, const ResultStore &store)
        : table(campaignPlan(folder, catalog), store.records(), {}),
          provenance(Provenance::fromJson(readFile(folder / "provenance.json"), folder / "provenance.json")),
          asked(store.askedParts())
    {}
};

void say(const CampaignComparison &comparison, ComparedMeasure::Verdict verdict, const char *title)
{
    for (const ComparedMeasure &measure : comparison.measures)
        if (measure.verdict == verdict)
            std::cout << title << ": " << oneLine(measure.sentence()) << '\n';
}

} // namespace

ExitCode compare(const CompareArguments &arguments, Catalog &catalog)
{
    const Side first(arguments.first, catalog);
    const Side second(arguments.second, catalog);
    const std::vector<std::string> differences = campaignDifferences(first.compared(), second.compared());
    for (const std::string &difference : differences)
        std::cout << "differs: " << oneLine(difference) << '\n';
    const CampaignComparison comparison =
        compareCampaigns(first.table, second.table, {arguments.timeTolerance, arguments.flappingFrom});
    std::cout << comparison.pairs << " pairs of runs, " << comparison.onlyFirst << " only before, "
              << comparison.onlySecond << " only now, " << comparison.otherInstances
              << " on other instances, " << comparison.flapping << " flapping timeouts\n";
    if (comparison.pairs == 0)
        throw InputError(
            "the two campaigns have no run in common: compare campaigns of the same plan and seed");
    if (comparison.instances < comparison.pairs)
        std::cout << comparison.instances
                  << " pairs are tested: repetitions that are copies of one instance count once\n";
    if (!comparison.changedEnds.empty())
    {
        const auto lost = std::count_if(comparison.changedEnds.begin(), comparison.changedEnds.end(),
                                        [](const ComparedRun &run)
                                        {
                                            return outcomeOf(run.second->status) == Outcome::failed ||
                                                   outcomeOf(run.second->status) == Outcome::doesNotApply;
                                        });
        std::cout << lost << " runs were solved or proved before alone, "
                  << static_cast<std::ptrdiff_t>(comparison.changedEnds.size()) - lost << " now alone\n";
    }
    for (const ComparedRun &run : comparison.newlyInvalid)
        std::cout << "defect: "
                  << oneLine(run.second->planner + " on " + run.second->caseId + ": " + run.second->reason)
                  << '\n';
    say(comparison, ComparedMeasure::Verdict::worse, "regression");
    say(comparison, ComparedMeasure::Verdict::better, "improvement");
    say(comparison, ComparedMeasure::Verdict::unclear, "no clear direction");
    if (!comparison.hasRegression())
        std::cout << "no regression beyond chance\n";
    if (arguments.out)
    {
        writeFile(*arguments.out / "comparison.csv", comparisonCsv(comparison));
        writeFile(*arguments.out / "comparison.pdf",
                  comparisonPdf(comparison, differences, first.provenance, second.provenance));
        std::cout << "report: " << (*arguments.out / "comparison.pdf").string() << '\n';
    }
    return comparison.hasRegression() ? ExitCode::no : ExitCode::done;
}

} // namespace mrpp
