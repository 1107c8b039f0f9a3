#pragma once
/// \file
/// What planners say of themselves while they work (Planner::addProgressProperty) over time.

#include "framework/store/ResultTable.h"
#include "reports/figures/FigureList.h"

namespace mrpp
{

/// A figure for each problem (of a sweep its last point) and property, where runs lasted long enough to be
/// watched.
void addAnytimeFigures(FigureList &figures, const ResultTable &results,
                       const std::vector<ProblemSummary> &problems);

} // namespace mrpp
