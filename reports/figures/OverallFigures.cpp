#include "reports/figures/OverallFigures.h"

#include "framework/statistics/Friedman.h"
#include "framework/statistics/Quantiles.h"
#include "reports/picture/Picture.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace mrpp
{

namespace
{

/// Series of all planners that have runs, with how many instances there are and how many of them were solved.
template <class Fill>
std::vector<FigureSeries> seriesOf(const FigureList &figures, const CaseTable &cases, Fill &&fill)
{
    std::vector<FigureSeries> list;
    for (std::size_t p = 0; p < cases.planners.size(); ++p)
    {
        FigureSeries series;
        series.label = cases.planners[p];
        series.style = figures.styleOf(series.label);
        for (const Case &one : cases.cases)
        {
            series.runs += one.answers[p].isFinished() ? 1 : 0;
            series.solved += one.answers[p].solved() ? 1 : 0;
        }
        if (series.runs == 0)
            continue;
        fill(series, p);
        list.push_back(std::move(series));
    }
    return list;
}

std::vector<double> costsOf(const CaseTable &cases, std::size_t planner, std::string_view column)
{
    std::vector<double> costs;
    for (const Case &one : cases.cases)
        if (const auto cost = one.answers[planner].cost(column))
            costs.push_back(*cost);
    return costs;
}

std::string casesText(const CaseTable &cases)
{
    return counted(cases.cases.size(), "instance");
}

} // namespace

Figure cactusFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                    const std::string &where)
{
    const CaseTable solvable = cases.solvable();
    Figure figure;
    figure.kind = Figure::Kind::steps;
    figure.title = measureName(column) + " within which instances were solved" + where;
    figure.variable = "Instances solved, the easiest first";
    figure.logX = false;
    figure.measure = metricTitle(column);
    figure.series = seriesOf(figures, solvable,
                             [&](FigureSeries &series, std::size_t p)
                             { series.steps = cactus(costsOf(solvable, p, column)); });
    figure.caption = fmt::format(
        "Cactus plot of {}{} over the {} that have a solution: a point (x, y) says that the x instances that "
        "are easiest for that planner each needed at most y. Further right is better, lower is better; a "
        "curve ends at the number of instances that the planner solved, and the axis at the number of "
        "all.",
        spaced(column), where, casesText(solvable));
    return figure;
}

Figure profileFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                     const std::string &where)
{
    const CaseTable finished = cases.finished().solvable();
    std::vector<std::vector<std::optional<double>>> costs;
    for (const Case &one : finished.cases)
    {
        costs.emplace_back();
        for (const Answer &answer : one.answers)
            costs.back().push_back(answer.cost(column));
    }
    const bool isTime = column == "time";
    const auto profiles = performanceProfiles(costs, isTime ? kAlikeTimes : Alike());
    Figure figure;
    figure.kind = Figure::Kind::steps;
    figure.isPercentage = true;
    figure.title = "Performance profile of " + spaced(column) + where;
    figure.variable = measureName(column) + " over the best planner's";
    figure.xFrom = 1;
    figure.measure = "Instances (%)";
    figure.series =
        seriesOf(figures, finished, [&](FigureSeries &series, std::size_t p) { series.steps = profiles[p]; });
    constexpr double kWide = 5;
    for (const auto &profile : profiles)
        figure.logX = figure.logX.value_or(false) || (!profile.empty() && profile.back().x > kWide);
    figure.caption = fmt::format("Performance profile (Dolan and Moré) of {}{} over the {} that have a "
                                 "solution and that every planner has "
                                 "finished: the share of them on which a planner needs at most x times what "
                                 "the best planner of that instance "
                                 "needs. At x = 1: how often it is best{}; at the right edge: how often it "
                                 "solves at all. Failures are never "
                                 "below the curve.",
                                 spaced(column), where, casesText(finished),
                                 isTime ? ", or within a tenth or 0.1 ms of the best" : "");
    return figure;
}

