#pragma once
/// \file
/// The figures that a plan asks for: `- chart: {x: occupancy, y: path_length, per: robots, log: [y]}`.

#include "framework/store/ResultTable.h"
#include "reports/figures/FigureList.h"

namespace mrpp
{

/// One figure a request; what cannot be drawn becomes a complaint.
void addAskedFigures(FigureList &figures, const ResultTable &results);

} // namespace mrpp
