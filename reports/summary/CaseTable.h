#pragma once
/// \file
/// Results as pairs: the answers of all planners to the same instances side by side.

#include "framework/store/ResultTable.h"
#include "reports/Answer.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

/// One instance. Copies of it, in whatever repetitions, sweep points and problems, are one case, at the place
/// of the first.
struct Case
{
    std::vector<Answer> answers; ///< one a planner; not finished where it has not run yet

    /// The first run of any of the planners.
    [[nodiscard]] const RunRecord &any() const;
    [[nodiscard]] bool isFinished() const; ///< by every planner
    /// Whether every planner that has finished it knows that there is no solution under its rule.
    [[nodiscard]] bool isHopeless() const;
};

struct CaseTable
{
    std::vector<std::string> planners; ///< in the plan's order
    std::vector<std::string> rules;    ///< of each planner
    std::vector<Case> cases;           ///< in the records' order

    /// The cases of one sweep point or problem, in order.
    [[nodiscard]] std::vector<CaseTable> byPoint() const;
    /// Those that every planner has finished.
    [[nodiscard]] CaseTable finished() const;
    /// Those that are not hopeless.
    [[nodiscard]] CaseTable solvable() const;
    /// "push_and_swap (pebble)".
    [[nodiscard]] std::string name(std::size_t planner) const;
};

/// \pre the results outlive the table. O(runs log runs).
[[nodiscard]] CaseTable caseTable(const ResultTable &results);

/// Planners that are compared all at once, and the cases that all of them solved.
struct CommonCases
{
    std::vector<std::size_t> planners; ///< in the table's order
    std::vector<std::size_t> leftOut;  ///< who solved too few of what the others did
    std::vector<const Case *> cases;
};

/// With fewer cases in common, planners are compared pair by pair only.
inline constexpr std::size_t kLeastInCommon = 8;

/// Cases with a value of the column (and a positive one of `bound`, unless that is empty) for each planner.
/// Planners that solved less than half of what the best one did are left out, then, as long as fewer than
/// kLeastInCommon are left, whoever costs most of them: a weak planner does not empty the comparison of the
/// others. No planner where no two have so many in common; one planner alone is compared with nobody and
/// keeps all its cases. \pre the table outlives them. O(planners² · cases).
[[nodiscard]] CommonCases commonCases(const CaseTable &table, std::string_view column,
                                      std::string_view bound = {});

} // namespace mrpp
