#include "yaml/PlanReader.h"

#include "framework/PluginLoader.h"
#include "framework/plan/Configuration.h"
#include "framework/support/Suggestion.h"
#include "framework/system/File.h"
#include "yaml/ChartList.h"
#include "yaml/PlanNodes.h"
#include "yaml/PlannerList.h"
#include "yaml/ProblemList.h"
#include "yaml/YamlConfig.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace mrpp
{

namespace
{

bool boolOf(const Config::Entry &entry)
{
    const std::string &text = textOf(entry);
    if (text == "true" || text == "yes")
        return true;
    if (text == "false" || text == "no")
        return false;
    throw PlanError(entry.value.where(), "'" + entry.key + "' takes true or false, but is '" + text + "'");
}

Limits readLimits(const Config::Entry &entry)
{
    Limits limits;
    requireMap(entry.value, entry.where, "'limits' takes a map: {time: 60 s, cpu: 60 s, memory: 4 GiB}");
    checkKeys(entry.value, "limits", {"time", "cpu", "memory"});
    for (const Config::Entry &limit : entry.value.entries())
        if (limit.key == "time")
            limits.time = durationOf(limit);
        else if (limit.key == "cpu")
            limits.cpu = durationOf(limit);
        else
            limits.memory = sizeOf(limit, "500 MB, 4 GiB");
    return limits;
}

Execution readExecution(const Config::Entry &entry)
{
    Execution execution;
    requireMap(entry.value, entry.where, "'execution' takes a map: {jobs: 2, isolation: none}");
    checkKeys(entry.value, "execution", {"jobs", "isolation", "timing_repeats", "warm_up"});
    constexpr std::int64_t kMostJobs = 1024;
    constexpr std::int64_t kMostRepeats = 1000;
    for (const Config::Entry &setting : entry.value.entries())
    {
        if (setting.key == "jobs")
        {
            execution.jobs = integerOf(setting, 1, kMostJobs);
            continue;
        }
        if (setting.key == "timing_repeats" || setting.key == "warm_up")
        {
            const bool repeats = setting.key == "timing_repeats";
            (repeats ? execution.timingRepeats : execution.warmUp) =
                integerOf(setting, repeats ? 1 : 0, kMostRepeats);
            continue;
        }
        execution.isolation = textOf(setting);
        if (execution.isolation != "none" && execution.isolation != "process")
            throw PlanError(setting.value.where(),
                            "'isolation' takes none or process, but is '" + execution.isolation + "'");
    }
    return execution;
}

Keep readKeep(const Config::Entry &entry)
{
    Keep keep;
    requireMap(entry.value, entry.where, "'keep' takes a map: {instances: true, solutions: true}");
    checkKeys(entry.value, "keep", {"instances", "solutions"});
    for (const Config::Entry &setting : entry.value.entries())
        (setting.key == "instances" ? keep.instances : keep.solutions) = boolOf(setting);
    return keep;
}

ExplorerChoice readExplorer(const Config::Entry &entry)
{
    ExplorerChoice explorer;
    requireMap(entry.value, entry.where, "'explorer' takes a map: {solutions: first, size: 10 MB}");
    checkKeys(entry.value, "explorer", {"solutions", "size"});
    for (const Config::Entry &setting : entry.value.entries())
    {
        if (setting.key == "size")
        {
            explorer.size = sizeOf(setting, "500 kB, 10 MB");
            continue;
        }
        explorer.solutions = textOf(setting);
        const std::vector<std::string> known = {"first", "all", "none"};
        if (std::find(known.begin(), known.end(), explorer.solutions) == known.end())
            throw PlanError(setting.value.where(), "'solutions' takes first, all or none, but is '" +
                                                       explorer.solutions + "'" +
                                                       suggestion(explorer.solutions, known));
    }
    return explorer;
}

/// Reports by name, and charts. Where charts are asked for and `charts` is not, there are no others.
void readReports(const Config::Entry &entry, const Catalog &catalog, BenchmarkPlan &plan)
{
    constexpr const char *kCharts = "charts";
    plan.reports.clear();
    for (const Config &node : itemsOf(entry, "reports' names, or leave the key out for all of them"))
    {
        if (node.isMap() && node.entries().size() == 1 && node.entries().front().key == "chart")
        {
            plan.charts.push_back(readChart(node.entries().front(), plan));
            continue;
        }
        if (!node.isScalar())
            throw PlanError(node.where(), "a report is a name, or a figure: {chart: {x: COLUMN, y: COLUMN}}");
        if (catalog.reports.find(node.text()) == nullptr)
            throw PlanError(node.where(), "there is no report '" + node.text() + "'" +
                                              suggestion(node.text(), catalog.reports.names()));
        if (std::find(plan.reports.begin(), plan.reports.end(), node.text()) != plan.reports.end())
            throw PlanError(node.where(), "the report '" + node.text() + "' stands twice");
        plan.reports.push_back(node.text());
    }
    const bool namesCharts =
        std::find(plan.reports.begin(), plan.reports.end(), kCharts) != plan.reports.end();
    plan.automaticCharts = plan.charts.empty() || namesCharts;
    if (!namesCharts && !plan.charts.empty() && catalog.reports.find(kCharts) != nullptr)
        plan.reports.insert(plan.reports.begin(), kCharts);
}

struct PathInPlan
{
    std::filesystem::path path;
    SourceLocation where;
};

/// One path, or a list of them; relative ones start at the plan's folder.
std::vector<PathInPlan> readPaths(const Config::Entry &entry, const std::filesystem::path &start)
{
    if (!entry.value.isList())
        return {{start / textOf(entry), entry.value.where()}};
    std::vector<PathInPlan> paths;
    for (const Config &item : itemsOf(entry, "paths"))
    {
        if (!item.isScalar())
            throw PlanError(item.where(), "'" + entry.key + "' takes paths");
        paths.push_back({start / item.text(), item.where()});
    }
    return paths;
}

void loadPlugins(const Config::Entry &entry, const std::filesystem::path &start, Catalog &catalog)
{
    for (const auto &[path, where] : readPaths(entry, start))
    {
        try
        {
            loadPlugin(catalog, path);
        }
        catch (const InputError &error)
        {
            throw PlanError(where, error.what());
        }
    }
}

bool isFileNameSafe(const std::string &name)
{
    constexpr std::size_t kLongest = 100;
    const auto isSafe = [](char c)
    {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-' || c == '.';
    };
    return !name.empty() && name.size() <= kLongest && name.front() != '.' && name.front() != '-' &&
           std::all_of(name.begin(), name.end(), isSafe);
}

std::string readCampaign(const Config &root, const std::filesystem::path &file)
{
    constexpr const char *kWanted =
        "a folder is named after it: letters, digits, '_', '-' and '.', at most 100, "
        "not beginning with '.' or '-'";
    for (const Config::Entry &entry : root.entries())
    {
        if (entry.key != "campaign")
            continue;
        if (!isFileNameSafe(textOf(entry)))
            throw PlanError(entry.value.where(),
                            "'" + entry.value.text() + "' cannot name a campaign; " + kWanted);
        return entry.value.text();
    }
    std::string stem = file.stem().string();
    if (!isFileNameSafe(stem))
        throw PlanError({file.string(), 1, 1},
                        "the plan has no 'campaign', and its file's name cannot stand in; " +
                            std::string(kWanted));
    return stem;
}

/// Files are looked for beside the plan, then in its folders of maps.
ProblemContext contextOf(const BenchmarkPlan &plan, const Catalog &catalog)
{
    ProblemContext context{&catalog, {plan.file.parent_path()}};
    context.searchPaths.insert(context.searchPaths.end(), plan.mapFolders.begin(), plan.mapFolders.end());
    return context;
}

} // namespace

BenchmarkPlan parsePlan(const std::string &text, const std::filesystem::path &file, Catalog &catalog,
                        const std::vector<std::filesystem::path> &searchPaths)
{
    const Config root = parseYaml(text, file.string());
    const SourceLocation top{file.string(), 1, 1};
    requireMap(root, top, "a plan is a map of keys: campaign, problems, planners, …");
    checkKeys(root, "a plan",
              {"campaign", "seed", "repetitions", "limits", "problems", "planners", "optimizers", "reports",
               "motion", "execution", "keep", "explorer", "maps", "plugins"});

    BenchmarkPlan plan;
    plan.mapFolders = searchPaths;
    for (const Config::Entry &entry : root.entries())
        if (entry.key == "maps")
            for (const auto &[folder, where] : readPaths(entry, file.parent_path()))
                plan.mapFolders.push_back(folder);
        else if (entry.key == "plugins")
            loadPlugins(entry, file.parent_path(), catalog);
    plan.text = text;
    plan.file = file;
    const ProblemContext context = contextOf(plan, catalog);
    plan.campaign = readCampaign(root, file);
    plan.reports = catalog.reports.names();
    for (const Config::Entry &entry : root.entries())
    {
        constexpr std::int64_t kMostRepetitions = 1'000'000;
        if (entry.key == "seed")
            plan.seed = static_cast<Seed>(integerOf(entry, 0, std::numeric_limits<std::int64_t>::max()));
        else if (entry.key == "repetitions")
            plan.repetitions = integerOf(entry, 1, kMostRepetitions);
        else if (entry.key == "limits")
            plan.limits = readLimits(entry);
        else if (entry.key == "problems")
            plan.points = readProblems(itemsOf(entry, "problems, as in 'small_benchmark: tree'"), context);
        else if (entry.key == "planners")
            plan.planners = readPlanners(entry, catalog, file.parent_path());
        else if (entry.key == "optimizers")
            plan.optimizers = readOptimizers(entry, catalog);
        else if (entry.key == "execution")
            plan.execution = readExecution(entry);
        else if (entry.key == "keep")
            plan.keep = readKeep(entry);
        else if (entry.key == "explorer")
            plan.explorer = readExplorer(entry);
        else if (entry.key == "motion")
        {
            const auto rule = motionRule(textOf(entry));
            if (!rule)
                throw PlanError(entry.value.where(), "there is no motion rule '" + entry.value.text() +
                                                         "'; known: pebble, parallel, following, rotation");
            plan.motion = *rule;
        }
    }
    for (const char *required : {"problems", "planners"})
        if (root.find(required) == nullptr)
            throw PlanError(root.where(), std::string("the plan has no '") + required + "'");
    for (const Config::Entry &entry : root.entries())
        if (entry.key == "reports") // last: charts name problems and planners
            readReports(entry, catalog, plan);
    resolve(plan, catalog);
    return plan;
}

PlanError placed(const PointError &error, const BenchmarkPlan &plan, const Catalog &catalog)
{
    const Config root = parseYaml(plan.text, plan.file.string());
    std::vector<PointPlaces> places;
    (void)readProblems(root.find("problems")->items(), contextOf(plan, catalog), &places);
    const PointPlaces &own = places.at(error.point());
    const auto setting = own.find(error.setting());
    const SourceLocation &where = setting == own.end() ? own.at("") : setting->second;
    if (error.isInFile())
        return {error.where(), error.complaint() + " (" + error.problem() + ", " + where.toString() + ")"};
    return {where, error.complaint()};
}

BenchmarkPlan readPlan(const std::filesystem::path &file, Catalog &catalog,
                       const std::vector<std::filesystem::path> &searchPaths)
{
    return parsePlan(readFile(file), file, catalog, searchPaths);
}

} // namespace mrpp
