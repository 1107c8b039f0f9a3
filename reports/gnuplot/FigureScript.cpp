#include "reports/gnuplot/FigureScript.h"

#include "reports/gnuplot/ScriptKinds.h"
#include "reports/picture/Numbers.h"
#include "reports/picture/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

MeasureScale scaleOf(const std::string &measure, std::vector<double> values, std::optional<bool> logarithmic)
{
    constexpr std::string_view kSeconds = " (s)";
    MeasureScale scale;
    scale.title = measure;
    if (!values.empty() && measure.ends_with(kSeconds))
    {
        const TimeUnit unit = measureAxis(values, logarithmic).logarithmic
                                  ? timeUnit(values)
                                  : timeUnit(*std::max_element(values.begin(), values.end()));
        scale.unit = unit.seconds;
        scale.title.resize(scale.title.size() - kSeconds.size());
        scale.title += fmt::format(" ({})", unit.name);
    }
    for (double &value : values)
        value /= scale.unit;
    scale.axis = measureAxis(values, logarithmic);
    return scale;
}

void addMarkers(std::vector<std::string> &items, const std::string &data, const std::string &columns,
                const CurveStyle &style)
{
    const auto add = [&](const char *condition, int marker, const std::string &ink)
    {
        items.push_back(fmt::format("{} using {} with points pt {} ps 0.7 {} notitle", data,
                                    fmt::format(fmt::runtime(columns), condition), marker, ink));
    };
    add("$3==$4", style.filledMarker, inkOf(style));
    add("$3<$4", style.filledMarker, "lc rgb '#ffffff'");
    add("$3<$4", style.hollowMarker, inkOf(style));
}

void writePoints(Script &script, const Figure &figure, double unit, const std::vector<double> &shift)
{
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        Script::Blocks values(1);
        Script::Blocks bands(1);
        Script::Blocks success(1);
        const auto end = [](Script::Blocks &blocks) // of a piece without gaps
        {
            if (!blocks.back().empty())
                blocks.emplace_back();
        };
        for (const FigurePoint &point : figure.series[i].points)
        {
            const double at = point.at + shift[i];
            const auto solved = static_cast<double>(point.solved);
            const auto runs = static_cast<double>(point.runs);
            if (runs > 0)
                success[0].push_back({at, 100 * solved / runs});
            if (point.value)
                values.back().push_back({at, point.value->median / unit, solved, runs});
            else
                end(values);
            if (point.value && point.value->hasBand())
                bands.back().push_back(
                    {at, point.value->q1 / unit, point.value->q3 / unit, 0, point.value->median / unit});
            else
                end(bands);
        }
        for (Script::Blocks *blocks : {&values, &bands})
            if (blocks->back().empty())
                blocks->pop_back();
        for (std::vector<Script::Row> &piece : bands) // a band of one point is nothing to see; it gets a bar
            if (piece.size() == 1)
                piece.front()[3] = 1;
        script.block(fmt::format("values_{}", i), values);
        script.block(fmt::format("band_{}", i), bands);
        if (!figure.isPercentage)
            script.block(fmt::format("success_{}", i), success);
    }
}

bool hasBand(const FigureSeries &series)
{
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const FigurePoint &point) { return point.value && point.value->hasBand(); });
}

bool hasShare(const FigureSeries &series)
{
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const FigurePoint &point) { return point.runs > 0; });
}

std::vector<double> pointValues(const Figure &figure)
{
    std::vector<double> values;
    for (const FigureSeries &series : figure.series)
        for (const FigurePoint &point : series.points)
            if (point.value)
            {
                values.push_back(point.value->median);
                if (point.value->hasBand())
                    values.insert(values.end(), {point.value->q1, point.value->q3});
            }
    for (const FigureBound &bound : figure.bounds)
        values.push_back(bound.value);
    return values;
}

std::size_t defineTexts(Script &script, const Figure &figure, const std::string &measure)
{
    std::size_t longest = characterCount(figure.boundLabel);
    script.define("title_text", titleText(figure.title));
    script.define("measure_text", measure);
    for (std::size_t i = 0; i < figure.series.size(); ++i)
    {
        const std::string label = legendText(figure, figure.series[i]);
        longest = std::max(longest, characterCount(label));
        script.define(fmt::format("label_{}", i), label);
    }
    if (!figure.bounds.empty())
        script.define("bound_text", figure.boundLabel);
    return longest;
}

std::string gnuplotString(std::string_view text)
{
    std::string quoted = "'";
    for (const char c : oneLine(text))
        quoted += c == '\'' ? std::string("'.\"'\".'") : std::string(1, c);
    return quoted + "'";
}

std::string gnuplotScript(const Figure &figure)
{
    switch (figure.kind)
    {
    case Figure::Kind::comparison:
        return comparisonScript(figure);
    case Figure::Kind::steps:
        return stepsScript(figure);
    case Figure::Kind::boxes:
        return boxesScript(figure);
    case Figure::Kind::scatter:
        return scatterScript(figure);
    case Figure::Kind::ranks:
        return ranksScript(figure);
    case Figure::Kind::curves:
        break;
    }
    return curvesScript(figure);
}

} // namespace mrpp
