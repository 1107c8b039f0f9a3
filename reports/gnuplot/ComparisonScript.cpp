#include "reports/gnuplot/ScriptKinds.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kSharePanel = 2.9; // centimetres, with the gap beside it
constexpr double kShareGap = 0.4;   // centimetres

bool hasValue(const FigureSeries &series)
{
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const FigurePoint &point) { return point.value.has_value(); });
}

/// Where the series stand within each row, −0.4 … 0.4.
std::vector<double> lanes(std::size_t count)
{
    std::vector<double> shifts;
    for (std::size_t i = 0; i < count; ++i)
        shifts.push_back(((static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5) * 0.8);
    return shifts;
}

void writeShares(Script &script, const Figure &figure, const Page &page)
{
    script.panel(page.right + kShareGap, kFigureWidth - kFigureMargin, page.bottom, page.top);
    script.axis("x", {false, -12, 112, {{0, "0"}, {50, "50"}, {100, "100"}}});
    script << "set format y ''\nset ytics () scale 0\nset xlabel 'Solved (%)' noenhanced\nunset "
              "title\nunset key\n";
    std::vector<std::string> items;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const CurveStyle style = curveStyle(figure.series[i].style);
        if (hasShare(figure.series[i]))
            items.push_back(fmt::format("$success_{} using 2:1 with points pt {} ps 0.55 {}", i,
                                        style.filledMarker, inkOf(style)));
    }
    script.plot(items);
}

} // namespace

std::string comparisonScript(const Figure &figure)
{
    const MeasureScale scale = scaleOf(figure.measure, pointValues(figure), figure.logY);
    const bool hasBounds = !figure.bounds.empty();
    const auto rows = static_cast<double>(figure.rows.size());
    const double rowHeight = std::max(0.6, 0.17 * static_cast<double>(figure.series.size()) + 0.2);

    Script script(figure.name);
    const std::size_t longest = defineTexts(script, figure, scale.title);
    Page page = pageFor(figure.series.size() + (hasBounds ? 1 : 0), longest, std::max(2.0, rowHeight * rows));
    std::size_t name = 0;
    for (std::size_t i = 0; i < figure.rows.size(); ++i)
    {
        const std::string row = rowText(figure.rows[i]);
        name = std::max(name, characterCount(row));
        script.define(fmt::format("row_{}", i), ticText(row));
    }
    page.left = std::max(2.2, 0.7 + static_cast<double>(name) * kCharacter);
    page.right -= kSharePanel;
    writePoints(script, figure, scale.unit, lanes(figure.series.size()));
    Script::Blocks bounds(1);
    for (const FigureBound &bound : figure.bounds)
        bounds[0].push_back({bound.value / scale.unit, bound.at - 0.42, 0, 0.84});
    script.block("bounds", bounds);

    script.beginFormats(page);
    for (std::size_t row = 1; row < figure.rows.size(); row += 2)
        script << fmt::format("set object {0} rectangle from graph 0, first {1} to graph 1, first {2} behind "
                              "fc rgb '#f0f0f0' fs solid noborder\n",
                              row, static_cast<double>(row) - 0.5, static_cast<double>(row) + 0.5);
    script.panel(page.left, page.right, page.bottom, page.top);
    script.axis("x", thinned(scale.axis, page.right - page.left));
    script << "set yrange [" << rows - 0.5 << ":-0.5]\nset ytics (";
    for (std::size_t row = 0; row < figure.rows.size(); ++row)
        script << (row == 0 ? "" : ", ") << "row_" << row << " " << row;
    script << ") scale 0\nset grid noytics\nset xlabel measure_text noenhanced\n"
              "set title title_text noenhanced font title_font offset 0,-0.2\n";
    script.legend();
    std::vector<std::string> items;
    if (hasBounds)
    {
        items.emplace_back("$bounds using 1:2:3:4 with vectors nohead lw 1.5 lc rgb '#303030' notitle");
        items.emplace_back("keyentry with vectors nohead lw 1.5 lc rgb '#303030' title bound_text");
    }
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const CurveStyle style = curveStyle(figure.series[i].style);
        const std::string data = fmt::format("$values_{}", i);
        if (hasBand(figure.series[i]))
            items.push_back(
                fmt::format("$band_{} using 5:1:2:3 with xerrorbars ps 0 lw 1 {} notitle", i, inkOf(style)));
        if (hasValue(figure.series[i]))
        {
            addMarkers(items, data, "({}?$2:NaN):1", style);
        }
        items.push_back(fmt::format("keyentry with points pt {} ps 0.7 {} title label_{}", style.filledMarker,
                                    inkOf(style), i));
    }
    script.plot(items);
    writeShares(script, figure, page);
    return script.endFormats();
}

} // namespace mrpp
