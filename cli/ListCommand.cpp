#include "cli/Commands.h"
#include "framework/evaluation/Metrics.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace mrpp
{

namespace
{

using Json = nlohmann::ordered_json;

Json toJson(const ParameterSet &parameters)
{
    Json list = Json::array();
    for (const ParameterSet::Parameter &parameter : parameters.all())
        list.push_back({{"name", parameter.name},
                        {"type", std::string(parameter.type())},
                        {"range", parameter.range},
                        {"default", parameter.defaultValue},
                        {"help", parameter.help}});
    return list;
}

/// Name and description of everything in a registry, with what `more` adds from an object of each kind.
template <class T, class More>
Json toJson(const Registry<T> &registry, More more)
{
    Json list = Json::array();
    for (const auto &entry : registry.entries())
    {
        Json item = {{"name", entry.name}, {"description", entry.description}};
        more(item, *entry.make());
        list.push_back(std::move(item));
    }
    return list;
}

Json planners(const Catalog &catalog)
{
    return toJson(catalog.planners,
                  [](Json &item, const Planner &planner)
                  {
                      item["citation"] = planner.specs().citation;
                      item["motion"] = std::string(toString(planner.specs().motion));
                      item["complete_for"] = planner.specs().completeFor;
                      item["complete"] = planner.specs().complete;
                      item["proves_infeasibility"] = planner.specs().provesInfeasibility;
                      item["parameters"] = toJson(planner.parameters());
                  });
}

Json optimizers(const Catalog &catalog)
{
    return toJson(catalog.optimizers, [](Json &item, const Optimizer &optimizer)
                  { item["parameters"] = toJson(optimizer.parameters()); });
}

Json problems(const Catalog &catalog)
{
    return toJson(catalog.problems,
                  [](Json &item, const Problem &problem)
                  {
                      item["takes_robot_count"] = problem.takesRobotCount();
                      item["parameters"] = toJson(problem.parameters());
                  });
}

Json metricsJson(const Catalog &catalog)
{
    Json list = Json::array();
    for (const Metric &metric : metrics())
        list.push_back({{"name", std::string(metric.name)},
                        {"description", std::string(metric.description)},
                        {"title", std::string(metric.title)},
                        {"unit", std::string(metric.unit)},
                        {"better", metric.better == Metric::Better::lower ? "lower" : "higher"}});
    for (const AddedMetric &metric : catalog.metrics)
        list.push_back({{"name", metric.name},
                        {"description", metric.description},
                        {"title", metric.title},
                        {"unit", metric.unit},
                        {"better", metric.higherIsBetter ? "higher" : "lower"}});
    return list;
}

Json formats(const Catalog &catalog)
{
    Json list = Json::array();
    for (const FileFormat &format : catalog.formats)
        list.push_back({{"name", format.name},
                        {"description", format.description},
                        {"extensions", format.extensions},
                        {"holds", format.holds},
                        {"reads", format.reads},
                        {"writes", format.writes}});
    return list;
}

std::string text(const Json &value)
{
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// A key of the JSON for people: "complete for".
std::string spoken(std::string key)
{
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

/// The same as text: a name, its description, and a line for each thing that is known about it.
void print(const Json &list)
{
    for (const Json &item : list)
    {
        std::cout << item["name"].get<std::string>() << "\n    " << item["description"].get<std::string>()
                  << '\n';
        for (const auto &[key, value] : item.items())
        {
            if (key == "name" || key == "description" || text(value).empty())
                continue;
            if (key != "parameters")
            {
                std::cout << "    " << spoken(key) << ": " << text(value) << '\n';
                continue;
            }
            for (const Json &parameter : value)
            {
                std::cout << "    " << text(parameter["name"]) << " (" << text(parameter["type"]);
                if (!text(parameter["range"]).empty())
                    std::cout << " " << text(parameter["range"]);
                if (!text(parameter["default"]).empty())
                    std::cout << ", default " << text(parameter["default"]);
                std::cout << "): " << text(parameter["help"]) << '\n';
            }
        }
    }
}

Json collect(const std::string &what, const Catalog &catalog)
{
    if (what == "planners")
        return planners(catalog);
    if (what == "optimizers")
        return optimizers(catalog);
    if (what == "problems")
        return problems(catalog);
    if (what == "reports")
        return toJson(catalog.reports, [](Json &, const Report &) {});
    if (what == "metrics")
        return metricsJson(catalog);
    return formats(catalog);
}

} // namespace

ExitCode list(const ListArguments &arguments, const Catalog &catalog)
{
    const Json items = collect(arguments.what, catalog);
    if (arguments.json)
        std::cout << items.dump(2) << '\n';
    else
        print(items);
    return ExitCode::done;
}

} // namespace mrpp
