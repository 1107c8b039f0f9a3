#include "reports/figures/AskedFigures.h"

#include "framework/evaluation/Metrics.h"
#include "framework/support/Config.h"
#include "reports/figures/OverallFigures.h"
#include "reports/figures/ScalingFigures.h"
#include "reports/picture/Picture.h"
#include "reports/summary/CaseTable.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace mrpp
{

namespace
{

bool concerns(const ChartRequest &chart, const RunRecord &run)
{
    return chart.problem.empty() || chart.problem == run.problem || chart.problem == run.model;
}

/// A column of the record, or the swept variable of that name.
std::optional<double> placeOf(const RunRecord &run, const std::string &column)
{
    if (const auto value = numericValue(run, column))
        return value;
    return run.sweepVariable == column ? run.sweepValue : std::nullopt;
}

/// What tells the curves of one planner apart.
std::string groupOf(const RunRecord &run, const std::string &column)
{
    if (column.empty() || column == "planner")
        return "";
    if (run.sweepVariable == column && run.sweepValue)
        return formatNumber(*run.sweepValue);
    const RunColumn *known = findRunColumn(column);
    const std::string text = known == nullptr ? std::string() : toText(known->get(run));
    return text.empty() ? "none" : text;
}

/// "Path length (moves)"; "Occupancy (robots per vertex)" of a column that is swept elsewhere.
std::string axisTitle(const std::string &column)
{
    return findMetric(column) != nullptr ? metricTitle(column) : variableTitle(column);
}

Figure curvesFigure(const FigureList &figures, const ResultTable &results, const ChartRequest &chart)
{
    std::size_t without = 0;
    std::vector<std::string>
        groups; // what tells one planner's curves apart, in the order of their first runs
    const auto placeOfRun = [&](const RunRecord &run) -> std::optional<RunPlace>
    {
        if (!concerns(chart, run))
            return std::nullopt;
        const auto at = placeOf(run, chart.x);
        without += at ? 0 : 1;
        if (!at)
            return std::nullopt;
        RunPlace place{"", groupOf(run, chart.per), chart.x, at};
        if (std::find(groups.begin(), groups.end(), place.problem) == groups.end())
            groups.push_back(place.problem);
        return place;
    };
    const std::vector<RunGroup> cells = groupRuns(results.records(), placeOfRun);
    std::map<std::pair<std::size_t, std::string>, std::map<double, const RunGroup *>>
        curves; // by planner, group
    for (const RunGroup &cell : cells)
        curves[{figures.styleOf(cell.planner), cell.problem}][*cell.sweepValue] = &cell;
    constexpr std::size_t kCurves = 24; // as many legends fit a page
    if (curves.size() > kCurves)
        throw DrawingError(
            fmt::format("{} curves are too many to tell apart (at most {}); name a problem, or a "
                        "column with fewer values",
                        curves.size(), kCurves));
    Figure figure;
    figure.variable = axisTitle(chart.x);
    figure.measure = axisTitle(chart.y);
    bool anything = false;
    for (const auto &[key, points] : curves)
    {
        const auto &[planner, group] = key;
        FigureSeries series;
        series.label = figures.planners()[planner];
        if (groups.size() > 1)
            series.label += fmt::format(", {} {}", spaced(chart.per), group);
        // Planner by planner the same style; groups have styles of their own behind the planners'.
        const auto position =
            static_cast<std::size_t>(std::find(groups.begin(), groups.end(), group) - groups.begin());
        series.style = groups.size() > 1 ? planner * groups.size() + position : planner;
        for (const auto &[at, cell] : points)
        {
            series.points.push_back({at, cell->cost(chart.y), cell->solved(), cell->counted()});
            anything = anything || series.points.back().value;
        }
        figure.series.push_back(std::move(series));
    }
    if (!anything)
        throw DrawingError("nowhere do more than half of the instances have both " + chart.x + " and " +
                           chart.y);
    const std::string where = chart.problem.empty() ? "" : " on " + oneLine(chart.problem);
    figure.title = fmt::format("{} against {}{}", measureName(chart.y), spaced(chart.x), where);
    figure.caption = fmt::format(
        "{} against {}{}{}. Lines: median over the same instances for all planners{}; bands: quartiles, of "
        "five "
        "instances or more. Hollow markers: not every instance was solved, the lower panel shows the share "
        "that was.{}",
        measureName(chart.y), spaced(chart.x), where,
        groups.size() > 1 ? fmt::format(", a curve for each planner and {}", spaced(chart.per)) : "",
        isCost(chart.y) ? ", no answer standing above all costs (none where no more than half were solved)"
                        : " that they solved",
        without == 0 ? ""
                     : fmt::format(" {} without {} left out.", counted(without, "run"), spaced(chart.x)));
    return figure;
}

Figure scalingOf(const FigureList &figures, const ResultTable &results, const ChartRequest &chart)
{
    for (const ProblemSummary &problem : summarizeProblems(results.records()))
    {
        if ((!chart.problem.empty() && chart.problem != problem.problem && chart.problem != problem.model) ||
            !growsGraph(problem))
            continue;
        std::string refusal;
        if (auto figure = scalingFigure(figures, problem, chart.x, chart.y, refusal))
            return std::move(*figure);
        throw DrawingError(refusal.empty() ? "nowhere were more than half of the instances solved" : refusal);
    }
    throw DrawingError("no sweep grows the graph");
}

std::size_t positionOf(const CaseTable &cases, const std::string &planner)
{
    return static_cast<std::size_t>(std::find(cases.planners.begin(), cases.planners.end(), planner) -
                                    cases.planners.begin());
}

Figure asked(const FigureList &figures, const ResultTable &results, const CaseTable &all,
             const ChartRequest &chart)
{
    if (chart.kind == "curves")
        return curvesFigure(figures, results, chart);
    if (chart.kind == "scaling")
        return scalingOf(figures, results, chart);
    CaseTable cases = all;
    std::erase_if(cases.cases, [&](const Case &one) { return !concerns(chart, one.any()); });
    if (cases.cases.empty())
        throw DrawingError("no run has finished");
    const std::string where = chart.problem.empty() ? "" : " on " + oneLine(chart.problem);
    if (chart.kind == "cactus")
        return cactusFigure(figures, cases, chart.y, where);
    if (chart.kind == "profile")
        return profileFigure(figures, cases, chart.y, where);
    if (chart.kind == "ecdf")
        return ecdfFigure(figures, cases, chart.y, where);
    if (chart.kind == "boxes")
        return boxesFigure(figures, cases, chart.y, "", where);
    if (chart.kind == "ranks")
        return ranksFigure(figures, cases, chart.y, where);
    return scatterFigure(figures, cases, chart.y, positionOf(cases, chart.planners.first),
                         positionOf(cases, chart.planners.second), where);
}

} // namespace

void addAskedFigures(FigureList &figures, const ResultTable &results)
{
    const std::vector<ChartRequest> &charts = results.plan().charts;
    if (charts.empty())
        return;
    const CaseTable cases = caseTable(results);
    for (const ChartRequest &chart : charts)
    {
        std::string name = "chart-" + chart.kind;
        for (const std::string &part : {chart.problem, chart.y, chart.x, chart.per})
            if (!part.empty())
                name += "-" + part;
        try
        {
            Figure figure = asked(figures, results, cases, chart);
            if (!chart.title.empty())
                figure.title = chart.title;
            if (chart.logX)
                figure.logX = chart.logX;
            if (chart.logY)
                figure.logY = chart.logY;
            figures.add(std::move(figure), name);
        }
        catch (const DrawingError &error)
        {
            figures.complain(oneLine(name + ": " + error.what()));
        }
    }
}

} // namespace mrpp
