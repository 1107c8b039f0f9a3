#include "reports/figures/CampaignFigures.h"

#include "framework/support/Config.h"
#include "reports/figures/AnytimeFigures.h"
#include "reports/figures/AskedFigures.h"
#include "reports/figures/FigureList.h"
#include "reports/figures/OverallFigures.h"
#include "reports/figures/ScalingFigures.h"
#include "reports/summary/Titles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <set>

namespace mrpp
{

namespace
{

struct Measure
{
    const char *column;
    const char *bound; ///< column of what no planner can beat, or nothing
    const char *of;    ///< for captions
};

constexpr std::array<Measure, 5> kMeasures = {{
    {"path_length", "path_length_lower_bound", "number of moves of the solutions as the planners gave them"},
    {"optimized_path_length", "path_length_lower_bound", "number of moves after the optimizers"},
    {"makespan", "makespan_lower_bound", "number of parallel steps of the condensed solutions"},
    {"optimized_makespan", "makespan_lower_bound",
     "number of parallel steps of the optimized and condensed solutions"},
    {"time", nullptr, "wall time of solve() alone"},
}};

/// What a bound is, for captions.
const char *boundMeaning(const Measure &measure)
{
    return std::string_view(measure.bound) == "makespan_lower_bound" ? "the longest of the shortest paths"
                                                                     : "the sum of the shortest paths";
}

/// "10 instances", or "8 to 10 instances" where points differ.
std::string instancesAPoint(const std::vector<const RunGroup *> &groups)
{
    const auto bySize = [](const RunGroup *a, const RunGroup *b)
    { return a->answers.size() < b->answers.size(); };
    const auto [least, most] = std::minmax_element(groups.begin(), groups.end(), bySize);
    const std::string instances = counted((*most)->answers.size(), "instance");
    return (*least)->answers.size() == (*most)->answers.size()
               ? instances
               : fmt::format("{} to {}", (*least)->answers.size(), instances);
}

bool hasFailures(const std::vector<const RunGroup *> &groups)
{
    return std::any_of(groups.begin(), groups.end(),
                       [](const RunGroup *group) { return group->solved() < group->counted(); });
}

/// What a median is over, for captions.
constexpr const char *kOver =
    "median over the same instances for all planners, no answer standing above all costs "
    "(none where no more than half were solved)";

/// A sentence where instances do not count for success.
std::string uncounted(const std::vector<const RunGroup *> &groups)
{
    return std::any_of(groups.begin(), groups.end(),
                       [](const RunGroup *group) { return group->counted() < group->answers.size(); })
               ? " Instances without a solution under a planner's motion rule, and those to which it does "
                 "not apply, do "
                 "not count."
               : "";
}

/// The median of a bound over the instances that costs are over.
std::optional<double> medianBound(const std::vector<const RunGroup *> &groups, std::string_view column)
{
    std::vector<double> values;
    for (const RunGroup *group : groups)
        for (std::size_t i = 0; i < group->answers.size(); ++i)
            if (const auto value = numericValue(group->answers[i].first(), column);
                value && group->isCompared[i] != 0)
                values.push_back(*value);
    const auto summary = quartiles(std::move(values));
    return summary ? std::optional(summary->median) : std::nullopt;
}

/// Groups that stand at the same place of a figure: one sweep point, or one row.
struct Place
{
    double at = 0;
    std::vector<const RunGroup *> groups;
};

/// Figures of each problem.
class Builder
{
public:
    Builder(FigureList &list, const std::vector<ProblemSummary> &problems) : list_(list), problems_(problems)
    {}

    void build()
    {
        std::vector<std::string> models;
        std::map<std::string, std::vector<const ProblemSummary *>> unswept;
        for (const ProblemSummary &problem : problems_)
        {
            if (isCurve(problem))
            {
                addCurves(problem);
                continue;
            }
            if (unswept[problem.model].empty())
                models.push_back(problem.model);
            unswept[problem.model].push_back(&problem);
        }
        for (const std::string &model : models)
            addComparisons(model, unswept[model]);
    }

private:
    FigureList &list_;
    const std::vector<ProblemSummary> &problems_;

