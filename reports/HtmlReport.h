#pragma once
/// \file
/// `html`: report.html, the explorer: charts, a table of all runs, and solutions that play, in one file that
/// needs no server and no network. Which solutions it carries is the plan's choice (BenchmarkPlan::explorer).
/// Where the program was built without Node.js there is no page, and NOT_DRAWN.txt says so.

#include "framework/Report.h"

namespace mrpp
{

class HtmlReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
