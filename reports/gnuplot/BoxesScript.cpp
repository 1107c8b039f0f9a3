#include "reports/gnuplot/ScriptKinds.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

constexpr double kRow = 0.95; // centimetres
constexpr double kHalfBox = 0.28;
constexpr double kWhisker = 1.5; // quartile distances, as J. Tukey's

/// The items that draw a row of $box_i: whiskers, box, median.
void addBox(std::vector<std::string> &items, const std::string &data, const std::string &ink)
{
    items.push_back(fmt::format("{} using 2:1:($6-$2):(0) with vectors nohead lw 1 {}", data, ink));
    items.push_back(fmt::format(
        "{0} using 3:1:3:5:($1-{1}):($1+{1}) with boxxyerror lc rgb '#ffffff' fs solid 1.0 noborder", data,
        kHalfBox));
    items.push_back(fmt::format(
        "{0} using 3:1:3:5:($1-{1}):($1+{1}) with boxxyerror {2} fs transparent solid 0.3 border {2}", data,
        kHalfBox, ink));
    items.push_back(fmt::format("{} using 4:($1-{}):(0):({}) with vectors nohead lw 2.5 {}", data, kHalfBox,
                                2 * kHalfBox, ink));
}

} // namespace

std::string boxesScript(const Figure &figure)
{
    std::vector<double> values;
    for (const FigureSeries &series : figure.series)
        values.insert(values.end(), series.sample.begin(), series.sample.end());
    for (const FigureBound &bound : figure.bounds)
        values.push_back(bound.value);
    const MeasureScale scale = scaleOf(figure.measure, values, figure.logX);
    const auto rows = static_cast<double>(figure.series.size());

    Script script(figure.name);
    defineTexts(script, figure, scale.title);
    Page page = pageFor(0, 1, std::max(2.0, kRow * rows));
    std::size_t name = 0;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const FigureSeries &series = figure.series[i];
        const std::string row =
            rowText(series.label) + fmt::format(" ({}/{})", series.sample.size(), series.runs);
        name = std::max(name, characterCount(row));
        script.define(fmt::format("row_{}", i), ticText(row));
        const auto middle = quartiles(series.sample);
        if (!middle)
            continue;
        const double reach = kWhisker * (middle->q3 - middle->q1);
        double low = middle->q1;
        double high = middle->q3;
        Script::Blocks outliers(1);
        const bool isBox = middle->hasBand(); // of fewer, every value is shown
        for (const double value : series.sample)
        {
            const bool isFar = !isBox || value < middle->q1 - reach || value > middle->q3 + reach;
            if (isFar)
                outliers[0].push_back({value / scale.unit, static_cast<double>(i)});
            low = isFar ? low : std::min(low, value);
            high = isFar ? high : std::max(high, value);
        }
        std::sort(outliers[0].begin(), outliers[0].end());
        outliers[0].erase(std::unique(outliers[0].begin(), outliers[0].end()), outliers[0].end());
        if (isBox)
            script.block(fmt::format("box_{}", i),
                         {{{static_cast<double>(i), low / scale.unit, middle->q1 / scale.unit,
                            middle->median / scale.unit, middle->q3 / scale.unit, high / scale.unit}}});
        script.block(fmt::format("outliers_{}", i), outliers);
    }
    page.left = std::max(2.2, 0.7 + static_cast<double>(name) * kCharacter);

    script.beginFormats(page);
    script.panel(page.left, page.right, page.bottom, page.top);
    script.axis("x", thinned(scale.axis, page.right - page.left));
    script << "set yrange [" << rows - 0.5 << ":-0.5]\nset ytics (";
    for (std::size_t i = 0; i < figure.series.size(); ++i)
        script << (i == 0 ? "" : ", ") << "row_" << i << " " << i;
    script << ") scale 0\nset grid noytics\nset xlabel measure_text noenhanced\n"
              "set title title_text noenhanced font title_font offset 0,-0.2\nunset key\n";
    for (const FigureBound &bound : figure.bounds)
        script << fmt::format(
            "set arrow from {0},graph 0 to {0},graph 1 nohead dt (4,4) lw 1.2 lc rgb '#606060' back\n",
            bound.value / scale.unit);
    std::vector<std::string> items;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const CurveStyle style = curveStyle(figure.series[i].style);
        const std::string ink = inkOf(style);
        if (figure.series[i].sample.empty())
            continue;
        const auto middle = quartiles(figure.series[i].sample);
        const bool isBox = middle->hasBand();
        if (isBox)
            addBox(items, fmt::format("$box_{}", i), ink);
        const double reach = kWhisker * (middle->q3 - middle->q1);
        if (!isBox || std::any_of(figure.series[i].sample.begin(), figure.series[i].sample.end(),
                                  [&](double value)
                                  { return value < middle->q1 - reach || value > middle->q3 + reach; }))
            items.push_back(fmt::format("$outliers_{} using 1:2 with points pt {} ps 0.5 {}", i,
                                        style.hollowMarker, ink));
    }
    if (items.empty())
        items.emplace_back("NaN");
    script.plot(items);
    return script.endFormats();
}

} // namespace mrpp
