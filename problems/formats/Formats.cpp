#include "problems/formats/Formats.h"

#include "framework/evaluation/Validator.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphText.h"
#include "problems/formats/InstanceText.h"
#include "problems/formats/Kei18.h"
#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/MovingAiScenario.h"
#include "problems/formats/Paths.h"
#include "problems/formats/SolutionCsv.h"
#include "problems/formats/Surynek.h"
#include "problems/formats/TextReader.h"
#include "problems/formats/Tracker.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr const char *kGraphFormats =
    "a graph is a MovingAI map (.map), GraphML (.graphml, .xml, .gml; begins with '<'), DIMACS or a list of "
    "edges, or stands with its robots in .cpf, libMultiRobotPlanning's YAML or a GraphRec file";
constexpr const char *kInstanceFormats =
    "an instance is text ('graph = <file>', 'agent: start = <vertex>, goal = <vertex>'), Surynek's .cpf, "
    "Kei18's "
    "text, libMultiRobotPlanning's YAML, a GraphRec file, or a MovingAI scenario (.scen)";
constexpr const char *kSolutionFormats =
    "a solution is CSV ('step,robot,from,to'), Surynek's, Kei18's or GraphRec's, paths of EECBS or LNS, a "
    "schedule of libMultiRobotPlanning, or a plan of the MAPF tracker (CSV, JSON)";

/// Throws: the file is of another kind than the one asked for, or of no known format.
[[noreturn]] void refuseKind(FormatId format, const std::filesystem::path &file, const std::string &wanted,
                             const char *formats)
{
    const std::string what = format == FormatId::unknown ? "of no known format"
                             : holdsGraph(format)        ? "this is a graph, no " + wanted
                             : holdsInstance(format)     ? "this is an instance, no " + wanted
                                                         : "this is a solution, no " + wanted;
    throw ParseError({file.string(), 1, 1}, what + "; " + formats);
}

LoadedGraph mapOnly(GridMap map)
{
    auto graph = map.graph;
    return {std::move(graph), std::move(map), {}};
}

LoadedGraph parseGraph(const std::filesystem::path &file, std::string_view text)
{
    const std::string name = file.string();
    const FormatId format = formatOf(file, text);
    switch (format)
    {
    case FormatId::graphMl: {
        GraphMl read = parseGraphMl(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings)};
    }
    case FormatId::movingAiMap:
        return mapOnly(parseMovingAiMap(text, name));
    case FormatId::dimacs: {
        GraphText read = parseDimacs(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings)};
    }
    case FormatId::edgeList: {
        GraphText read = parseEdgeList(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings)};
    }
    case FormatId::cpf: {
        CpfProblem read = parseCpf(text, name);
        return {std::move(read.instance.graph), std::nullopt, std::move(read.warnings)};
    }
    case FormatId::libMrpInstance: {
        LibMrpInstance read = parseLibMrpInstance(text, name);
        return {std::move(read.instance.graph), std::nullopt, std::move(read.warnings)};
    }
    case FormatId::graphRec:
    case FormatId::graphRecXml: {
        GraphRecFile read =
            format == FormatId::graphRec ? parseGraphRec(text, name) : parseGraphRecXml(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings)};
    }
    default:
        refuseKind(format, file, "graph", kGraphFormats);
    }
}

/// The map of robots that are given by cells.
LoadedGraph loadMapFor(const InstanceSource &source, const std::string &mapName)
{
    const std::filesystem::path file = source.graph ? *source.graph : source.instance.parent_path() / mapName;
    std::error_code error;
    if (!source.graph && (mapName.empty() || !std::filesystem::exists(file, error)))
        throw FileError({source.instance.string()},
                        "its map " + inQuotes(mapName) + " does not lie beside it; name the map's file");
    LoadedGraph graph = loadGraph(file);
    if (!graph.map)
        throw ParseError({file.string(), 1, 1},
                         "this instance needs a MovingAI map, but this is another graph");
    return graph;
}

LoadedInstance fromScenario(const InstanceSource &source, std::string_view text)
{
    const Scenario scenario = parseMovingAiScenario(text, source.instance.string());
    LoadedGraph graph = loadMapFor(source, scenario.mapName());
    return {scenarioInstance(scenario, *graph.map, source.robots.value_or(scenario.records.size())),
            std::move(graph.warnings),
            {}};
}

LoadedInstance fromKei18(const InstanceSource &source, std::string_view text)
{
    const Kei18Instance parsed = parseKei18Instance(text, source.instance.string());
    LoadedGraph graph = loadMapFor(source, std::filesystem::path(parsed.map).filename().string());
    return {kei18Instance(parsed, *graph.map), std::move(graph.warnings), {}};
}