    /// A sweep of one point is compared, not drawn as a curve.
    static bool isCurve(const ProblemSummary &problem)
    {
        return problem.swept() && problem.groups.front().sweepValue != problem.groups.back().sweepValue;
    }

    /// One series for each planner that has runs at these places.
    template <class Value>
    std::vector<FigureSeries> makeSeries(const std::vector<Place> &places, Value &&value) const
    {
        std::vector<FigureSeries> series;
        for (const std::string &planner : list_.planners())
        {
            FigureSeries curve;
            curve.label = planner;
            curve.style = list_.styleOf(planner);
            for (const Place &place : places)
                for (const RunGroup *group : place.groups)
                    if (group->planner == planner)
                        curve.points.push_back({place.at, value(*group), group->solved(), group->counted()});
            if (!curve.points.empty())
                series.push_back(std::move(curve));
        }
        return series;
    }

    /// Fills in series and bounds; false where no planner has a value.
    bool fill(Figure &figure, const std::vector<Place> &places, const Measure &measure) const
    {
        figure.measure = metricTitle(measure.column);
        figure.series = makeSeries(places, [&](const RunGroup &group) { return group.cost(measure.column); });
        const auto hasValue = [](const FigurePoint &point) { return point.value.has_value(); };
        if (std::none_of(figure.series.begin(), figure.series.end(),
                         [&](const FigureSeries &series)
                         { return std::any_of(series.points.begin(), series.points.end(), hasValue); }))
            return false;
        if (measure.bound == nullptr)
            return true;
        for (const Place &place : places)
            if (const auto bound = medianBound(place.groups, measure.bound))
                figure.bounds.push_back({place.at, *bound});
        if (!figure.bounds.empty())
            figure.boundLabel = "lower bound";
        return true;
    }

    void addCurves(const ProblemSummary &problem)
    {
        std::vector<Place> places;
        std::vector<const RunGroup *> groups;
        for (const RunGroup &group : problem.groups)
        {
            const double at = group.sweepValue.value_or(0);
            if (places.empty() || places.back().at != at)
                places.push_back({at, {}});
            places.back().groups.push_back(&group);
            groups.push_back(&group);
        }
        const std::string prefix = problem.model + "-" + problem.problem + "-" +
                                   (problem.sweepVariable == "robots" ? "" : problem.sweepVariable + "-");
        const std::string where = fmt::format("{} ({}) against {}", oneLine(problem.problem),
                                              spaced(problem.model), spaced(problem.sweepVariable));
        bool anything = false;
        for (const Measure &measure : kMeasures)
        {
            Figure figure;
            figure.kind = Figure::Kind::curves;
            figure.variable = variableTitle(problem.sweepVariable);
            if (!fill(figure, places, measure))
                continue;
            anything = true;
            figure.subject = where;
            figure.title = measureName(measure.column) + " on " + oneLine(problem.problem);
            figure.caption = fmt::format(
                "{} on {}: {}. Lines: {}; bands: quartiles, of five instances or more; {} at each point.{}{}",
                measureName(measure.column), where, measure.of, kOver, instancesAPoint(groups),
                hasFailures(groups)
                    ? " Hollow markers: not every instance was solved, the lower panel shows the share "
                      "that was."
                    : "",
                figure.bounds.empty()
                    ? std::string()
                    : fmt::format(" Dotted grey: lower bound, {} (median over the same instances).",
                                  boundMeaning(measure)));
            list_.add(std::move(figure), prefix + measure.column);
        }
        if (!anything)
            list_.complain(fmt::format("{}: nowhere were more than half of the instances solved, so there is "
                                       "no figure but that of success",
                                       oneLine(problem.problem)));

        Figure success;
        success.kind = Figure::Kind::curves;
        success.isPercentage = true;
        success.subject = where;
        success.title = "Success rate on " + oneLine(problem.problem);
        success.caption = fmt::format(
            "Success rate on {}: share of the instances that were solved within the limits; {} at each "
            "point.{}",
            where, instancesAPoint(groups), uncounted(groups));
        success.variable = variableTitle(problem.sweepVariable);
        success.measure = "Instances solved (%)";
        success.series =
            makeSeries(places,
                       [](const RunGroup &group)
                       {
                           const auto rate = group.successRate();
                           const double percent = 100 * rate.value_or(0);
                           return rate ? std::optional(Quartiles{percent, percent, percent, group.counted()})
                                       : std::nullopt;
                       });
        list_.add(std::move(success), prefix + "success_rate");
    }

