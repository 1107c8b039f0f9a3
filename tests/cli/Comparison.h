#pragma once
/// \file
/// A campaign for tests, and whether two came to the same results.

#include "tests/cli/Program.h"

#include <string>
#include <vector>

namespace mrpp::test
{

/// Two planners over small and random instances, everything kept; `repetitions` makes it as long as needed.
[[nodiscard]] std::string campaignPlan(int repetitions);

/// Writes that plan (plan.yaml) and its map.
void prepareCampaign(const Scratch &scratch, int repetitions);

/// results.csv without what may differ between two runs: times, memory, attempts.
[[nodiscard]] std::vector<std::vector<std::string>> lastingResults(const Scratch &scratch,
                                                                   const std::string &folder);

/// The kept instances and solutions are the same files.
void expectSameAnswers(const Scratch &scratch, const std::string &a, const std::string &b);

/// So are the results.
void expectSameCampaign(const Scratch &scratch, const std::string &a, const std::string &b);

} // namespace mrpp::test
