#pragma once
/// \file
/// A figure as a gnuplot script that stands alone: data within, run by `gnuplot NAME.gp` in its own folder it
/// writes NAME.png, NAME.pdf and NAME.svg beside itself.

#include "reports/figures/Figure.h"

#include <string>
#include <string_view>

namespace mrpp
{

/// The text as a gnuplot string expression. Single quotes: between double ones gnuplot would run what stands
/// in backticks. A quote of the text becomes a constant of its own, as in 'it'."'".'s': doubled, as the
/// manual has it, several in a row would end the string early. Control characters are gone.
[[nodiscard]] std::string gnuplotString(std::string_view text);

/// The same figure gives the same script.
[[nodiscard]] std::string gnuplotScript(const Figure &figure);

} // namespace mrpp
