#pragma once
/// \file
/// `layouts`: pictures of the instances as layouts/NAME.{png,pdf,svg}: graph, starts, goals and the robots'
/// routes; as NAME-structure its blocks, handles and isthmuses; as NAME-steps key steps of a solution.
/// layouts/NOT_DRAWN.txt says which could not be drawn, and why.

#include "framework/Report.h"

namespace mrpp
{

class LayoutsReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
