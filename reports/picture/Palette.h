#pragma once
/// \file
/// Colours, line styles and markers that stay apart in print and for colour-blind readers.
///
/// The first colours are those of M. Okabe and K. Ito, "Color Universal Design" (2008). No two of the
/// first 40 curves share colour, marker and dashes, so none is told apart by colour alone.

#include <cstddef>
#include <string>

namespace mrpp
{

/// How the i-th planner of a plan is drawn, the same in every figure.
struct CurveStyle
{
    std::string color;    ///< "#rrggbb"
    int filledMarker = 7; ///< gnuplot point type
    int hollowMarker = 6; ///< its outline
    std::string dashes;   ///< gnuplot dash type
};
[[nodiscard]] CurveStyle curveStyle(std::size_t index);

/// The i-th robot's colour, "#rrggbb": Okabe and Ito's first, then hues by the golden angle.
[[nodiscard]] std::string robotColor(std::size_t index);

/// Red, green and blue, 0 … 1, of "#rrggbb".
struct Rgb
{
    double red = 0;
    double green = 0;
    double blue = 0;
};
[[nodiscard]] Rgb rgb(const std::string &color);

/// "#000000" or "#ffffff", whichever reads better on that colour.
[[nodiscard]] std::string textColorOn(const std::string &color);

} // namespace mrpp
