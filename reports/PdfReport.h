#pragma once
/// \file
/// `pdf`: report.pdf, a document that stands alone: where the results come from, the plan, tables, failures
/// and every figure and layout with a caption.
///
/// Needs no other report: it takes figures that `charts` has drawn for the same results, and draws what is
/// missing itself.

#include "framework/Report.h"

namespace mrpp
{

class PdfReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
