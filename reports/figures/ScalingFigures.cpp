#include "reports/figures/ScalingFigures.h"

#include "framework/statistics/ScalingFit.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace mrpp
{

namespace
{

constexpr std::string_view kVertices = "vertices";

/// The median over the runs that have it.
std::optional<double> sizeOf(const RunGroup &group, std::string_view column)
{
    std::vector<double> sizes;
    for (const RunRecord *run : group.runs)
        if (const auto size = numericValue(*run, column))
            sizes.push_back(*size);
    return sizes.empty() ? std::nullopt : std::optional(std::round(median(std::move(sizes))));
}

/// "∝ n^2.31 [2.2, 2.4]".
std::string lawText(const ScalingModel &model)
{
    const Interval rate = model.rateInterval();
    return model.law == ScalingLaw::power
               ? fmt::format(" ∝ n^{:.2f} [{:.2f}, {:.2f}]", model.rate, rate.low, rate.high)
               : fmt::format(" ∝ {:.4g}^n [{:.4g}, {:.4g}]", model.rate, rate.low, rate.high);
}

/// One sentence on how well the fit foretells; its rate is in the legend.
std::string verdict(const std::string &planner, const ScalingFit &fit)
{
    if (!fit.refusal.empty())
        return fmt::format(" {}: no fit, {}.", planner, fit.refusal);
    const ScalingModel &best = fit.better();
    const ScalingModel &other = best.law == ScalingLaw::power ? fit.exponential : fit.power;
    const char *name = best.law == ScalingLaw::power ? "power law" : "exponential law";
    const char *otherName = best.law == ScalingLaw::power ? "exponential" : "power law";
    std::string text = fmt::format(" {}: the {}, off by {:.2f} (the {} by {:.2f}), {} of {} within its band",
                                   planner, name, std::pow(10.0, best.heldOutError), otherName,
                                   std::pow(10.0, other.heldOutError), best.heldOutWithin, fit.heldOut);
    if (fit.leftOut > 0)
        text += fmt::format("; {} left out, where no more than half of the instances were solved",
                            counted(fit.leftOut, "size"));
    return text + ".";
}

} // namespace

bool growsGraph(const ProblemSummary &problem)
{
    std::set<double> sizes;
    for (const RunGroup &group : problem.groups)
        if (const auto size = sizeOf(group, kVertices))
            sizes.insert(*size);
    return problem.swept() && sizes.size() > 1 && *sizes.rbegin() >= 2 * *sizes.begin();
}

std::optional<Figure> scalingFigure(const FigureList &figures, const ProblemSummary &problem,
                                    std::string_view size, std::string_view column, std::string &refusal)
{
    constexpr std::size_t kFitPoints = 48;
    Figure figure;
    figure.variable = variableTitle(metricTitle(size));
    figure.measure = metricTitle(column);
    figure.logX = true;
    figure.logY = true;
    std::string verdicts;
    bool anything = false;
    for (const std::string &planner : figures.planners())
    {
        std::map<double, FigurePoint> points;
        std::map<double, std::vector<double>> values;
        for (const RunGroup &group : problem.groups)
        {
            const auto at = sizeOf(group, size);
            if (group.planner != planner || !at || *at <= 0)
                continue;
            for (const double value : group.costs(column))
                if (value > 0)
                    values[*at].push_back(value);
            FigurePoint &point = points[*at];
            point.at = *at;
            point.solved += group.solved();
            point.runs += group.counted();
        }
        if (points.empty())
            continue;
        FigureSeries series;
        series.label = planner;
        series.style = figures.styleOf(planner);
        std::vector<ScalingPoint> sizes;
        for (auto &[at, point] : points)
        {
            if (const auto own = values.find(at); own != values.end())
            {
                point.value = censoredQuartiles(own->second);
                sizes.push_back({at, own->second});
            }
            series.points.push_back(point);
        }
        const ScalingFit fit = fitScaling(sizes);
        verdicts += verdict(oneLine(planner), fit);
        if (fit.refusal.empty())
        {
            anything = true;
            const ScalingModel &model = fit.better();
            series.remark = lawText(model);
            std::erase_if(sizes,
                          [](const ScalingPoint &size) { return !std::isfinite(median(size.values)); });
            const double ratio = sizes.back().size / sizes.front().size;
            for (std::size_t i = 0; i < kFitPoints; ++i)
            {
                const double at =
                    sizes.front().size *
                    std::pow(ratio, static_cast<double>(i) / static_cast<double>(kFitPoints - 1));
                const Interval band = model.band(at);
                series.fit.push_back({at, model.at(at), band.low, band.high});
            }
            series.heldOutFrom = fit.splitAt;
        }
        else
            refusal = fit.refusal;
        figure.series.push_back(std::move(series));
    }
    if (!anything)
        return std::nullopt;
    figure.title = fmt::format("Scaling of {}{} on {}", spaced(column),
                               size == kVertices ? "" : " with " + spaced(size), oneLine(problem.problem));
    figure.caption = fmt::format("{} on {} ({}) against the {} n, both axes logarithmic. Markers and bars: "
                                 "median and quartiles of the instances "
                                 "at each size, those without an answer standing above all others, hollow "
                                 "where not every instance was solved, "
                                 "none where no more than half were; lines and bands: the better of a power "
                                 "law and an exponential law with its "
                                 "95 % bootstrap band, fitted to the sizes left of the dashed line in the "
                                 "planner's colour. By what factor it "
                                 "misses the larger sizes, typically:{}",
                                 measureName(column), oneLine(problem.problem), spaced(problem.model),
                                 size == kVertices ? "number of vertices" : spaced(size), verdicts);
    return figure;
}

void addScalingFigures(FigureList &figures, const std::vector<ProblemSummary> &problems)
{
    for (const ProblemSummary &problem : problems)
    {
        if (!growsGraph(problem))
            continue;
        for (const char *column : {"time", "path_length"})
        {
            std::string refusal;
            if (auto figure = scalingFigure(figures, problem, kVertices, column, refusal))
                figures.add(std::move(*figure), problem.model + "-" + problem.problem + "-scaling-" + column);
            else if (!refusal.empty())
                figures.complain(fmt::format("no scaling of {} on {}: {}", spaced(column),
                                             oneLine(problem.problem), refusal));
        }
    }
}

} // namespace mrpp
