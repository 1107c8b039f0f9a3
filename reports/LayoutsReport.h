#pragma once
/// \file
/// `layouts`: pictures of the instances by Graphviz, as layouts/NAME.{png,pdf,svg}: graph, starts, goals and
/// the robots' routes. layouts/NOT_DRAWN.txt says which could not be drawn, and why.

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
