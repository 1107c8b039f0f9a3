#pragma once
/// \file
/// What a campaign found, in sentences that its title page can carry.

#include "framework/campaign/ResultTable.h"

#include <string>
#include <vector>

namespace mrpp
{

/// How the runs ended, which planner solved most, and the path lengths. Planners are compared only on cases
/// that all of them have finished or solved; where there are none, the sentence says so. Empty without runs.
[[nodiscard]] std::vector<std::string> keyFacts(const ResultTable &results);

} // namespace mrpp
