#include "framework/campaign/InProcessExecutor.h"

#include "framework/support/Error.h"

namespace mrpp
{

InProcessExecutor::InProcessExecutor(const BenchmarkPlan &plan, const Catalog &catalog, std::int64_t jobs,
                                     PreRunEvent preRun)
    : plan_(plan), catalog_(catalog), jobs_(jobs), preRun_(std::move(preRun)),
      graphs_(static_cast<std::size_t>(jobs) + 1), instances_(static_cast<std::size_t>(jobs) + 1)
{}

RunResult InProcessExecutor::execute(const RunSpec &spec, const std::stop_token &stop)
{
    std::shared_ptr<const PreparedInstance> prepared;
    try
    {
        prepared = instance(spec);
    }
    catch (const DoesNotFit &error)
    {
        RunResult none;
        none.record.status = PlannerStatus::unsupported;
        none.record.reason = std::string("there is no such instance: ") + error.what();
        fillIdentity(none.record, plan_, spec);
        return none;
    }
    std::vector<NamedOptimizer> optimizers;
    for (const Configured &optimizer : plan_.optimizers)
        optimizers.push_back({optimizer.name, create(catalog_.optimizers, optimizer)});

    const auto planner = create(catalog_.planners, plan_.planners[spec.planner]);
    planner->setSeed(spec.plannerSeed);
    if (preRun_)
        preRun_(*planner, spec);

    RunSettings settings;
    settings.limits = plan_.limits;
    settings.motion = plan_.motion;
    settings.measureMemory = jobs_ == 1;
    settings.onPhase = onPhase_;
    RunResult result = runPlanner(*planner, *prepared, optimizers, settings, stop);
    fillIdentity(result.record, plan_, spec);
    return result;
}

std::shared_ptr<const Graph> InProcessExecutor::graph(const RunSpec &spec)
{
    const ProblemPoint &point = plan_.points[spec.point];
    // All points of a sweep over robots share the graph.
    const std::string key =
        point.model + '\n' + point.problem->identity() + '\n' + std::to_string(spec.graphSeed);
    return graphs_.get(key, [&] { return point.problem->makeGraph(spec.graphSeed); });
}

std::shared_ptr<const PreparedInstance> InProcessExecutor::instance(const RunSpec &spec)
{
    const auto make = [&]
    {
        auto made = mrpp::makeInstance(*plan_.points[spec.point].problem, graph(spec), spec.instanceSeed);
        return std::make_shared<const PreparedInstance>(
            prepare(std::make_shared<const Instance>(std::move(made))));
    };
    return instances_.get(spec.caseId, make);
}

} // namespace mrpp
