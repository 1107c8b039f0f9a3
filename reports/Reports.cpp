#include "reports/Reports.h"

#include "reports/AnimationsReport.h"
#include "reports/ChartsReport.h"
#include "reports/CsvReport.h"
#include "reports/HtmlReport.h"
#include "reports/LatexReport.h"
#include "reports/LayoutsReport.h"
#include "reports/MarkdownReport.h"
#include "reports/PdfReport.h"

namespace mrpp
{

void registerReports(Catalog &catalog)
{
    catalog.reports.add<AnimationsReport>("animations", "solutions of the first repetition, for GraphRec");
    catalog.reports.add<CsvReport>(
        "csv", "results.csv with a row a run, summary.csv with a row a planner and problem");
    catalog.reports.add<ChartsReport>("charts",
                                      "figures of every sweep and comparison, with gnuplot scripts and data");
    catalog.reports.add<LayoutsReport>(
        "layouts", "pictures of the instances with starts, goals and routes, by Graphviz");
    catalog.reports.add<PdfReport>("pdf",
                                   "report.pdf: provenance, plan, tables, failures, every figure and layout");
    catalog.reports.add<HtmlReport>(
        "html", "report.html: charts, a table of all runs, and solutions that play, in one file");
    catalog.reports.add<LatexReport>(
        "latex", "latex/: booktabs tables, numbers as commands, figures ready to include");
    catalog.reports.add<MarkdownReport>("markdown", "report.md: findings, tables and figures");
}

} // namespace mrpp