Figure ecdfFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                  const std::string &where)
{
    Figure figure;
    figure.kind = Figure::Kind::steps;
    figure.isPercentage = true;
    figure.title = "Distribution of " + spaced(column) + where;
    figure.variable = metricTitle(column);
    figure.measure = "Instances (%)";
    const CaseTable solvable = cases.solvable();
    figure.series = seriesOf(figures, solvable,
                             [&](FigureSeries &series, std::size_t p)
                             { series.steps = ecdf(costsOf(solvable, p, column), series.runs); });
    figure.caption = fmt::format(
        "Empirical distribution of {}{} over the {} that have a solution: the share of them, failures "
        "included, that were solved with at most x. Each curve ends at the share that the planner "
        "solved.",
        spaced(column), where, casesText(solvable));
    return figure;
}

Figure boxesFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                   std::string_view bound, const std::string &where)
{
    const CommonCases common = commonCases(cases, column, bound);
    if (common.planners.empty())
        throw DrawingError(
            fmt::format("no boxes of {}{}: no two planners have solved {} of the same instances",
                        spaced(column), where, kLeastInCommon));
    Figure figure;
    figure.kind = Figure::Kind::boxes;
    const std::string over = bound.empty() ? "" : " over its lower bound";
    figure.title = measureName(column) + over + where;
    figure.measure = bound.empty() ? metricTitle(column) : measureName(column) + " / lower bound";
    for (const std::size_t p : common.planners)
    {
        FigureSeries &series = figure.series.emplace_back();
        series.label = cases.planners[p];
        series.style = figures.styleOf(series.label);
        for (const Case &one : cases.cases)
            series.runs += one.answers[p].counts() ? 1 : 0;
        for (const Case *one : common.cases)
        {
            const double least = bound.empty() ? 1 : *one->answers[p].cost(bound);
            series.sample.push_back(*one->answers[p].cost(column) / least);
        }
        series.solved = series.sample.size();
    }
    std::string leftOut;
    for (const std::size_t p : common.leftOut)
        leftOut += (leftOut.empty() ? "" : ", ") + oneLine(cases.name(p));
    if (!bound.empty())
        figure.bounds = {{0, 1}};
    figure.caption = fmt::format(
        "{}{}{} on the {} that all of these planners solved{}. Boxes: quartiles, their bar the median; "
        "whiskers: the "
        "farthest values within 1.5 quartile distances; markers: values beyond. In brackets: how many "
        "instances the box "
        "stands for, of how many that count for the planner.{}",
        measureName(column), over, where, counted(common.cases.size(), "instance"),
        leftOut.empty() ? "" : " (not shown, for having solved too few of the same: " + leftOut + ")",
        bound.empty() ? "" : " Dashed: the bound, which no solution can beat.");
    return figure;
}

Figure scatterFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                     std::size_t x, std::size_t y, const std::string &where)
{
    Figure figure;
    figure.kind = Figure::Kind::scatter;
    figure.measure = metricTitle(column);
    std::size_t xLess = 0;
    std::size_t yLess = 0;
    std::size_t equal = 0;
    std::size_t onlyX = 0;
    std::size_t onlyY = 0;
    std::size_t neither = 0;
    for (const Case &one : cases.cases)
    {
        const Answer &first = one.answers[x];
        const Answer &second = one.answers[y];
        if (!first.isFinished() || !second.isFinished() || (first.unsolvable() && second.unsolvable()))
            continue;
        FigurePair pair{first.cost(column), second.cost(column), one.any().caseId};
        if (pair.x && pair.y)
            ++(*pair.x < *pair.y ? xLess : *pair.y < *pair.x ? yLess : equal);
        else
            ++(pair.x ? onlyX : pair.y ? onlyY : neither);
        figure.pairs.push_back(std::move(pair));
    }
    for (const std::size_t planner : {x, y})
    {
        figure.series.emplace_back().label = cases.planners[planner];
        figure.series.back().style = figures.styleOf(cases.planners[planner]);
    }
    figure.title = fmt::format("{}: {} against {}", measureName(column), oneLine(cases.planners[y]),
                               oneLine(cases.planners[x]));
    const std::string first = oneLine(cases.name(x));
    const std::string second = oneLine(cases.name(y));
    figure.caption =
        fmt::format("{}{} on the same instances, {} against {}: above the diagonal {} needs less "
                    "({}), below it {} ({}); {} on it. "
                    "Crosses on the grey rim were not solved: {} only by {}, {} only by {}, {} by both.",
                    measureName(column), where, second, first, first, xLess, second, yLess, equal, onlyY,
                    first, onlyX, second, neither);
    return figure;
}

