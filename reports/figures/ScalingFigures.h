#pragma once
/// \file
/// How costs grow with the graph, for sweeps that grow it: points, fitted laws with their bands, and the
/// sizes that the fits have not seen.

#include "reports/figures/FigureList.h"

#include <string_view>

namespace mrpp
{

/// Whether the sweep's points have graphs of different sizes.
[[nodiscard]] bool growsGraph(const ProblemSummary &problem);

/// The figure, or words why there is none (in `refusal`). \pre growsGraph(problem)
/// \param size the numeric column against which it grows: "vertices", or another cost
[[nodiscard]] std::optional<Figure> scalingFigure(const FigureList &figures, const ProblemSummary &problem,
                                                  std::string_view size, std::string_view column,
                                                  std::string &refusal);

/// Times and path lengths of each such sweep.
void addScalingFigures(FigureList &figures, const std::vector<ProblemSummary> &problems);

} // namespace mrpp
