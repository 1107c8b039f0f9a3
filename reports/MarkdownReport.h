#pragma once
/// \file
/// `markdown`: report.md with findings, tables and figures, for pages that show Markdown. Draws the figures
/// that `charts` has not.

#include "framework/Report.h"

namespace mrpp
{

class MarkdownReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
