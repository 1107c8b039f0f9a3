#pragma once
/// \file
/// `csv`: results.csv with a row a run, and summary.csv with a row a planner and problem or sweep point.
///
/// RFC 4180 quoting, lines end with \n. Nothing stands for a number that does not exist.

#include "framework/Report.h"

#include <string>

namespace mrpp
{

class CsvReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

/// results.csv: the columns of runColumns(), then whatever columns events added, sorted by name.
[[nodiscard]] std::string resultsCsv(const std::vector<RunRecord> &records);

/// summary.csv: instances (copies count once) by outcome; success with Wilson's interval over those that have
/// a solution and to which the planner applies; for each measure RunGroup::cost() and, as NAME_n, over how
/// many instances; how many instances ended in each other way; penalized average times; and as NAME_to_best
/// the median of cost / least cost of any planner on the same instance. \param timeLimit seconds
[[nodiscard]] std::string summaryCsv(const std::vector<RunRecord> &records, double timeLimit);

} // namespace mrpp
