#include "reports/drawing/CampaignLayouts.h"

#include "framework/support/Config.h"
#include "reports/Aggregate.h"
#include "reports/drawing/LayoutPicture.h"
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
        if (largest != smallest)
            add(largest);
    }
    return plans;
}

Layout drawLayout(const ResultTable &results, const LayoutPlan &plan)
{
    const std::optional<Instance> instance = results.instance(*plan.runs.front());
    if (!instance)
        throw DrawingError("its input files are gone, so the instance cannot be made again");

    std::optional<Solution> solution;
    std::string planner;
    for (const RunRecord *run : plan.runs)
    {
        if (!run->solved())
            continue;
        solution = results.solution(*run);
        planner = oneLine(run->planner);
        if (solution)
            break;
    }

    constexpr std::size_t kTitleCharacters = 60;
    const Graph &graph = *instance->graph;
    const std::string size =
        fmt::format("{}, {}, {}", counted(graph.vertexCount(), "vertex"), counted(graph.edgeCount(), "edge"),
                    counted(instance->robotCount(), "robot"));
    Layout layout;
    layout.picture = drawInstance(*instance, solution ? &*solution : nullptr,
                                  ellipsize(plan.title, kTitleCharacters) + "\n" + size);
    layout.caption = fmt::format(
        "{}: {}. {}", plan.title, size,
        !solution ? "No solution is kept."
                  : fmt::format("Routes: {}, {}.", planner, counted(solution->pathLength(), "move")));
    return layout;
}

} // namespace mrpp
