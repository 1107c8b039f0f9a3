#include "yaml/ChartList.h"

#include "framework/run/RunRecord.h"
#include "framework/support/Suggestion.h"

#include <algorithm>
#include <array>

namespace mrpp
{

namespace
{

constexpr std::array<std::string_view, 8> kKinds = {"curves", "cactus",  "profile", "ecdf",
                                                    "boxes",  "scatter", "ranks",   "scaling"};

/// \param wanted for the message \throws PlanError where `name` is not among the choices
void require(const Config &value, const std::string &wanted, const std::vector<std::string> &choices)
{
    if (std::find(choices.begin(), choices.end(), value.text()) == choices.end())
        throw PlanError(value.where(), "there is no " + wanted + " '" + value.text() + "'" +
                                           suggestion(value.text(), choices));
}

std::vector<std::string> columns(const BenchmarkPlan &plan, bool numeric, bool swept)
{
    std::vector<std::string> names;
    for (const RunColumn &column : runColumns())
        if (!numeric || column.type != RunColumn::Type::text)
            names.emplace_back(column.name);
    for (const ProblemPoint &point : plan.points)
        if (swept && !point.sweepVariable.empty())
            names.push_back(point.sweepVariable);
    return names;
}

const std::string &scalar(const Config::Entry &entry)
{
    if (!entry.value.isScalar() || entry.value.text().empty())
        throw PlanError(entry.where, "'" + entry.key + "' takes one value");
    return entry.value.text();
}

std::vector<std::string> plannerNames(const BenchmarkPlan &plan)
{
    std::vector<std::string> names;
    for (const Configured &planner : plan.planners)
        names.push_back(planner.name);
    return names;
}

void readLog(const Config::Entry &entry, ChartRequest &chart)
{
    chart.logX = false;
    chart.logY = false;
    const auto add = [&](const Config &axis)
    {
        require(axis, "axis", {"x", "y"});
        (axis.text() == "x" ? chart.logX : chart.logY) = true;
    };
    if (entry.value.isScalar())
        return add(entry.value);
    if (!entry.value.isList())
        throw PlanError(entry.where, "'log' takes axes: [x], [y], [x, y] or []");
    for (const Config &axis : entry.value.items())
        add(axis);
}

void readPlanners(const Config::Entry &entry, const BenchmarkPlan &plan, ChartRequest &chart)
{
    if (!entry.value.isList() || entry.value.items().size() != 2)
        throw PlanError(entry.where, "'planners' takes two of the plan's planners: [first, second]");
    for (const Config &name : entry.value.items())
        require(name, "planner of the plan", plannerNames(plan));
    chart.planners = {entry.value.items()[0].text(), entry.value.items()[1].text()};
}

} // namespace

ChartRequest readChart(const Config::Entry &entry, const BenchmarkPlan &plan)
{
    const std::vector<std::string> keys = {"kind", "x", "y", "per", "problem", "planners", "log", "title"};
    if (!entry.value.isMap())
        throw PlanError(entry.where,
                        "'chart' takes a map: {x: occupancy, y: path_length, per: robots, log: [y]}");
    ChartRequest chart;
    for (const Config::Entry &setting : entry.value.entries())
    {
        if (setting.key == "log")
            readLog(setting, chart);
        else if (setting.key == "planners")
            readPlanners(setting, plan, chart);
        else if (setting.key == "kind")
        {
            chart.kind = scalar(setting);
            require(setting.value, "kind of chart", {kKinds.begin(), kKinds.end()});
        }
        else if (setting.key == "x" || setting.key == "y")
        {
            (setting.key == "x" ? chart.x : chart.y) = scalar(setting);
            require(setting.value, setting.key == "x" ? "numeric column or swept variable" : "numeric column",
                    columns(plan, true, setting.key == "x"));
        }
        else if (setting.key == "per")
        {
            chart.per = scalar(setting);
            require(setting.value, "column", columns(plan, false, true));
        }
        else if (setting.key == "problem")
        {
            chart.problem = scalar(setting);
            std::vector<std::string> names;
            for (const ProblemPoint &point : plan.points)
                names.insert(names.end(), {point.name, point.model});
            require(setting.value, "problem of the plan", names);
        }
        else if (setting.key == "title")
            chart.title = scalar(setting);
        else
            throw PlanError(setting.where,
                            "unknown key '" + setting.key + "' in a chart" + suggestion(setting.key, keys));
    }
    const auto demand = [&](bool met, const std::string &what)
    {
        if (!met)
            throw PlanError(entry.value.where(), "a chart of the kind '" + chart.kind + "' needs " + what);
    };
    demand(!chart.y.empty(), "'y', the numeric column that it shows");
    demand(chart.kind != "curves" || !chart.x.empty(),
           "'x', the column or swept variable to show it against");
    if (chart.kind == "scaling" && chart.x.empty())
        chart.x = "vertices";
    demand(chart.kind == "curves" || chart.kind == "scaling" || chart.x.empty(), "no 'x'");
    demand(chart.kind == "curves" || chart.per.empty(), "no 'per'");
    if (chart.kind == "scatter" && chart.planners.first.empty())
    {
        demand(plan.planners.size() >= 2, "two planners");
        chart.planners = {plan.planners[0].name, plan.planners[1].name};
    }
    return chart;
}

} // namespace mrpp
