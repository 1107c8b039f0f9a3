#pragma once
/// \file
/// `charts`: the campaign's figures by gnuplot, as figures/NAME.{png,pdf,svg}, each with its script (.gp) and
/// its numbers (.csv). Where gnuplot is missing scripts and numbers are written all the same, and
/// figures/NOT_DRAWN.txt says why there are no pictures.

#include "framework/Report.h"

namespace mrpp
{

class ChartsReport : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
