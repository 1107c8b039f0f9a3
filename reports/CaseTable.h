#pragma once
/// \file
/// Results as pairs: the runs of all planners on the same instances side by side.

#include "framework/campaign/ResultTable.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

/// One instance.
struct Case
{
    std::vector<const RunRecord *> runs; ///< one a planner; null where it has not run yet

    /// Any of its runs: they share problem, sweep point and instance.
    [[nodiscard]] const RunRecord &any() const;
    [[nodiscard]] bool isFinished() const; ///< by every planner
};

struct CaseTable
{
    std::vector<std::string> planners; ///< in the plan's order
    std::vector<Case> cases;           ///< in the records' order

    /// The cases of one sweep point or problem, in order.
    [[nodiscard]] std::vector<CaseTable> byPoint() const;
    /// Those that every planner has finished.
    [[nodiscard]] CaseTable finished() const;
};

/// \pre the results outlive the table. O(runs log runs).
[[nodiscard]] CaseTable caseTable(const ResultTable &results);

/// What a solved run cost; nothing of null, of a failed run, and where the column is empty.
[[nodiscard]] std::optional<double> costOf(const RunRecord *run, std::string_view column);

} // namespace mrpp
