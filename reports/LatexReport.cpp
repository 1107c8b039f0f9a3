#include "reports/LatexReport.h"

#include "framework/system/File.h"
#include "reports/document/Markup.h"
#include "reports/figures/CampaignFigures.h"
#include "reports/gnuplot/Gnuplot.h"
#include "reports/picture/Text.h"
#include "reports/summary/Findings.h"
#include "reports/summary/SummaryTables.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace mrpp
{

namespace
{

/// A booktabs table; longtable, since sweeps are longer than pages.
std::string tableText(const SummaryTable &table)
{
    std::string columns;
    std::string heading;
    for (const PdfTableColumn &column : table.columns)
    {
        columns += column.isRight ? 'r' : 'l';
        heading += (heading.empty() ? "" : " & ") + latexText(column.title);
    }
    std::string text =
        fmt::format("\\begin{{longtable}}{{{}}}\n\\caption{{{}}}\\\\\n\\toprule\n{} \\\\\n\\midrule\n"
                    "\\endfirsthead\n\\toprule\n{} \\\\\n\\midrule\n\\endhead\n",
                    columns, latexText(table.title), heading, heading);
    const std::string *group = nullptr;
    for (const std::vector<PdfTableCell> &row : table.rows)
    {
        const bool continues = columns.size() > 2 && group != nullptr && *group == row.front().text;
        if (group != nullptr && !continues && columns.size() > 2)
            text += "\\addlinespace\n";
        group = &row.front().text;
        for (std::size_t c = 0; c < row.size(); ++c)
        {
            const std::string cell = c == 0 && continues ? "" : latexText(row[c].text);
            text += c == 0 ? "" : " & ";
            text += row[c].emphasis == PdfTableCell::Emphasis::best ? "\\textbf{" + cell + "}" : cell;
        }
        text += " \\\\\n";
    }
    return text + "\\bottomrule\n\\end{longtable}\n\n";
}

std::string latexRatio(double ratio)
{
    return std::isinf(ratio) ? "\\ensuremath{\\infty}" : ratioText(ratio);
}

/// \newcommand{\solvedPushAndSwap}{138} and its like; of two planners with one name in letters the second
/// gets "B".
std::string numbersText(const ResultTable &results, const CaseTable &cases, const Findings &findings)
{
    std::set<std::string> taken;
    std::string text = "% Numbers for the text: \\input{numbers} in the preamble.\n";
    const auto define = [&](std::string name, const std::string &value)
    {
        while (!taken.insert(name).second)
            name += 'B';
        text += fmt::format("\\newcommand{{\\{}}}{{{}}}\n", name, value);
    };
    define("mrppRuns", std::to_string(results.records().size()));
    define("mrppPlannedRuns", std::to_string(results.plannedRuns()));
    define("mrppCases", std::to_string(cases.cases.size()));
    for (std::size_t p = 0; p < cases.planners.size(); ++p)
    {
        std::size_t runs = 0;
        std::size_t counted = 0; // for success
        std::map<Outcome, std::size_t> outcomes;
        for (const Case &one : cases.cases)
        {
            const Answer &answer = one.answers[p];
            if (!answer.isFinished())
                continue;
            runs += answer.runs();
            counted += answer.counts() ? 1 : 0;
            ++outcomes[answer.outcome()];
        }
        const std::string name = latexName(cases.planners[p]);
        const std::size_t solved = outcomes[Outcome::solved];
        define("mrppRunsOf" + name, std::to_string(runs));
        define("mrppRuleOf" + name, cases.rules[p]);
        define("mrppSolvedBy" + name, std::to_string(solved));
        define("mrppProvedBy" + name, std::to_string(outcomes[Outcome::proved]));
        define("mrppNotApplicableTo" + name, std::to_string(outcomes[Outcome::doesNotApply]));
        define("mrppFailedBy" + name, std::to_string(outcomes[Outcome::failed]));
        if (counted > 0)
            define("mrppSuccessOf" + name,
                   fmt::format("{:.1f}", 100 * static_cast<double>(solved) / static_cast<double>(counted)));
    }
    for (const CostFinding &finding : findings.costs)
    {
        const std::string name = latexName(finding.column + " " + finding.first + " over " + finding.second);
        if (finding.comparison.pairs == 0)
            continue;
        define("mrppRatio" + name, latexRatio(finding.comparison.medianRatio));
        if (finding.comparison.ratioInterval)
            define("mrppInterval" + name, latexRatio(finding.comparison.ratioInterval->low) + "--" +
                                              latexRatio(finding.comparison.ratioInterval->high));
        if (finding.p)
            define("mrppP" + name, *finding.p < 0.001 ? "<0.001" : fmt::format("{:.3f}", *finding.p));
    }
    return text;
}

} // namespace

std::vector<std::filesystem::path> LatexReport::write(const ResultTable &results,
                                                      const Provenance &provenance,
                                                      const std::filesystem::path &folder) const
{
    constexpr std::size_t kFailureRows = 80;
    const std::filesystem::path latex = folder / "latex";
    const CaseTable cases = caseTable(results);
    const Findings findings = findingsOf(cases);
    std::vector<std::filesystem::path> files;
    const auto add = [&](const char *name, const std::string &text)
    {
        files.push_back(latex / name);
        writeFile(files.back(), text);
    };

    std::string tables;
    if (!results.records().empty())
    {
        tables += tableText(plannerTable(results.records(), results.plan().limits.time));
        for (const SummaryTable &table : summaryTables(results.records()))
            tables += tableText(table);
        if (const SummaryTable failures = failureTable(results.records(), kFailureRows);
            !failures.rows.empty())
            tables += tableText(failures);
    }
    add("tables.tex", tables);
    add("numbers.tex", numbersText(results, cases, findings));

    const auto [drawn, complaints] = campaignFigures(results);
    const std::vector<DrawnFigure> pictures = drawFigures(drawn, folder / "figures");
    std::string figures;
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        const auto own = writeFigure(drawn[i], pictures[i], folder / "figures");
        files.insert(files.end(), own.begin(), own.end());
        figures += fmt::format(
            "\\begin{{figure}}\n\\centering\n{}\n\\caption{{{}}}\n\\label{{fig:{}}}\n\\end{{figure}}\n\n",
            pictures[i].missing.empty()
                ? fmt::format("\\includegraphics[width=\\linewidth]{{../figures/{}.pdf}}", drawn[i].name)
                : "[" + latexText(pictures[i].missing) + "]",
            latexText(drawn[i].caption), drawn[i].name);
    }
    add("figures.tex", figures);

    std::string report =
        "% xelatex report.tex, or lualatex: names may hold any character.\n"
        "\\documentclass[a4paper]{article}\n\\usepackage{fontspec}\n\\setmainfont{DejaVu Sans}\n"
        "\\usepackage{textcomp}\n\\usepackage{booktabs,longtable,graphicx}\n"
        "\\usepackage[margin=2cm]{geometry}\n\\usepackage{placeins}\n\\input{numbers}\n\\begin{document}\n";
    report += fmt::format(
        "\\section*{{{}}}\nmrppsim {}, revision {}, {}.\n\n\\section*{{Findings}}\n\\begin{{itemize}}\n"
        "\\item \\mrppRuns{{}} of \\mrppPlannedRuns{{}} runs have finished.\n",
        latexText(results.plan().campaign), latexText(provenance.version), latexText(provenance.revision),
        latexText(provenance.finished));
    for (const std::string &sentence : findings.sentences())
        report += "\\item " + latexText(sentence) + "\n";
    report +=
        "\\end{itemize}\n\\section*{Tables}\n{\\footnotesize\\setlength{\\tabcolsep}{3pt}\n\\input{tables}}\n"
        "\\section*{Figures}\n\\extrafloats{200}\n\\input{figures}\n\\end{document}\n";
    add("report.tex", report);
    return files;
}

} // namespace mrpp
