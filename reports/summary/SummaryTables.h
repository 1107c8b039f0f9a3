#pragma once
/// \file
/// The tables of the PDF report.

#include "reports/document/PdfPages.h"
#include "reports/summary/Aggregate.h"

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

/// A table for each sweep, and one for each family's other problems: solved instances and medians
/// (RunGroup::cost) of every planner at every point. Bold is the best median among those planners that solved
/// the most instances there.
[[nodiscard]] std::vector<SummaryTable> summaryTables(std::span<const RunRecord> records);

/// A row a planner: its distinct instances by outcome; over those that have a solution under its rule and to
/// which it applies its success rate with Wilson's interval, and its penalized average times, where one that
/// failed counts 2 or 10 times the limit. \param timeLimit seconds
[[nodiscard]] SummaryTable plannerTable(std::span<const RunRecord> records, double timeLimit);

/// A row for each planner, status and kind of reason (numbers aside): how many runs ended so, the first of
/// their cases and the key by which `mrppsim replay` runs it again. At most `limit` rows, then how many there
/// are more.
[[nodiscard]] SummaryTable failureTable(std::span<const RunRecord> records, std::size_t limit);

} // namespace mrpp
