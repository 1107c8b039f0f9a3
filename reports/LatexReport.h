#pragma once
/// \file
/// `latex`: latex/ with booktabs tables, numbers as commands, and figures, each ready to be put into a paper,
/// and report.tex, which shows them all. Draws the figures that `charts` has not.

#include "framework/Report.h"

namespace mrpp
{

class LatexReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
