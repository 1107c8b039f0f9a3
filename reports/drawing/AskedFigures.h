#pragma once
/// \file
/// The figures that a plan asks for: `- chart: {x: occupancy, y: path_length, per: robots, log: [y]}`.

#include "framework/campaign/ResultTable.h"
#include "reports/drawing/FigureList.h"

namespace mrpp
{

/// One figure a request; what cannot be drawn becomes a complaint.
void addAskedFigures(FigureList &figures, const ResultTable &results);

} // namespace mrpp
