#pragma once
/// \file
/// The scripts of the kinds of figures, one source each; gnuplotScript() chooses.

#include "reports/gnuplot/Script.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

[[nodiscard]] std::string curvesScript(const Figure &figure);
[[nodiscard]] std::string comparisonScript(const Figure &figure);
[[nodiscard]] std::string stepsScript(const Figure &figure);
[[nodiscard]] std::string boxesScript(const Figure &figure);
[[nodiscard]] std::string scatterScript(const Figure &figure);
[[nodiscard]] std::string ranksScript(const Figure &figure);

/// A measure's axis: its unit, so that it stays free of tiny numbers, and its title. The .csv keeps seconds.
struct MeasureScale
{
    Axis axis;
    double unit = 1; ///< the axis shows values divided by it
    std::string title;
};
[[nodiscard]] MeasureScale scaleOf(const std::string &measure, std::vector<double> values,
                                   std::optional<bool> logarithmic);

/// The items that draw the points of $values_i: filled markers where every instance was solved, hollow ones
/// where only some were. \param columns of gnuplot's `using`, with {} for the condition
void addMarkers(std::vector<std::string> &items, const std::string &data, const std::string &columns,
                const CurveStyle &style);

/// Writes $values_i (place, median, solved, of how many), $band_i (place, quartiles, 1 where it stands alone,
/// median) and $success_i of curves and comparisons. \param shift of the i-th series along the places
void writePoints(Script &script, const Figure &figure, double unit, const std::vector<double> &shift);

/// Whether $band_i, and whether $success_i, has rows.
[[nodiscard]] bool hasBand(const FigureSeries &series);
[[nodiscard]] bool hasShare(const FigureSeries &series);

/// All values of a figure's points and bounds.
[[nodiscard]] std::vector<double> pointValues(const Figure &figure);

/// Defines title_text, measure_text and label_0 …, and returns how long the longest label is.
std::size_t defineTexts(Script &script, const Figure &figure, const std::string &measure);

} // namespace mrpp
