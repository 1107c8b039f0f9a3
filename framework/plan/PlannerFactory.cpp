#include "framework/plan/PlannerFactory.h"

#include "framework/outside/CommandPlanner.h"
#include "framework/support/Error.h"

namespace mrpp
{

std::unique_ptr<Planner> createPlanner(const Catalog &catalog, const Configured &configured)
{
    if (configured.command && !catalog.files)
        throw InputError("outside planners need file formats, and none are registered here");
    std::unique_ptr<Planner> planner;
    if (configured.command)
        planner = std::make_unique<CommandPlanner>(*configured.command, catalog.files);
    else
        planner = catalog.planners.create(configured.kind);
    for (const auto &[name, value] : configured.settings)
        planner->parameters().set(name, value);
    return planner;
}

} // namespace mrpp