Figure ranksFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                   const std::string &where)
{
    std::vector<std::vector<double>> costs; // a row a point; no answer is worse than any
    for (const CaseTable &point : cases.finished().solvable().byPoint())
    {
        std::vector<double> row;
        for (std::size_t p = 0; p < cases.planners.size(); ++p)
        {
            std::vector<double> values;
            for (const Case &one : point.cases)
                values.push_back(one.answers[p].cost(column).value_or(kNoAnswer));
            row.push_back(median(std::move(values)));
        }
        costs.push_back(std::move(row));
    }
    const FriedmanTest test = friedmanTest(costs);
    if (!test.p)
        throw DrawingError("no critical-difference diagram of " + spaced(column) + where + ": " +
                           test.refusal);
    Figure figure;
    figure.kind = Figure::Kind::ranks;
    figure.title = "Mean ranks by " + spaced(column) + where;
    figure.measure = metricTitle(column);
    figure.criticalDifference = test.criticalDifference;
    std::vector<std::size_t> order(cases.planners.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return test.meanRanks[a] < test.meanRanks[b]; });
    for (const std::size_t p : order)
    {
        FigureSeries &series = figure.series.emplace_back();
        series.label = cases.planners[p];
        series.style = figures.styleOf(series.label);
        series.meanRank = test.meanRanks[p];
    }
    figure.groups = indistinguishable(test.meanRanks, test.criticalDifference);
    figure.caption = fmt::format(
        "Mean ranks of the planners by {}{} on {} points (1 is best; medians of each point's instances, no "
        "answer "
        "counting as worse than every solution). Friedman's test (Iman and Davenport) p {}: the planners {}. "
        "Bars join "
        "planners whose "
        "ranks lie within Nemenyi's critical difference of {:.2f} at level 0.05, so that they are not told "
        "apart.",
        spaced(column), where, test.problems, *test.p < 0.001 ? "< 0.001" : fmt::format("= {:.3f}", *test.p),
        *test.p < 0.05 ? "differ" : "are not shown to differ", test.criticalDifference);
    return figure;
}

void addOverallFigures(FigureList &figures, const CaseTable &cases)
{
    const auto hasSolved = [&](std::size_t p) { return !costsOf(cases, p, "time").empty(); };
    std::vector<std::size_t> solvers;
    for (std::size_t p = 0; p < cases.planners.size(); ++p)
        if (hasSolved(p))
            solvers.push_back(p);
    if (solvers.empty() || cases.cases.size() < 2)
        return;
    figures.add(cactusFigure(figures, cases, "time", ""), "overall-cactus-time");
    if (cases.planners.size() < 2)
        return;
    for (const char *column : {"path_length", "time"})
        if (!cases.finished().solvable().cases.empty())
            figures.add(profileFigure(figures, cases, column, ""), std::string("overall-profile-") + column);
    const auto orComplain = [&figures](auto &&make, const std::string &name)
    {
        try
        {
            figures.add(make(), name);
        }
        catch (const DrawingError &refusal)
        {
            figures.complain(refusal.what());
        }
    };
    orComplain([&] { return boxesFigure(figures, cases, "path_length", "path_length_lower_bound", ""); },
               "overall-boxes-path_length");
    constexpr std::size_t kAllPairs = 4; // of more planners only those with the first one
    constexpr std::size_t kMostPairs = 6;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < solvers.size(); ++i)
        for (std::size_t j = i + 1;
             j < solvers.size() && (i == 0 || solvers.size() <= kAllPairs) && pairs < kMostPairs;
             ++j, ++pairs)
            figures.add(scatterFigure(figures, cases, "path_length", solvers[i], solvers[j], ""),
                        fmt::format("overall-scatter-path_length-{}-{}", cases.planners[solvers[i]],
                                    cases.planners[solvers[j]]));
    if (cases.planners.size() < 3)
        return;
    for (const char *column : {"path_length", "time"})
        orComplain([&] { return ranksFigure(figures, cases, column, ""); },
                   std::string("overall-ranks-") + column);
}

} // namespace mrpp
