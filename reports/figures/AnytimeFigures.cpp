#include "reports/figures/AnytimeFigures.h"

#include "framework/support/Config.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace mrpp
{

namespace
{

/// One run's property over time.
using Curve = std::vector<std::pair<double, double>>;

/// The property at that time: what it was last seen at; nothing before it was seen.
std::optional<double> valueAt(const Curve &curve, double time)
{
    const auto after = std::upper_bound(curve.begin(), curve.end(), time,
                                        [](double t, const auto &sample) { return t < sample.first; });
    return after == curve.begin() ? std::nullopt : std::optional(std::prev(after)->second);
}

/// Of one planner at one point.
struct Watched
{
    std::vector<Curve> curves; // of the instances whose runs reported anything
    std::size_t instances = 0; // all
};

/// By property, then planner.
using Curves = std::map<std::string, std::map<std::string, Watched>>;

/// Of each instance the first run: those on copies of it would count it twice.
Curves curvesOf(const ResultTable &results, const ProblemSummary &problem)
{
    Curves curves;
    const auto last = problem.groups.back().sweepValue;
    for (const RunGroup &group : problem.groups)
    {
        if (group.sweepValue != last)
            continue;
        for (const Answer &answer : group.answers)
        {
            const Progress progress = results.progress(answer.first());
            for (std::size_t i = 0; i < progress.names.size(); ++i)
            {
                Curve curve;
                for (const Progress::Sample &sample : progress.samples)
                    if (std::isfinite(sample.values[i]))
                        curve.emplace_back(sample.time, sample.values[i]);
                if (!curve.empty())
                    curves[progress.names[i]][group.planner].curves.push_back(std::move(curve));
            }
        }
        for (auto &[property, planners] : curves)
            if (const auto own = planners.find(group.planner); own != planners.end())
                own->second.instances = group.answers.size();
    }
    return curves;
}

FigureSeries seriesOf(const Watched &watched, const std::vector<double> &times)
{
    FigureSeries series;
    for (const double time : times)
    {
        std::vector<double> values;
        for (const Curve &curve : watched.curves)
            if (const auto value = valueAt(curve, time))
                values.push_back(*value);
        const std::size_t reported = values.size();
        series.points.push_back({time, quartiles(std::move(values)), reported, watched.instances});
    }
    return series;
}

} // namespace

void addAnytimeFigures(FigureList &figures, const ResultTable &results,
                       const std::vector<ProblemSummary> &problems)
{
    constexpr std::size_t kTimes = 40;
    constexpr std::size_t kWatched = 3; // samples that the longest run has, at least
    for (const ProblemSummary &problem : problems)
        for (const auto &[property, planners] : curvesOf(results, problem))
        {
            double first = 0;
            double last = 0;
            double least = std::numeric_limits<double>::infinity();
            double greatest = -least;
            std::size_t most = 0;
            for (const auto &[planner, watched] : planners)
                for (const Curve &curve : watched.curves)
                {
                    first = first == 0 ? curve.front().first : std::min(first, curve.front().first);
                    last = std::max(last, curve.back().first);
                    most = std::max(most, curve.size());
                    for (const auto &[time, value] : curve)
                    {
                        least = std::min(least, value);
                        greatest = std::max(greatest, value);
                    }
                }
            if (most < kWatched || !(first > 0) || last <= first || least == greatest)
                continue;
            std::vector<double> times;
            for (std::size_t i = 0; i < kTimes; ++i)
                times.push_back(first * std::pow(last / first, static_cast<double>(i) / (kTimes - 1.0)));
            times.back() = last;
            Figure figure;
            figure.variable = "Time since the start of solve() (s)";
            figure.measure = variableTitle(property);
            figure.shareTitle = "Reported (%)";
            figure.countsSolved = false;
            figure.logX = true;
            for (const std::string &planner : figures.planners())
                if (const auto own = planners.find(planner); own != planners.end())
                {
                    figure.series.push_back(seriesOf(own->second, times));
                    figure.series.back().label = planner;
                    figure.series.back().style = figures.styleOf(planner);
                    figure.series.back().remark =
                        fmt::format(" ({})", counted(own->second.instances, "instance"));
                }
            const auto at = problem.groups.back().sweepValue;
            const std::string point =
                at ? fmt::format(" at {} = {}", spaced(problem.sweepVariable), formatNumber(*at)) : "";
            figure.title =
                fmt::format("{} over time on {}{}", variableTitle(property), oneLine(problem.problem), point);
            figure.caption = fmt::format(
                "The planners' own measure “{}” while they work on {} ({}){}. Lines: median over the "
                "instances "
                "whose runs had reported by then, finished ones staying at their last value; bands: "
                "quartiles, of five instances or more; lower panel: the share of all instances of the "
                "planner that had reported by then. Planners that never reported this measure are left "
                "out.",
                spaced(property), oneLine(problem.problem), spaced(problem.model), point);
            figures.add(std::move(figure), problem.model + "-" + problem.problem + "-anytime-" + property);
        }
}

} // namespace mrpp
