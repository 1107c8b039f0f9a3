#include "reports/layouts/CampaignLayouts.h"

#include "framework/store/Provenance.h"
#include "framework/support/Config.h"
#include "framework/support/Error.h"
#include "framework/support/Fingerprint.h"
#include "framework/system/File.h"
#include "reports/layouts/FramesPicture.h"
#include "reports/layouts/LayoutPicture.h"
#include "reports/layouts/StructurePicture.h"
#include "reports/picture/Text.h"
#include "reports/summary/Aggregate.h"

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

/// Of all layouts of the plan.
std::string inputsOf(const LayoutPlan &plan, const Instance &instance, const KeptSolution &kept)
{
    const Provenance program = Provenance::here();
    Fingerprint hash;
    hash.add(program.version).add(program.revision).add(plan.title).add(instance.fingerprint());
    hash.add(instance.graph->yAxis() == YAxis::up ? "up" : "down");
    for (const Point &point : instance.graph->coordinates())
        hash.add(point.x).add(point.y).add(point.z);
    if (kept.solution)
        hash.add(kept.planner).add(kept.solution->fingerprint());
    return hash.hex();
}

/// The end of NAME.txt.
std::string voucher(const Layout &layout)
{
    return "\ndrawn from " + layout.inputs + "\n";
}

/// Fills in what the folder holds of this very layout; false where that is another one, or damaged.
bool takeKept(Layout &layout, const std::filesystem::path &folder)
{
    std::string text;
    try
    {
        text = readFile(folder / (layout.name + ".txt"));
    }
    catch (const FileError &)
    {
        return false; // not drawn yet
    }
    const std::string end = voucher(layout);
    auto picture = text.ends_with(end) ? readPicture(folder, layout.name) : std::nullopt;
    if (!picture)
        return false;
    layout.picture = std::move(*picture);
    layout.caption = text.substr(0, text.size() - end.size());
    layout.isFresh = false;
    return true;
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

std::vector<Layout> drawLayouts(const ResultTable &results, const LayoutPlan &plan,
                                const std::filesystem::path &folder)
{
    const std::optional<Instance> instance = results.instance(*plan.runs.front());
    if (!instance)
        return {{.name = plan.name,
                 .missing = "its input files are gone, so the instance cannot be made again",
                 .caption = plan.title + "."}};
    const Graph &graph = *instance->graph;
    const KeptSolution kept = firstKept(results, plan);
    const Solution *solution = kept.solution ? &*kept.solution : nullptr;

    std::vector<Layout> layouts;
    const std::string inputs = inputsOf(plan, *instance, kept);
    std::optional<Placement> placement; // takes as long as drawing
    const auto add = [&](const std::string &suffix, const std::string &caption, auto &&draw)
    {
        Layout &layout =
            layouts.emplace_back(Layout{.name = plan.name + suffix, .caption = caption, .inputs = inputs});
        if (takeKept(layout, folder))
            return;
        try
        {
            if (!placement)
                placement = placeGraph(graph);
            layout.picture = draw(layout.caption);
        }
        catch (const DrawingError &error)
        {
            layout.missing = error.what();
        }
    };

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
        { return drawInstance(*instance, solution, *placement, shortTitle + "\n" + size); });
    if (!placement && layouts.front().isFresh)
        return layouts; // nor can the others be placed
    if (plan.showsStructure && graph.vertexCount() <= kLargestGraph)
        add("-structure", fmt::format("{}: structure of its graph.", plan.title),
            [&](std::string &caption)
            {
                StructurePicture drawn =
                    drawStructure(graph, *placement, shortTitle + "\nstructure: " + graphSize);
                caption = fmt::format("{}: structure of its graph of {}: {}.", plan.title, graphSize,
                                      describe(drawn.parts));
                return std::move(drawn.picture);
            });
    if (solution != nullptr && !solution->empty())
        add("-steps",
            fmt::format("{}: where the robots stand at key steps of the solution of {}, condensed.",
                        plan.title, kept.planner),
            [&](std::string &)
            { return drawFrames(*instance, *solution, *placement, shortTitle + ", " + kept.planner); });
    return layouts;
}

std::vector<std::filesystem::path> writeLayout(const Layout &layout, const std::filesystem::path &folder)
{
    const std::filesystem::path caption = folder / (layout.name + ".txt");
    std::vector<std::filesystem::path> files = {caption};
    for (const char *extension : {".png", ".pdf", ".svg"})
        files.push_back(folder / (layout.name + extension));
    if (!layout.isFresh)
        return files;
    std::error_code error;
    std::filesystem::remove(caption, error); // until the pictures are whole
    writePicture(folder, layout.name, layout.picture);
    writeFile(caption, layout.caption + voucher(layout));
    return files;
}

} // namespace mrpp