LoadedInstance fromText(const InstanceSource &source, std::string_view text)
{
    const InstanceText parsed = parseInstanceText(text, source.instance.string());
    if (!source.graph && parsed.graphLine == 0)
        throw ParseError({parsed.file, 1, 1},
                         "the instance names no graph; add a line 'graph = <file>' or give "
                         "the graph apart");
    if (!source.graph && !std::filesystem::exists(parsed.graphPath()))
        throw ParseError({parsed.file, parsed.graphLine, 1}, "there is no file " + inQuotes(parsed.graph) +
                                                                 " relative to the instance or beside it");
    LoadedGraph graph = loadGraph(source.graph ? *source.graph : parsed.graphPath());
    return {textInstance(parsed, std::move(graph.graph)), std::move(graph.warnings), {}};
}

LoadedInstance fromGraphRec(GraphRecFile file)
{
    if (file.goals.size() != file.starts.size())
        throw ParseError({file.file},
                         "this file does not say where the robots' goals are; name the instance");
    return {
        {std::move(file.graph), std::move(file.starts), std::move(file.goals)}, std::move(file.warnings), {}};
}

/// An instance whose file holds its graph, on a graph that was given apart: coordinates and weights may
/// differ, nothing else.
void putOnGraph(Instance &instance, const InstanceSource &source)
{
    if (!source.graph)
        return;
    auto graph = loadGraph(*source.graph).graph;
    const Graph &own = *instance.graph;
    bool same = own.vertexCount() == graph->vertexCount() && own.edgeCount() == graph->edgeCount();
    for (Vertex v = 0; same && v < own.vertexCount(); ++v)
        same = std::equal(own.neighbors(v).begin(), own.neighbors(v).end(), graph->neighbors(v).begin(),
                          graph->neighbors(v).end());
    if (!same)
        throw InputError({source.graph->string()},
                         "this is another graph than the one in " + inQuotes(source.instance.string()));
    instance.graph = std::move(graph);
}

/// The instance with all of its robots (a scenario's records apart, of which only those asked for are
/// robots).
LoadedInstance parseInstance(const InstanceSource &source, std::string_view text)
{
    const std::string name = source.instance.string();
    const FormatId format = formatOf(source.instance, text);
    LoadedInstance loaded;
    switch (format)
    {
    case FormatId::scenario:
        return fromScenario(source, text);
    case FormatId::instanceText:
        return fromText(source, text);
    case FormatId::kei18Instance:
        return fromKei18(source, text);
    case FormatId::cpf: {
        CpfProblem read = parseCpf(text, name);
        loaded = {std::move(read.instance), std::move(read.warnings), {}};
        break;
    }
    case FormatId::libMrpInstance: {
        LibMrpInstance read = parseLibMrpInstance(text, name);
        loaded = {std::move(read.instance), std::move(read.warnings), std::move(read.vertexNames)};
        break;
    }
    case FormatId::graphRec:
        loaded = fromGraphRec(parseGraphRec(text, name));
        break;
    case FormatId::graphRecXml:
        loaded = fromGraphRec(parseGraphRecXml(text, name));
        break;
    default:
        refuseKind(format, source.instance, "instance", kInstanceFormats);
    }
    putOnGraph(loaded.instance, source);
    return loaded;
}

} // namespace

LoadedGraph loadGraph(const std::filesystem::path &file)
{
    return parseGraph(file, readFile(file));
}

LoadedInstance loadInstance(const InstanceSource &source)
{
    LoadedInstance loaded = parseInstance(source, readFile(source.instance));
    Instance &instance = loaded.instance;
    if (source.robots && *source.robots > instance.robotCount())
        throw InputError({source.instance.string()},
                         "there are " + std::to_string(instance.robotCount()) + " agents, fewer than the " +
                             std::to_string(*source.robots) + " robots asked for");
    instance.starts.resize(source.robots.value_or(instance.robotCount()));
    instance.goals.resize(instance.starts.size());
    return loaded;
}

SolutionRows loadSolution(const std::filesystem::path &file, const Instance &instance,
                          std::span<const std::string> vertexNames)
{
    const std::string text = readFile(file);
    const std::string name = file.string();
    const FormatId format = formatOf(file, text);
    switch (format)
    {
    case FormatId::solutionCsv:
        return parseSolutionCsv(text, name);
    case FormatId::surynekSolution:
        return parseSurynekSolution(text, name);
    case FormatId::kei18Result:
        return parseKei18Result(text, name, instance);
    case FormatId::paths:
        return parsePaths(text, name, instance);
    case FormatId::libMrpSchedule:
        return parseLibMrpSchedule(text, name, instance, vertexNames);
    case FormatId::trackerCsv:
        return parseTracker(text, name, TrackerForm::csv, instance);
    case FormatId::trackerJson:
        return parseTracker(text, name, TrackerForm::json, instance);
    case FormatId::graphRec:
        return graphRecRows(parseGraphRec(text, name), instance);
    case FormatId::graphRecXml:
        return graphRecRows(parseGraphRecXml(text, name), instance);
    default:
        refuseKind(format, file, "solution", kSolutionFormats);
    }
}