    void addComparisons(const std::string &model, const std::vector<const ProblemSummary *> &problems)
    {
        constexpr std::size_t kRowsAtMost = 36;
        const std::size_t parts = (problems.size() + kRowsAtMost - 1) / kRowsAtMost;
        for (std::size_t part = 0; part < parts; ++part)
        {
            const std::size_t first = problems.size() * part / parts;
            const std::size_t last = problems.size() * (part + 1) / parts;
            addComparison(model, {problems.begin() + static_cast<std::ptrdiff_t>(first),
                                  problems.begin() + static_cast<std::ptrdiff_t>(last)});
        }
    }

    void addComparison(const std::string &model, const std::vector<const ProblemSummary *> &problems)
    {
        std::vector<Place> places;
        std::vector<std::string> rows;
        std::vector<const RunGroup *> groups;
        for (const ProblemSummary *problem : problems)
        {
            places.push_back({static_cast<double>(rows.size()), {}});
            for (const RunGroup &group : problem->groups)
                places.back().groups.push_back(&group);
            groups.insert(groups.end(), places.back().groups.begin(), places.back().groups.end());
            const auto sweepValue = problem->groups.front().sweepValue;
            rows.push_back(oneLine(problem->problem) +
                           (sweepValue ? fmt::format(", {} {}", formatNumber(*sweepValue),
                                                     spaced(problem->sweepVariable))
                                       : ""));
        }
        bool anything = false;
        for (const Measure &measure : kMeasures)
        {
            Figure figure;
            figure.kind = Figure::Kind::comparison;
            if (!fill(figure, places, measure))
                continue;
            anything = true;
            figure.rows = rows;
            figure.subject = spaced(model);
            figure.title = measureName(measure.column) + ", " + spaced(model) + " problems";
            figure.caption = fmt::format(
                "{} on the {} problems: {}. Markers: {}; bars: quartiles, of five instances or more; {} for "
                "each problem "
                "and planner.{}{}",
                measureName(measure.column), spaced(model), measure.of, kOver, instancesAPoint(groups),
                hasFailures(groups)
                    ? " Hollow markers: not every instance was solved, the panel on the right shows the "
                      "share that was."
                    : "",
                figure.bounds.empty()
                    ? std::string()
                    : fmt::format(" Upright strokes: lower bound, {}.", boundMeaning(measure)));
            list_.add(std::move(figure), model + "-" + measure.column);
        }
        if (!anything)
            list_.complain(fmt::format(
                "{}: nowhere were more than half of the instances solved, so there is nothing to compare",
                spaced(model)));
    }
};

} // namespace

FigureList::FigureList(const ResultTable &results)
{
    bool differ = false;
    for (const Configured &planner : results.plan().planners)
    {
        planners_.push_back(planner.name);
        differ = differ || planner.motion != results.plan().planners.front().motion;
        rules_ += (rules_.empty() ? " Motion rules: " : ", ") +
                  oneLine(withRule(planner.name, toString(planner.motion)));
    }
    rules_ = differ ? rules_ + "." : "";
}

std::size_t FigureList::styleOf(const std::string &planner) const
{
    return static_cast<std::size_t>(std::find(planners_.begin(), planners_.end(), planner) -
                                    planners_.begin());
}

void FigureList::add(Figure figure, const std::string &title)
{
    figure.name = names_.add(title);
    figure.caption += rules_;
    result_.figures.push_back(std::move(figure));
}

CampaignFigures campaignFigures(const ResultTable &results)
{
    FigureList figures(results);
    addAskedFigures(figures, results);
    if (!results.plan().automaticCharts)
        return figures.take();
    const std::vector<ProblemSummary> problems = summarizeProblems(results.records());
    Builder(figures, problems).build();
    addOverallFigures(figures, caseTable(results));
    addScalingFigures(figures, problems);
    addAnytimeFigures(figures, results, problems);
    return figures.take();
}

} // namespace mrpp
