#include "reports/gnuplot/ScriptKinds.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kPanel = 6.6;      // centimetres
constexpr double kSharePanel = 2.0; // centimetres, with the gap above it
constexpr double kShareGap = 0.35;  // centimetres
constexpr const char *kBound = "lw 1.2 dt (4,4) lc rgb '#606060'";

bool hasValue(const FigureSeries &series)
{
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const FigurePoint &point) { return point.value.has_value(); });
}

void writeShares(Script &script, const Figure &figure, const Page &page, const Axis &sweep)
{
    const double bottom = page.bottom - kSharePanel;
    const double top = page.bottom - kShareGap;
    script.panel(page.left, page.right, bottom, top);
    script.axis("x", sweep);
    script.axis("y", {false, -12, 112, {{0, "0"}, {50, "50"}, {100, "100"}}});
    script.verticalTitle("share_text", bottom, top, " font small_font");
    script << "unset title\nunset key\nunset arrow\nset xlabel variable_text noenhanced\n";
    std::vector<std::string> items;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const CurveStyle style = curveStyle(figure.series[i].style);
        if (hasShare(figure.series[i]))
            items.push_back(
                fmt::format("$success_{} using 1:2 with linespoints pt {} ps 0.45 lw 1.2 dt {} {}", i,
                            style.filledMarker, style.dashes, inkOf(style)));
    }
    script.plot(items);
}

void writeFits(Script &script, const Figure &figure, double unit)
{
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        Script::Blocks fits(1);
        for (const FigureFit &fit : figure.series[i].fit)
            fits[0].push_back({fit.at, fit.value / unit, fit.low / unit, fit.high / unit});
        script.block(fmt::format("fit_{}", i), fits);
    }
}

} // namespace

std::string curvesScript(const Figure &figure)
{
    std::vector<double> places;
    for (const FigureSeries &series : figure.series)
        for (const FigurePoint &point : series.points)
            places.push_back(point.at);
    MeasureScale scale = scaleOf(figure.measure, pointValues(figure), figure.logY);
    if (figure.isPercentage)
        scale.axis = {false, -4, 104, {{0, "0"}, {25, "25"}, {50, "50"}, {75, "75"}, {100, "100"}}};
    const bool hasShares = !figure.isPercentage;
    const bool hasBounds = !figure.bounds.empty();

    Script script(figure.name);
    const std::size_t longest = defineTexts(script, figure, scale.title);
    script.define("variable_text", titleText(figure.variable));
    script.define("share_text", figure.shareTitle);
    Page page =
        pageFor(figure.series.size() + (hasBounds ? 1 : 0), longest, kPanel, hasShares ? kSharePanel : 0);
    page.left = leftOf(scale.axis);
    const Axis sweep = thinned(sweepAxis(std::move(places), figure.logX), page.right - page.left);
    writePoints(script, figure, scale.unit, std::vector<double>(figure.series.size()));
    writeFits(script, figure, scale.unit);
    Script::Blocks bounds(1);
    for (const FigureBound &bound : figure.bounds)
        bounds[0].push_back({bound.at, bound.value / scale.unit});
    script.block("bounds", bounds);

    script.beginFormats(page);
    script.panel(page.left, page.right, page.bottom, page.top);
    script.axis("x", sweep, !hasShares);
    script.axis("y", scale.axis);
    script.verticalTitle("measure_text", page.bottom, page.top);
    script << "set title title_text noenhanced font title_font offset 0,-0.2\n";
    if (!hasShares)
        script << "set xlabel variable_text noenhanced\n";
    for (const FigureSeries &series : figure.series)
        if (series.heldOutFrom)
            script << fmt::format("set arrow from {0},graph 0 to {0},graph 1 nohead dt (6,4) lw 0.8 {1}\n",
                                  *series.heldOutFrom, inkOf(curveStyle(series.style)));
    script.legend();
    std::vector<std::string> items;
    for (std::size_t i = 0; i < figure.series.size() && hasShares; ++i)
    {
        const FigureSeries &series = figure.series[i];
        if (series.fit.empty() && !hasBand(series))
            continue;
        items.push_back(fmt::format("{} with filledcurves fs transparent solid 0.15 noborder {} notitle",
                                    series.fit.empty() ? fmt::format("$band_{} using 1:2:3", i)
                                                       : fmt::format("$fit_{} using 1:3:4", i),
                                    inkOf(curveStyle(series.style))));
    }
    if (hasBounds)
    {
        items.push_back(fmt::format("$bounds using 1:2 with lines {} notitle", kBound));
        items.push_back(fmt::format("keyentry with lines {} title bound_text", kBound));
    }
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const FigureSeries &series = figure.series[i];
        const CurveStyle style = curveStyle(series.style);
        const std::string data = fmt::format("$values_{}", i);
        const std::string line = fmt::format("lw 1.5 dt {} {}", style.dashes, inkOf(style));
        if (hasBand(series))
            items.push_back(fmt::format("$band_{} using 1:{}:2:3 with yerrorbars ps 0 lw 1 {} notitle", i,
                                        series.fit.empty() ? "($4==1?$5:NaN)" : "5", inkOf(style)));
        if (hasValue(series))
        {
            items.push_back(series.fit.empty()
                                ? fmt::format("{} using 1:2 with lines {} notitle", data, line)
                                : fmt::format("$fit_{} using 1:2 with lines {} notitle", i, line));
            addMarkers(items, data, "1:({}?$2:NaN)", style);
        }
        items.push_back(fmt::format("keyentry with linespoints pt {} ps 0.7 {} title label_{}",
                                    style.filledMarker, line, i));
    }
    script.plot(items);
    if (hasShares)
        writeShares(script, figure, page, sweep);
    return script.endFormats();
}

} // namespace mrpp
