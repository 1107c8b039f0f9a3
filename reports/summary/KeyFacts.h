#pragma once
/// \file
/// What a campaign found, in sentences that its title page can carry.

#include "framework/store/ResultTable.h"

#include <string>
#include <vector>

namespace mrpp
{

/// How the runs ended, what each planner solved and proved, and the path lengths. Planners are compared only
/// on instances that all of them have finished, path lengths only on commonCases(); where there are too few,
/// the sentence says so. Empty without runs.
[[nodiscard]] std::vector<std::string> keyFacts(const ResultTable &results);

} // namespace mrpp
