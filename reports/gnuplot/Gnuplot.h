#pragma once
/// \file
/// Draws figures by running gnuplot, and only those that are not drawn already.

#include "reports/figures/Figure.h"
#include "reports/picture/Picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mrpp
{

/// A figure drawn, or the reason why not.
struct DrawnFigure
{
    Picture picture;
    std::string missing;  ///< why there is no picture; empty where there is one
    bool isFresh = false; ///< false where the folder held it already
};

/// Runs gnuplot on the figure's script, without a shell, in a folder of its own.
/// Throws DrawingError where gnuplot is missing, fails or hangs.
[[nodiscard]] Picture drawFigure(const Figure &figure);

/// All figures, several at a time. A figure whose script in `folder` says the same, data included, is taken
/// from there: NAME.gp is written after the pictures, so it vouches for them.
[[nodiscard]] std::vector<DrawnFigure> drawFigures(const std::vector<Figure> &figures,
                                                   const std::filesystem::path &folder);

/// Writes NAME.csv, the pictures and last NAME.gp, where they are not there already; the files' paths.
/// Throws FileError.
std::vector<std::filesystem::path> writeFigure(const Figure &figure, const DrawnFigure &drawn,
                                               const std::filesystem::path &folder);

} // namespace mrpp
