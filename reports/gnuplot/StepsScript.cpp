#include "reports/gnuplot/ScriptKinds.h"

#include <cmath>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kPanel = 7.6;    // centimetres
constexpr int kMarkersACurve = 8; // more would hide the line

/// Shares run from 0 to 1 and are shown in percent; everything else as a measure.
bool isShare(const Figure &figure)
{
    return figure.isPercentage;
}

/// Corners of the line spread evenly over the axis, so that planners are told apart wherever one looks.
std::vector<Script::Row> markersOf(const std::vector<Script::Row> &line, const Axis &axis)
{
    const auto scaled = [&axis](double x) { return axis.logarithmic ? std::log(x) : x; };
    const double width = (scaled(axis.most) - scaled(axis.least)) / kMarkersACurve;
    std::vector<Script::Row> markers;
    for (const Script::Row &corner : line)
        if (markers.empty() || scaled(corner[0]) >= scaled(markers.back()[0]) + width)
            markers.push_back(corner);
    return markers;
}

} // namespace

std::string stepsScript(const Figure &figure)
{
    std::vector<double> xs;
    std::vector<double> ys;
    for (const FigureSeries &series : figure.series)
        for (const StepPoint &step : series.steps)
        {
            xs.push_back(step.x);
            ys.push_back(step.y);
        }
    if (!isShare(figure)) // a cactus: whoever fails stays short of all runs
        for (const FigureSeries &series : figure.series)
            xs.push_back(static_cast<double>(series.runs));
    MeasureScale across = scaleOf(figure.variable, xs, figure.logX);
    if (figure.xFrom)
    {
        constexpr double kLeastRange = 1.05; // where nobody is worse by more, that is to be seen
        const double most = std::max(across.axis.most, kLeastRange * *figure.xFrom);
        if (across.axis.logarithmic)
            across.axis.least = *figure.xFrom;
        else
            across.axis = evenAxis(*figure.xFrom, most);
    }
    MeasureScale up = scaleOf(figure.measure, ys, figure.logY);
    if (isShare(figure))
        up.axis = {false, -2, 102, {{0, "0"}, {25, "25"}, {50, "50"}, {75, "75"}, {100, "100"}}};

    Script script(figure.name);
    const std::size_t longest = defineTexts(script, figure, up.title);
    script.define("variable_text", across.title);
    Page page = pageFor(figure.series.size(), longest, kPanel);
    page.left = leftOf(up.axis);
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const FigureSeries &series = figure.series[i];
        Script::Blocks line(1);
        for (const StepPoint &step : series.steps)
            line[0].push_back({step.x / across.unit, isShare(figure) ? 100 * step.y : step.y / up.unit});
        const Script::Blocks markers = {markersOf(line[0], across.axis)};
        if (isShare(figure) && !line[0].empty()) // the plateau of what is never solved goes on to the edge
            line[0].push_back({across.axis.most, line[0].back()[1]});
        script.block(fmt::format("steps_{}", i), line);
        script.block(fmt::format("markers_{}", i), markers);
    }

    script.beginFormats(page);
    script.panel(page.left, page.right, page.bottom, page.top);
    script.axis("x", thinned(across.axis, page.right - page.left));
    script.axis("y", up.axis);
    script.verticalTitle("measure_text", page.bottom, page.top);
    script << "set title title_text noenhanced font title_font offset 0,-0.2\n"
              "set xlabel variable_text noenhanced\n";
    script.legend();
    std::vector<std::string> items;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const CurveStyle style = curveStyle(figure.series[i].style);
        const std::string line = fmt::format("lw 1.5 dt {} {}", style.dashes, inkOf(style));
        if (!figure.series[i].steps.empty())
        {
            items.push_back(fmt::format("$steps_{} using 1:2 with {} {} notitle", i,
                                        isShare(figure) ? "steps" : "lines", line));
            items.push_back(fmt::format("$markers_{} using 1:2 with points pt {} ps 0.7 {} notitle", i,
                                        style.filledMarker, inkOf(style)));
        }
        items.push_back(fmt::format("keyentry with linespoints pt {} ps 0.7 {} title label_{}",
                                    style.filledMarker, line, i));
    }
    script.plot(items);
    return script.endFormats();
}

} // namespace mrpp