std::optional<std::filesystem::path> graphFileOf(const std::filesystem::path &instance)
{
    const std::string text = readFile(instance);
    const auto beside = [&instance](const std::string &map)
    { return map.empty() ? std::nullopt : std::optional(instance.parent_path() / map); };
    switch (formatOf(instance, text))
    {
    case FormatId::scenario:
        return beside(parseMovingAiScenario(text, instance.string()).mapName());
    case FormatId::kei18Instance:
        return beside(
            std::filesystem::path(parseKei18Instance(text, instance.string()).map).filename().string());
    case FormatId::cpf:
    case FormatId::libMrpInstance:
    case FormatId::graphRec:
    case FormatId::graphRecXml:
        return std::nullopt; // the graph stands in the file itself
    default: {
        const InstanceText parsed = parseInstanceText(text, instance.string());
        return parsed.graphLine == 0 ? std::nullopt : std::optional(parsed.graphPath());
    }
    }
}

void saveGraph(FileSet &files, const std::filesystem::path &file, const Graph &graph)
{
    files.add(file).write(file.extension() == ".map" ? formatMovingAiMap(gridMapOf(graph))
                                                     : formatGraphMl(graph));
}

void saveGraph(const std::filesystem::path &file, const Graph &graph)
{
    FileSet files;
    saveGraph(files, file, graph);
    files.commit();
}

void saveInstance(FileSet &files, const std::filesystem::path &file, const Instance &instance,
                  const std::filesystem::path &graphFile, std::optional<InstanceForm> form)
{
    if (form ? *form == InstanceForm::scenario : file.extension() == ".scen")
    {
        const GridMap map = gridMapOf(*instance.graph);
        Instance moved{map.graph, {}, {}};
        const auto cellVertex = [&](Vertex v)
        {
            const Point &cell = instance.graph->coordinate(v);
            return map.vertexAt(static_cast<std::size_t>(cell.x), static_cast<std::size_t>(cell.y));
        };
        for (std::size_t r = 0; r < instance.robotCount(); ++r)
        {
            moved.starts.push_back(cellVertex(instance.starts[r]));
            moved.goals.push_back(cellVertex(instance.goals[r]));
        }
        files.add(file).write(formatMovingAiScenario(map, moved, graphFile.filename().string()));
        return;
    }
    std::filesystem::path named = graphFile;
    if (!graphFile.empty())
        if (const auto relative = std::filesystem::absolute(graphFile).lexically_normal().lexically_relative(
                std::filesystem::absolute(file).lexically_normal().parent_path());
            !relative.empty())
            named = relative;
    files.add(file).write(formatInstanceText(instance, named.generic_string()));
}

void saveInstance(const std::filesystem::path &file, const Instance &instance,
                  const std::filesystem::path &graphFile, std::optional<InstanceForm> form)
{
    FileSet files;
    saveInstance(files, file, instance, graphFile, form);
    files.commit();
}

void saveSolution(FileSet &files, const std::filesystem::path &file, const Solution &solution)
{
    files.add(file).write(formatSolutionCsv(solution));
}

void saveSolution(FileSet &files, const std::filesystem::path &file, const Schedule &schedule)
{
    files.add(file).write(formatSolutionCsv(schedule));
}

void saveAnimation(FileSet &files, const std::filesystem::path &file, const Instance &instance,
                   const Schedule &schedule, std::optional<GraphRecForm> form)
{
    const MotionRule rule = validate(instance, schedule, MotionRule::parallel).legal ? MotionRule::parallel
                                                                                     : MotionRule::rotation;
    FileWriter &writer = files.add(file);
    writeGraphRec(instance, schedule, rule,
                  form.value_or(file.extension() == ".xml" ? GraphRecForm::xml : GraphRecForm::text),
                  [&writer](std::string_view piece) { writer.write(piece); });
}

void saveAnimation(const std::filesystem::path &file, const Instance &instance, const Schedule &schedule)
{
    FileSet files;
    saveAnimation(files, file, instance, schedule);
    files.commit();
}

} // namespace mrpp
