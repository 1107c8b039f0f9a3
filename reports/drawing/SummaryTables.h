#pragma once
/// \file
/// The tables of the PDF report.

#include "reports/Aggregate.h"
#include "reports/drawing/PdfPages.h"

#include <span>
#include <string>
#include <vector>

namespace mrpp
{

struct SummaryTable
{
    std::string title;
    std::vector<PdfTableColumn> columns;
    std::vector<std::vector<PdfTableCell>> rows;
};

/// A table for each sweep, and one for each family's other problems: solved runs and medians of every planner
/// at every point. Bold is the best median among those planners that solved the most runs at that point.
[[nodiscard]] std::vector<SummaryTable> summaryTables(std::span<const RunRecord> records);

/// A row a planner: how its runs ended, its success rate with Wilson's interval, and its penalized average
/// times, where a failed run counts 2 or 10 times the limit. \param timeLimit seconds
[[nodiscard]] SummaryTable plannerTable(std::span<const RunRecord> records, double timeLimit);

/// A row for each planner, status and kind of reason (numbers aside): how many runs ended so, the first of
/// their cases and the key by which `mrppsim replay` runs it again. At most `limit` rows, then how many there
/// are more.
[[nodiscard]] SummaryTable failureTable(std::span<const RunRecord> records, std::size_t limit);

} // namespace mrpp
