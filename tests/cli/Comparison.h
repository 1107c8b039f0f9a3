#pragma once
/// \file
/// Whether two campaigns came to the same results.

#include "tests/cli/Program.h"

#include <string>
#include <vector>

namespace mrpp::test
{

/// results.csv without what may differ between two runs: times, memory, attempts.
[[nodiscard]] std::vector<std::vector<std::string>> lastingResults(const Scratch &scratch,
                                                                   const std::string &folder);

/// The kept instances and solutions are the same files.
void expectSameAnswers(const Scratch &scratch, const std::string &a, const std::string &b);

/// So are the results.
void expectSameCampaign(const Scratch &scratch, const std::string &a, const std::string &b);

} // namespace mrpp::test
