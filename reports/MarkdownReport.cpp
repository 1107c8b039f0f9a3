#include "reports/MarkdownReport.h"

#include "framework/system/File.h"
#include "reports/document/Markup.h"
#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/Gnuplot.h"
#include "reports/summary/Findings.h"
#include "reports/summary/KeyFacts.h"
#include "reports/summary/SummaryTables.h"

#include <fmt/format.h>

namespace mrpp
{

namespace
{

std::string tableText(const SummaryTable &table)
{
    std::string heading = "|";
    std::string rule = "|";
    for (const PdfTableColumn &column : table.columns)
    {
        heading += " " + markdownText(column.title) + " |";
        rule += column.isRight ? " ---: |" : " --- |";
    }
    std::string text = "### " + markdownText(table.title) + "\n\n" + heading + "\n" + rule + "\n";
    for (const std::vector<PdfTableCell> &row : table.rows)
    {
        text += "|";
        for (const PdfTableCell &cell : row)
        {
            const bool isMarked = cell.emphasis != PdfTableCell::Emphasis::none && !cell.text.empty();
            text += " " + (isMarked ? "**" + markdownText(cell.text) + "**" : markdownText(cell.text)) + " |";
        }
        text += "\n";
    }
    return text + "\n";
}

} // namespace

std::vector<std::filesystem::path> MarkdownReport::write(const ResultTable &results,
                                                         const Provenance &provenance,
                                                         const std::filesystem::path &folder) const
{
    constexpr std::size_t kFailureRows = 80;
    std::string text =
        fmt::format("# {}\n\nmrppsim {}, revision {}; {} of {} runs finished.\n\n",
                    markdownText(results.plan().campaign), markdownText(provenance.version),
                    markdownText(provenance.revision), results.records().size(), results.plannedRuns());
    std::vector<std::filesystem::path> files = {folder / "report.md"};
    if (!results.records().empty())
    {
        text += "## Findings\n\n";
        for (const std::string &fact : keyFacts(results))
            text += "* " + markdownText(fact) + "\n";
        for (const std::string &sentence : findingsOf(caseTable(results)).sentences())
            text += "* " + markdownText(sentence) + "\n";
        text += "\n## Tables\n\nCopies of an instance count once. Behind a planner's name: the motion rule "
                "of its "
                "solutions. Solved: of the instances that have a solution under that rule and to which the "
                "planner "
                "applies; PAR, too. Costs are medians over the same instances for all planners of a place; "
                "without an "
                "answer a planner stands above all costs, so that there is none unless it solved more than "
                "half. Bold: "
                "the best median among the planners that solved the most instances there.\n\n";
        text += tableText(plannerTable(results.records(), results.plan().limits.time));
        for (const SummaryTable &table : summaryTables(results.records()))
            text += tableText(table);
        if (const SummaryTable failures = failureTable(results.records(), kFailureRows);
            !failures.rows.empty())
            text += tableText(failures);
    }
    const auto [drawn, complaints] = campaignFigures(results);
    const std::vector<DrawnFigure> pictures = drawFigures(drawn, folder / "figures");
    if (!drawn.empty())
        text += "## Figures\n\n";
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        const auto own = writeFigure(drawn[i], pictures[i], folder / "figures");
        files.insert(files.end(), own.begin(), own.end());
        text += pictures[i].missing.empty() ? fmt::format("![](figures/{}.svg)\n\n", drawn[i].name)
                                            : "*Not drawn: " + markdownText(pictures[i].missing) + "*\n\n";
        text += markdownText(drawn[i].caption) + "\n\n";
    }
    for (const std::string &complaint : complaints)
        text += "* " + markdownText(complaint) + "\n";
    writeFile(files.front(), text);
    return files;
}

} // namespace mrpp
