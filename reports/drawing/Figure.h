#pragma once
/// \file
/// What a figure shows, before anything is drawn: shared by `charts` and `pdf`.

#include "reports/Aggregate.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// One planner at one place of a figure.
struct FigurePoint
{
    double at = 0;                  ///< the swept value, or the row's index
    std::optional<Quartiles> value; ///< over the solved runs; nothing where there is none
    std::size_t solved = 0;
    std::size_t runs = 0;
};

/// One planner.
struct FigureSeries
{
    std::string label;
    std::size_t style = 0; ///< index of its CurveStyle
    std::vector<FigurePoint> points;
};

/// What no planner can beat, at one place.
struct FigureBound
{
    double at = 0;
    double value = 0;
};

struct Figure
{
    enum class Kind
    {
        curves,     ///< a measure against a swept variable
        comparison, ///< a measure of each problem, a row a problem
    };
    Kind kind = Kind::curves;
    std::string name;     ///< file name without extension
    std::string title;    ///< within the picture
    std::string caption;  ///< can stand alone
    std::string variable; ///< title of the swept variable's axis
    std::string measure;  ///< what the numbers are: "Time (s)"; an axis may show ms
    bool isPercentage =
        false; ///< the measure is a share in percent, so there is no panel of success beside it
    std::vector<std::string> rows; ///< problems of a comparison, from the top
    std::vector<FigureSeries> series;
    std::string boundLabel; ///< empty where there is no bound
    std::vector<FigureBound> bounds;
};

/// The numbers that the figure shows, a row a point.
[[nodiscard]] std::string figureCsv(const Figure &figure);

} // namespace mrpp
