#include "reports/figures/Figure.h"

#include "framework/support/Config.h"
#include "reports/document/Csv.h"

#include <cmath>

namespace mrpp
{

namespace
{

std::string cell(const std::optional<double> &value)
{
    return value && std::isfinite(*value) ? formatNumber(*value) : std::string();
}

void heading(CsvTable &table, const std::vector<std::string> &names)
{
    for (const std::string &name : names)
        table.cell(name);
    table.endRow();
}

void writePoints(CsvTable &table, const Figure &figure)
{
    const bool comparison = figure.kind == Figure::Kind::comparison;
    const auto place = [&](double at)
    { return comparison ? figure.rows[static_cast<std::size_t>(at)] : formatNumber(at); };
    heading(table, {"series", comparison ? "problem" : figure.variable, "median of " + figure.measure, "q1",
                    "q3", "n", "solved", "runs"});
    const auto special = [&](const std::string &series, const std::vector<std::string> &cells)
    {
        table.cell(series);
        for (const std::string &text : cells)
            table.cell(text);
        for (int empty = 0; empty < 3; ++empty)
            table.cell("");
        table.endRow();
    };
    for (const FigureSeries &series : figure.series)
        for (const FigurePoint &point : series.points)
        {
            table.cell(series.label);
            table.cell(place(point.at));
            table.cell(point.value ? formatNumber(point.value->median) : std::string());
            table.cell(point.value ? cell(point.value->q1) : std::string());
            table.cell(point.value ? cell(point.value->q3) : std::string());
            table.cell(std::to_string(point.value ? point.value->count : 0));
            table.cell(std::to_string(point.solved));
            table.cell(std::to_string(point.runs));
            table.endRow();
        }
    for (const FigureBound &bound : figure.bounds)
        special(figure.boundLabel, {place(bound.at), formatNumber(bound.value), "", ""});
    for (const FigureSeries &series : figure.series)
        for (const FigureFit &fit : series.fit)
            special("fit of " + series.label, {formatNumber(fit.at), formatNumber(fit.value),
                                               formatNumber(fit.low), formatNumber(fit.high)});
}

/// A row for each of a series' values.
template <class Rows>
void writeSeries(CsvTable &table, const Figure &figure, const std::vector<std::string> &names, Rows &&rows)
{
    heading(table, names);
    for (const FigureSeries &series : figure.series)
        for (const std::vector<double> &values : rows(series))
        {
            table.cell(series.label);
            for (const double value : values)
                table.cell(formatNumber(value));
            table.endRow();
        }
}

} // namespace

std::string figureCsv(const Figure &figure)
{
    using Rows = std::vector<std::vector<double>>;
    CsvTable table;
    switch (figure.kind)
    {
    case Figure::Kind::curves:
    case Figure::Kind::comparison:
        writePoints(table, figure);
        break;
    case Figure::Kind::steps:
        writeSeries(table, figure, {"series", figure.variable, figure.measure},
                    [](const FigureSeries &series)
                    {
                        Rows rows;
                        for (const StepPoint &step : series.steps)
                            rows.push_back({step.x, step.y});
                        return rows;
                    });
        break;
    case Figure::Kind::boxes:
        writeSeries(table, figure, {"series", figure.measure},
                    [](const FigureSeries &series)
                    {
                        Rows rows;
                        for (const double value : series.sample)
                            rows.push_back({value});
                        return rows;
                    });
        break;
    case Figure::Kind::ranks:
        writeSeries(table, figure, {"series", "mean rank", "critical difference"},
                    [&](const FigureSeries &series) {
                        return Rows{{series.meanRank, figure.criticalDifference}};
                    });
        break;
    case Figure::Kind::scatter:
        heading(table, {"case", figure.series[0].label, figure.series[1].label});
        for (const FigurePair &pair : figure.pairs)
        {
            table.cell(pair.name);
            table.cell(cell(pair.x));
            table.cell(cell(pair.y));
            table.endRow();
        }
        break;
    }
    return table.text();
}

} // namespace mrpp
