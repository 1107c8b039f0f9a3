#include "problems/FullyControlled.h"

#include "framework/support/Error.h"
#include "problems/formats/Formats.h"

namespace mrpp
{

FullyControlled::FullyControlled()
{
    declareParam("instance", instance_, "", "starts and goals: instance text or a MovingAI scenario");
    declareParam("graph", graph_, "",
                 "GraphML or a MovingAI map; without it, the one that the instance names");
    declareParam("passability", passability_, passabilityNames(),
                 "which symbols of a MovingAI map robots may stand on");
}

void FullyControlled::configure(const Config &settings, const ProblemContext &context)
{
    Problem::configure(settings, context);
    if (instance_.empty())
        throw PlanError(settings.where(),
                        "fully_controlled needs an 'instance', the file of starts and goals");
    instance_ = context.resolve(instance_);
    if (!graph_.empty())
        graph_ = context.resolve(graph_);
}

Instance FullyControlled::load() const
{
    InstanceSource source{instance_, std::nullopt, std::nullopt, passability_};
    if (!graph_.empty())
        source.graph = graph_;
    return loadInstance(source).instance;
}

void FullyControlled::check() const
{
    static_cast<void>(load());
}

std::vector<std::filesystem::path> FullyControlled::inputFiles() const
{
    if (!graph_.empty())
        return {graph_, instance_};
    std::error_code error;
    if (std::filesystem::exists(instance_, error))
        if (const auto graph = graphFileOf(instance_))
            return {*graph, instance_};
    return {instance_};
}

std::shared_ptr<const Graph> FullyControlled::makeGraph(Seed) const
{
    return load().graph;
}

std::size_t FullyControlled::robotCount(const Graph &) const
{
    return load().robotCount();
}

Instance FullyControlled::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed) const
{
    Instance instance = load();
    if (robots > instance.robotCount())
        throw InputError({instance_.string()}, "there are " + std::to_string(instance.robotCount()) +
                                                   " robots, fewer than the " + std::to_string(robots) +
                                                   " asked for");
    instance.graph = std::move(graph);
    instance.starts.resize(robots);
    instance.goals.resize(robots);
    return instance;
}

} // namespace mrpp
