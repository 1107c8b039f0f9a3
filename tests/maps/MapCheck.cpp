#include "tests/maps/MapCheck.h"

#include "algorithms/optimizers/RedundancyRemoval.h"
#include "algorithms/search/PathFinder.h"
#include "framework/analysis/BreadthFirstSearch.h"
#include "framework/analysis/LowerBounds.h"
#include "framework/evaluation/Validator.h"
#include "tests/support/CpuClock.h"

#include <algorithm>

namespace mrpp::test
{

std::vector<std::filesystem::path> mapsBelow(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> maps;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".map")
            maps.push_back(entry.path());
    std::sort(maps.begin(), maps.end());
    return maps;
}

double searchSeconds(const Graph &graph, Vertex source)
{
    BreadthFirstSearch search(graph);
    double fastest = 1e9;
    for (int i = 0; i < 10; ++i)
    {
        const double start = cpuSeconds();
        search.run(source);
        fastest = std::min(fastest, cpuSeconds() - start);
    }
    return fastest;
}

PlanningFigures measurePlanning(Planner &planner, std::shared_ptr<const Instance> instance, double limit)
{
    PlanningFigures figures;
    const double before = searchSeconds(*instance->graph, instance->starts.front());
    planner.setInstance(instance);
    const double begin = cpuSeconds();
    planner.setup();
    const double ready = cpuSeconds();
    figures.status = planner.solve(TerminationCondition::after(limit));
    const double end = cpuSeconds();
    const double unit = std::min(before, searchSeconds(*instance->graph, instance->starts.front()));
    figures.setupSearches = (ready - begin) / unit;
    figures.searches = (end - ready) / unit;
    const MotionRule rule = planner.specs().motion;
    const Solution optimized = RedundancyRemoval().improve(*instance, planner.takeSolution(), {});
    figures.complaint = figures.status == PlannerStatus::solved
                            ? validate(*instance, optimized, rule).violation
                            : planner.reason();
    figures.moves = optimized.pathLength();
    if (const auto bounds = lowerBounds(*instance); bounds && bounds->pathLength > 0)
        figures.ratio = static_cast<double>(figures.moves) / static_cast<double>(bounds->pathLength);
    return figures;
}

PathFigures measurePaths(const Instance &instance, double weight)
{
    PathFigures figures;
    const Landmarks landmarks(*instance.graph);
    PathFinder finder(*instance.graph, landmarks);
    if (weight > 0)
        finder.fixWeight(weight);
    BreadthFirstSearch search(*instance.graph);
    const double unit = searchSeconds(*instance.graph, instance.starts.front());
    double seconds = 0;
    for (Robot r = 0; r < instance.robotCount(); ++r)
    {
        const double start = cpuSeconds();
        const auto &path =
            finder.find(instance.starts[r], instance.goals[r], [](Vertex) { return PathFinder::kStep; });
        seconds += cpuSeconds() - start;
        search.run(instance.starts[r]);
        const std::uint32_t distance = search.distance(instance.goals[r]);
        figures.distance += distance;
        figures.length += path.size() - 1;
        figures.visits += finder.visits();
        figures.broken += static_cast<double>(path.size() - 1) > finder.weight() * distance ? 1U : 0U;
    }
    figures.searches = seconds / unit;
    return figures;
}

} // namespace mrpp::test
