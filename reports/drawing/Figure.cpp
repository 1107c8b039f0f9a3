#include "reports/drawing/Figure.h"

#include "framework/support/Config.h"
#include "reports/drawing/Csv.h"

namespace mrpp
{

std::string figureCsv(const Figure &figure)
{
    const bool comparison = figure.kind == Figure::Kind::comparison;
    const auto place = [&](double at)
    { return comparison ? figure.rows[static_cast<std::size_t>(at)] : formatNumber(at); };
    CsvTable table;
    for (const std::string &name :
         {std::string("series"), comparison ? "problem" : figure.variable, "median of " + figure.measure,
          std::string("q1"), std::string("q3"), std::string("n"), std::string("solved"), std::string("runs")})
        table.cell(name);
    table.endRow();
    for (const FigureSeries &series : figure.series)
        for (const FigurePoint &point : series.points)
        {
            table.cell(series.label);
            table.cell(place(point.at));
            table.cell(point.value ? formatNumber(point.value->median) : std::string());
            table.cell(point.value ? formatNumber(point.value->q1) : std::string());
            table.cell(point.value ? formatNumber(point.value->q3) : std::string());
            table.cell(std::to_string(point.value ? point.value->count : 0));
            table.cell(std::to_string(point.solved));
            table.cell(std::to_string(point.runs));
            table.endRow();
        }
    for (const FigureBound &bound : figure.bounds)
    {
        table.cell(figure.boundLabel);
        table.cell(place(bound.at));
        table.cell(formatNumber(bound.value));
        for (int empty = 0; empty < 5; ++empty)
            table.cell("");
        table.endRow();
    }
    return table.text();
}

} // namespace mrpp
