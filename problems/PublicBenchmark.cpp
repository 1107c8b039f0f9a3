#include "problems/PublicBenchmark.h"

#include "framework/support/Error.h"
#include "problems/SolvableInstance.h"
#include "problems/WellFormedInstance.h"
#include "problems/formats/MovingAiScenario.h"

namespace mrpp
{

PublicBenchmark::PublicBenchmark()
{
    declareParam("map", map_, "", "a MovingAI map, from movingai.com/benchmarks");
    declareParam("scenario", scenario_, "", "starts and goals on the map; without it, random ones");
    declareParam("passability", passability_, passabilityNames(),
                 "which symbols of the map robots may stand on");
    declareParam("solvable", solvable_, "", "draw only random instances that have a solution");
    declareParam("well_formed", wellFormed_, "",
                 "draw only well-formed random instances: each robot has a path around all other starts "
                 "and goals");
}

void PublicBenchmark::configure(const Config &settings, const ProblemContext &context)
{
    Problem::configure(settings, context);
    if (map_.empty())
        throw PlanError(settings.where(), "public_benchmark needs a 'map', the file of a MovingAI map");
    map_ = context.resolve(map_);
    if (scenario_.empty())
        return;
    if (solvable_ || wellFormed_)
        throw PlanError(settings.where(), std::string("a scenario's instances are as they are; leave out '") +
                                              (solvable_ ? "solvable" : "well_formed") + "' or 'scenario'");
    scenario_ = context.resolve(scenario_);
}

namespace
{

void requireFile(const std::filesystem::path &file, const std::string &what)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        throw FileError({file.string()}, "there is no such " + what +
                                             "; maps and scenarios are published by their owner at "
                                             "https://movingai.com/benchmarks/ (mrppsim downloads nothing)");
}

} // namespace

GridMap PublicBenchmark::load() const
{
    requireFile(map_, "map");
    return readMovingAiMap(map_, passability(passability_));
}

void PublicBenchmark::check() const
{
    if (!scenario_.empty())
        requireFile(scenario_, "scenario");
    const auto graph = load().graph;
    const std::size_t robots = robotCount(*graph);
    // Whether a random instance can be drawn that is solvable or well-formed is a matter of its seed.
    static_cast<void>(scenario_.empty() ? randomInstance(graph, robots, 0) : makeInstance(graph, robots, 0));
}

std::vector<std::filesystem::path> PublicBenchmark::inputFiles() const
{
    return scenario_.empty() ? std::vector{map_} : std::vector{map_, scenario_};
}

std::shared_ptr<const Graph> PublicBenchmark::makeGraph(Seed) const
{
    return load().graph;
}

std::size_t PublicBenchmark::robotCount(const Graph &graph) const
{
    if (!robots() && !scenario_.empty())
        return readMovingAiScenario(scenario_).records.size();
    return Problem::robotCount(graph);
}

Instance PublicBenchmark::makeInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                       Seed seed) const
{
    if (wellFormed_)
        return wellFormedInstance(std::move(graph), robots, seed);
    if (solvable_)
        return solvableInstance(std::move(graph), robots, seed);
    if (scenario_.empty())
        return Problem::makeInstance(std::move(graph), robots, seed);
    Instance instance = scenarioInstance(readMovingAiScenario(scenario_), load(), robots);
    instance.graph = std::move(graph);
    return instance;
}

} // namespace mrpp
