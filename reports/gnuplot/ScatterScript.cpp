#include "reports/gnuplot/ScriptKinds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kPanel = 10.2; // centimetres, square
constexpr double kRim = 0.075;  // of the axis, where failures stand

/// Where the axis ends and where its rim of failures lies.
struct Rim
{
    double end = 1;  ///< of the values
    double at = 1;   ///< of the failures
    double most = 1; ///< of the axis
};

Rim rimOf(const Axis &axis)
{
    const auto beyond = [&axis](double share)
    {
        return axis.logarithmic ? axis.most * std::pow(axis.most / axis.least, share)
                                : axis.most + share * (axis.most - axis.least);
    };
    return {axis.most, beyond(kRim / 2), beyond(kRim)};
}

/// With the rim's name, and without those too close to it.
Axis withRim(Axis axis, const Rim &rim)
{
    const auto share = [&axis](double at)
    {
        return axis.logarithmic ? std::log(at / axis.least) / std::log(axis.most / axis.least)
                                : (at - axis.least) / (axis.most - axis.least);
    };
    constexpr double kRoom = 0.11;
    for (Tic &tic : axis.tics)
        if (share(rim.at) - share(tic.at) < kRoom)
            tic.label.clear();
    axis.tics.push_back({rim.at, "failed"});
    return axis;
}

} // namespace

std::string scatterScript(const Figure &figure)
{
    std::vector<double> values;
    for (const FigurePair &pair : figure.pairs)
        for (const std::optional<double> &value : {pair.x, pair.y})
            if (value)
                values.push_back(*value);
    MeasureScale scale = scaleOf(figure.measure, values, figure.logY);
    const Rim rim = rimOf(scale.axis);
    scale.axis.most = rim.most;
    const Axis upright = withRim(scale.axis, rim);
    const Axis across = withRim(thinned(scale.axis, kPanel), rim);

    Script::Blocks both(1);
    Script::Blocks failed(1);
    for (const FigurePair &pair : figure.pairs)
        (pair.x && pair.y ? both : failed)[0].push_back(
            {pair.x ? *pair.x / scale.unit : rim.at, pair.y ? *pair.y / scale.unit : rim.at});
    Script script(figure.name);
    script.define("title_text", titleText(figure.title));
    script.define("across_text", titleText(figure.series[0].label + ": " + scale.title));
    script.define("measure_text", titleText(figure.series[1].label + ": " + scale.title));
    script.block("both", both);
    script.block("failed", failed);

    Page page = pageFor(0, 1, kPanel);
    page.left = std::max(leftOf(upright), (kFigureWidth - kPanel) / 2);
    page.right = page.left + kPanel;
    script.beginFormats(page);
    script.panel(page.left, page.right, page.bottom, page.top);
    script.axis("x", across);
    script.axis("y", upright);
    script
        << fmt::format("set label 1 measure_text at screen {:.5f},{:.5f} center rotate noenhanced\n",
                       script.x(page.left - leftOf(upright) + 0.55), script.y((page.top + page.bottom) / 2))
        << "set title title_text noenhanced font title_font offset 0,-0.2\n"
           "set xlabel across_text noenhanced\nunset key\n"
        << fmt::format(
               "set object 1 rectangle from {0},graph 0 to graph 1,graph 1 behind fc rgb '#efefef' fs solid "
               "noborder\nset object 2 rectangle from graph 0,first {0} to graph 1,graph 1 behind fc rgb "
               "'#efefef' fs solid noborder\n",
               rim.end)
        << fmt::format("set arrow 1 from {0},{0} to {1},{1} nohead lw 1 lc rgb '#606060' back\n",
                       scale.axis.least, rim.end);
    std::vector<std::string> items;
    const CurveStyle style = curveStyle(0);
    if (!both[0].empty())
        items.push_back(fmt::format("$both using 1:2 with points pt {} ps 0.6 lw 1 {}", style.hollowMarker,
                                    inkOf(style)));
    if (!failed[0].empty())
        items.emplace_back("$failed using 1:2 with points pt 2 ps 0.6 lw 1 lc rgb '#d55e00'");
    script.plot(items);
    return script.endFormats();
}

} // namespace mrpp
