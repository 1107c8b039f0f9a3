#pragma once
/// \file
/// What a figure shows, before anything is drawn: shared by all reports that have figures.

#include "framework/statistics/Profiles.h"
#include "reports/summary/Aggregate.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

/// One planner at one place of a figure.
struct FigurePoint
{
    double at = 0;                  ///< the swept value, or the row's index
    std::optional<Quartiles> value; ///< RunGroup::cost(), or nothing
    std::size_t solved = 0;         ///< instances
    std::size_t runs = 0;           ///< instances that count for success
};

/// A fitted law at one place.
struct FigureFit
{
    double at = 0;
    double value = 0;
    double low = 0; ///< of its band
    double high = 0;
};

/// A case on which two planners are compared.
struct FigurePair
{
    std::optional<double> x; ///< the first planner's cost; nothing where it failed
    std::optional<double> y; ///< the second's
    std::string name;        ///< of the case
};

/// One planner.
struct FigureSeries
{
    std::string label;
    std::size_t style = 0;             ///< index of its CurveStyle
    std::vector<FigurePoint> points;   ///< of curves and comparisons
    std::vector<StepPoint> steps;      ///< of steps
    std::vector<double> sample;        ///< of boxes
    std::vector<FigureFit> fit;        ///< of curves: a law beside the points
    std::optional<double> heldOutFrom; ///< of a fit: sizes from here on were foretold
    double meanRank = 0;               ///< of ranks
    std::size_t solved = 0;            ///< of series without points
    std::size_t runs = 0;
    std::string remark; ///< behind its name in the legend
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
        steps,      ///< curves that rise by steps: cactus, profiles, distribution functions
        boxes,      ///< a measure's distribution, a row a planner
        scatter,    ///< two planners' costs on the same cases
        ranks,      ///< mean ranks and which of them are not told apart
    };
    Kind kind = Kind::curves;
    std::string name;    ///< file name without extension
    std::string subject; ///< title of the summary table with the same runs; empty where there is none
    std::string title;   ///< within the picture
    std::string caption; ///< can stand alone
    std::string
        variable; ///< title of the horizontal axis of curves and steps; of scatters the first planner's
    std::string measure; ///< what the numbers are: "Time (s)"; an axis may show ms
    bool isPercentage =
        false; ///< the measure is a share in percent, so there is no panel of success beside it
    bool countsSolved = true;              ///< whether the legend says how many runs were solved
    std::string shareTitle = "Solved (%)"; ///< of the panel beneath curves
    std::optional<bool> logX;              ///< nothing: where that serves
    std::optional<bool> logY;
    std::optional<double> xFrom;   ///< of steps: where their horizontal axis begins
    std::vector<std::string> rows; ///< problems of a comparison, from the top
    std::vector<FigureSeries> series;
    std::string boundLabel; ///< empty where there is no bound
    std::vector<FigureBound> bounds;
    std::vector<FigurePair> pairs; ///< of scatter; its two series name the planners
    double criticalDifference = 0; ///< of ranks
    std::vector<std::pair<std::size_t, std::size_t>>
        groups; ///< of ranks: first and last series that are not told apart; series in the order of their
                ///< ranks
};

/// The numbers that the figure shows, a row a point.
[[nodiscard]] std::string figureCsv(const Figure &figure);

} // namespace mrpp
