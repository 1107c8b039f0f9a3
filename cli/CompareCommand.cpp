#include "cli/Commands.h"
#include "cli/OneLine.h"
#include "cli/Reporting.h"
#include "framework/campaign/ResultStore.h"
#include "framework/support/File.h"
#include "reports/CampaignComparison.h"

#include <iostream>

namespace mrpp
{

namespace
{

ResultTable tableOf(const std::filesystem::path &folder, Catalog &catalog)
{
    return {campaignPlan(folder, catalog), ResultStore(folder, ResultStore::Access::read).records(), {}};
}

Provenance provenanceOf(const std::filesystem::path &folder)
{
    return Provenance::fromJson(readFile(folder / "provenance.json"), folder / "provenance.json");
}

void say(const CampaignComparison &comparison, ComparedMeasure::Verdict verdict, const char *title)
{
    for (const ComparedMeasure &measure : comparison.measures)
        if (measure.verdict == verdict)
            std::cout << title << ": " << oneLine(measure.sentence()) << '\n';
}

} // namespace

ExitCode compare(const CompareArguments &arguments, Catalog &catalog)
{
    const ResultTable first = tableOf(arguments.first, catalog);
    const ResultTable second = tableOf(arguments.second, catalog);
    const CampaignComparison comparison =
        compareCampaigns(first, second, {arguments.timeTolerance, arguments.flappingFrom});
    std::cout << comparison.pairs << " pairs of runs, " << comparison.onlyFirst << " only before, "
              << comparison.onlySecond << " only now, " << comparison.otherInstances
              << " on other instances, " << comparison.flapping << " flapping timeouts\n";
    for (const ComparedRun &run : comparison.newlyInvalid)
        std::cout << "defect: "
                  << oneLine(run.second->planner + " on " + run.second->caseId + ": " + run.second->reason)
                  << '\n';
    say(comparison, ComparedMeasure::Verdict::worse, "regression");
    say(comparison, ComparedMeasure::Verdict::better, "improvement");
    if (!comparison.hasRegression())
        std::cout << "no regression beyond chance\n";
    if (arguments.out)
    {
        writeFile(*arguments.out / "comparison.csv", comparisonCsv(comparison));
        writeFile(*arguments.out / "comparison.pdf",
                  comparisonPdf(comparison, provenanceOf(arguments.first), provenanceOf(arguments.second)));
        std::cout << "report: " << (*arguments.out / "comparison.pdf").string() << '\n';
    }
    if (comparison.pairs == 0)
        throw InputError(
            "the two campaigns have no run in common: compare campaigns of the same plan and seed");
    return comparison.hasRegression() ? ExitCode::no : ExitCode::done;
}

} // namespace mrpp
