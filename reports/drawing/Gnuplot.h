#pragma once
/// \file
/// Draws figures with gnuplot.

#include "reports/drawing/Figure.h"
#include "reports/drawing/Picture.h"

namespace mrpp
{

/// Runs gnuplotScript(figure) in a temporary folder, without a shell, under a wall limit. The same figure
/// gives the same bytes. Throws DrawingError where gnuplot is missing, fails, or writes something else.
[[nodiscard]] Picture drawFigure(const Figure &figure);

} // namespace mrpp
