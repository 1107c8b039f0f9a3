#include "framework/plan/Configuration.h"

#include "framework/plan/PlannerFactory.h"

namespace mrpp
{

namespace
{

/// Every parameter with its value, after the given ones are set.
std::vector<std::pair<std::string, std::string>> effectiveSettings(const ParameterSet &parameters,
                                                                   int version)
{
    std::vector<std::pair<std::string, std::string>> all = {{kVersionSetting, std::to_string(version)}};
    for (const ParameterSet::Parameter &parameter : parameters.all())
        all.emplace_back(parameter.name, parameter.value());
    return all;
}

} // namespace

void resolve(BenchmarkPlan &plan, const Catalog &catalog)
{
    for (Configured &planner : plan.planners)
    {
        const auto object = createPlanner(catalog, planner);
        planner.effective = effectiveSettings(object->parameters(), object->specs().version);
        planner.motion = object->specs().motion;
    }
    for (Configured &optimizer : plan.optimizers)
    {
        const auto object = create(catalog.optimizers, optimizer);
        optimizer.effective = effectiveSettings(object->parameters(), object->version());
    }
    for (ProblemPoint &point : plan.points)
        point.defaults = point.problem->defaults();
}

} // namespace mrpp
