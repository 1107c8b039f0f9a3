#pragma once
/// \file
/// A figure as a gnuplot script that stands alone: data within, run by `gnuplot NAME.gp` in its own folder it
/// writes NAME.png, NAME.pdf and NAME.svg beside itself.

#include "reports/drawing/Figure.h"

#include <string>
#include <string_view>

namespace mrpp
{

/// The text as a gnuplot string constant. Single quotes: between double ones gnuplot would run what stands
/// in backticks. Control characters are gone, quotes doubled.
[[nodiscard]] std::string gnuplotString(std::string_view text);

/// The same figure gives the same script.
[[nodiscard]] std::string gnuplotScript(const Figure &figure);

} // namespace mrpp
