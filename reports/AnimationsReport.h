#pragma once
/// \file
/// Animations of a campaign's solutions for GraphRec, the paper's viewer.

#include "framework/Report.h"

namespace mrpp
{

/// Writes animations/NAME.txt: the condensed solution of each planner on the first repetition of each problem
/// point, where the store kept it. Stands here and not among the other reports because it is a file format.
class AnimationsReport final : public Report
{
public:
    [[nodiscard]] std::vector<std::filesystem::path>
    write(const ResultTable &results, const Provenance &provenance,
          const std::filesystem::path &folder) const override;
};

} // namespace mrpp
