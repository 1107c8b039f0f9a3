#include "reports/drawing/CampaignLayouts.h"

#include "framework/support/Config.h"
#include "reports/Aggregate.h"
#include "reports/drawing/FramesPicture.h"
#include "reports/drawing/LayoutPicture.h"
#include "reports/drawing/StructurePicture.h"
#include "reports/drawing/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace mrpp
{

namespace
{

/// The runs of the sweep point's first case.
LayoutPlan planFor(const ProblemSummary &problem, std::optional<double> sweepValue)
{
    LayoutPlan plan;
    plan.title = oneLine(problem.problem);
    if (sweepValue)
        plan.title += fmt::format(", {} = {}", spaced(problem.sweepVariable), formatNumber(*sweepValue));
    for (const RunGroup &group : problem.groups)
        if (group.sweepValue == sweepValue)
            for (const RunRecord *run : group.runs)
                if (plan.runs.empty() || run->caseId == plan.runs.front()->caseId)
                    plan.runs.push_back(run);
    return plan;
}

struct KeptSolution
{
    std::optional<Solution> solution;
    std::string planner;
};

KeptSolution firstKept(const ResultTable &results, const LayoutPlan &plan)
{
    for (const RunRecord *run : plan.runs)
        if (run->solved())
            if (std::optional<Solution> solution = results.solution(*run))
                return {std::move(solution), oneLine(run->planner)};
    return {};
}

} // namespace

std::vector<LayoutPlan> plannedLayouts(const ResultTable &results)
{
    FileNames names;
    std::vector<LayoutPlan> plans;
    for (const ProblemSummary &problem : summarizeProblems(results.records()))
    {
        const auto add = [&](std::optional<double> sweepValue)
        {
            plans.push_back(planFor(problem, sweepValue));
            std::string name = problem.model + "-" + problem.problem;
            if (sweepValue)
                name += "-" + problem.sweepVariable + "-" + formatNumber(*sweepValue);
            plans.back().name = names.add(name);
        };
        const auto smallest = problem.groups.front().sweepValue;
        const auto largest = problem.groups.back().sweepValue;
        add(smallest);
        if (largest == smallest)
            continue;
        add(largest);
        const RunRecord &first = *plans[plans.size() - 2].runs.front();
        const RunRecord &last = *plans.back().runs.front();
        plans.back().showsStructure =
            first.graphSeed != last.graphSeed || first.vertices != last.vertices || first.edges != last.edges;
    }
    return plans;
}

std::vector<Layout> drawLayouts(const ResultTable &results, const LayoutPlan &plan)
{
    std::vector<Layout> layouts;
    const auto add = [&](const std::string &suffix, const std::string &caption, auto &&draw)
    {
        Layout layout{plan.name + suffix, {}, {}, caption};
        try
        {
            layout.picture = draw(layout.caption);
        }
        catch (const DrawingError &error)
        {
            layout.missing = error.what();
        }
        layouts.push_back(std::move(layout));
    };
    const auto addMissing = [&](const std::string &reason)
    { add("", plan.title + ".", [&](std::string &) -> Picture { throw DrawingError(reason); }); };

    const std::optional<Instance> instance = results.instance(*plan.runs.front());
    if (!instance)
    {
        addMissing("its input files are gone, so the instance cannot be made again");
        return layouts;
    }
    const Graph &graph = *instance->graph;
    Placement placement;
    try
    {
        placement = placeGraph(graph);
    }
    catch (const DrawingError &error)
    {
        addMissing(error.what());
        return layouts;
    }
    const KeptSolution kept = firstKept(results, plan);
    const Solution *solution = kept.solution ? &*kept.solution : nullptr;

    constexpr std::size_t kTitleCharacters = 60;
    const std::string shortTitle = ellipsize(plan.title, kTitleCharacters);
    const std::string graphSize =
        counted(graph.vertexCount(), "vertex") + ", " + counted(graph.edgeCount(), "edge");
    const std::string size = graphSize + ", " + counted(instance->robotCount(), "robot");
    add("",
        fmt::format("{}: {}. {}", plan.title, size,
                    solution == nullptr ? "No solution is kept."
                                        : fmt::format("Routes: {}, {}.", kept.planner,
                                                      counted(solution->pathLength(), "move"))),
        [&](std::string &)
        { return drawInstance(*instance, solution, placement, shortTitle + "\n" + size); });
    if (plan.showsStructure && graph.vertexCount() <= kLargestGraph)
        add("-structure", fmt::format("{}: structure of its graph.", plan.title),
            [&](std::string &caption)
            {
                StructurePicture drawn =
                    drawStructure(graph, placement, shortTitle + "\nstructure: " + graphSize);
                caption = fmt::format("{}: structure of its graph of {}: {}.", plan.title, graphSize,
                                      describe(drawn.parts));
                return std::move(drawn.picture);
            });
    if (solution != nullptr && !solution->empty())
        add("-steps",
            fmt::format("{}: where the robots stand at key steps of the solution of {}, condensed.",
                        plan.title, kept.planner),
            [&](std::string &)
            { return drawFrames(*instance, *solution, placement, shortTitle + ", " + kept.planner); });
    return layouts;
}

} // namespace mrpp
