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
#include "problems/formats/Tracker.h"
#include "problems/formats/VetandXml.h"
#include "problems/formats/support/TextReader.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr const char *kGraphFormats =
    "a graph is a MovingAI map (.map), GraphML (.graphml, .xml, .gml; begins with '<'), DIMACS, Matrix "
    "Market "
    "or a list of edges, or stands with its robots in .cpf, libMultiRobotPlanning's YAML, vetand's XML or a "
    "GraphRec file";
constexpr const char *kInstanceFormats =
    "an instance is text ('graph = <file>', 'agent: start = <vertex>, goal = <vertex>'), Surynek's .cpf, "
    "Kei18's "
    "text, libMultiRobotPlanning's YAML, vetand's XML, a GraphRec file, or a MovingAI scenario (.scen)";
constexpr const char *kSolutionFormats =
    "a solution is CSV ('step,robot,from,to'), Surynek's, Kei18's or GraphRec's, paths of EECBS or LNS, a "
    "schedule of libMultiRobotPlanning, an answer of vetand's Push and Rotate, or a plan of the MAPF tracker "
    "(CSV, "
    "JSON)";

/// Throws: the file is of another kind than the one asked for, or of no known format.
[[noreturn]] void refuseKind(const std::filesystem::path &file, std::string_view text,
                             const std::string &wanted, const char *formats)
{
    const FormatId format = formatOf(text); // whatever its name says
    const std::string what = "this is " + describe(format, text) +
                             (format == FormatId::unknown ? ", of no known format" : ", no " + wanted);
    throw ParseError({file.string(), 1, 1}, what + "; " + formats);
}

LoadedGraph mapOnly(GridMap map)
{
    auto graph = map.graph;
    return {std::move(graph), std::move(map), {}, {}};
}

LoadedGraph fromLines(GraphText read)
{
    return {std::move(read.graph), std::nullopt, std::move(read.warnings), std::move(read.vertexNames)};
}

LoadedGraph parseGraph(const std::filesystem::path &file, std::string_view text, const Passability &rule)
{
    const std::string name = file.string();
    const FormatId format = formatOf(file, text);
    switch (format)
    {
    case FormatId::graphMl: {
        GraphMl read = parseGraphMl(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings), {}};
    }
    case FormatId::movingAiMap:
        return mapOnly(parseMovingAiMap(text, name, rule));
    case FormatId::dimacs:
        return fromLines(parseDimacs(text, name));
    case FormatId::edgeList:
        return fromLines(parseEdgeList(text, name));
    case FormatId::matrixMarket:
        return fromLines(parseMatrixMarket(text, name));
    case FormatId::cpf: {
        CpfProblem read = parseCpf(text, name);
        return {std::move(read.instance.graph), std::nullopt, std::move(read.warnings), {}};
    }
    case FormatId::libMrpInstance: {
        LibMrpInstance read = parseLibMrpInstance(text, name);
        return {std::move(read.instance.graph), std::move(read.map), std::move(read.warnings),
                std::move(read.vertexNames)};
    }
    case FormatId::vetandInstance:
    case FormatId::vetandResult: {
        VetandInstance read = parseVetandInstance(text, name);
        return {std::move(read.instance.graph), std::move(read.map), {}, {}};
    }
    case FormatId::graphRec:
    case FormatId::graphRecXml: {
        GraphRecFile read =
            format == FormatId::graphRec ? parseGraphRec(text, name) : parseGraphRecXml(text, name);
        return {std::move(read.graph), std::nullopt, std::move(read.warnings), {}};
    }
    default:
        refuseKind(file, text, "graph", kGraphFormats);
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
    LoadedGraph graph = loadGraph(file, passability(source.passability));
    if (!graph.map)
        throw ParseError({file.string(), 1, 1},
                         "this instance needs a MovingAI map, but this is another graph");
    return graph;
}

/// An instance on a map of its own file.
LoadedInstance onMap(Instance instance, LoadedGraph graph)
{
    LoadedInstance loaded{std::move(instance), std::move(graph.warnings), {}};
    loaded.map = std::move(graph.map);
    return loaded;
}

LoadedInstance fromScenario(const InstanceSource &source, std::string_view text)
{
    const Scenario scenario = parseMovingAiScenario(text, source.instance.string());
    LoadedGraph graph = loadMapFor(source, scenario.mapName());
    Instance instance =
        scenarioInstance(scenario, *graph.map, source.robots.value_or(scenario.records.size()));
    LoadedInstance loaded = onMap(std::move(instance), std::move(graph));
    loaded.graphName = std::filesystem::path(scenario.mapName()).stem().string();
    return loaded;
}

LoadedInstance fromKei18(const InstanceSource &source, std::string_view text)
{
    const Kei18Instance parsed = parseKei18Instance(text, source.instance.string());
    const std::string mapName(fileNameIn(parsed.map));
    LoadedGraph graph = loadMapFor(source, mapName);
    Instance instance = kei18Instance(parsed, *graph.map);
    LoadedInstance loaded = onMap(std::move(instance), std::move(graph));
    loaded.graphName = std::filesystem::path(mapName).stem().string();
    return loaded;
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
    const std::filesystem::path file = source.graph ? *source.graph : parsed.graphPath();
    LoadedGraph graph = loadGraph(file, passability(source.passability));
    std::vector<std::string> names = std::move(graph.vertexNames);
    Instance instance = textInstance(parsed, graph.graph);
    LoadedInstance loaded = onMap(std::move(instance), std::move(graph));
    loaded.vertexNames = std::move(names);
    loaded.graphName = file.stem().string();
    return loaded;
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
void putOnGraph(LoadedInstance &loaded, const InstanceSource &source)
{
    if (!source.graph)
        return;
    Instance &instance = loaded.instance;
    auto graph = loadGraph(*source.graph, passability(source.passability)).graph;
    const Graph &own = *instance.graph;
    bool same = own.vertexCount() == graph->vertexCount() && own.edgeCount() == graph->edgeCount();
    for (Vertex v = 0; same && v < own.vertexCount(); ++v)
        same = std::equal(own.neighbors(v).begin(), own.neighbors(v).end(), graph->neighbors(v).begin(),
                          graph->neighbors(v).end());
    if (!same)
        throw InputError({source.graph->string()},
                         "this is another graph than the one in " + inQuotes(source.instance.string()));
    if (!std::equal(own.coordinates().begin(), own.coordinates().end(), graph->coordinates().begin(),
                    graph->coordinates().end()))
        loaded.map.reset();
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
        loaded = {std::move(read.instance), std::move(read.warnings), std::move(read.vertexNames),
                  std::move(read.robotNames), std::move(read.map)};
        break;
    }
    case FormatId::vetandInstance:
    case FormatId::vetandResult: {
        VetandInstance read = parseVetandInstance(text, name);
        loaded = {std::move(read.instance), {}, {}, {}, std::move(read.map)};
        break;
    }
    case FormatId::graphRec:
        loaded = fromGraphRec(parseGraphRec(text, name));
        break;
    case FormatId::graphRecXml:
        loaded = fromGraphRec(parseGraphRecXml(text, name));
        break;
    default:
        refuseKind(source.instance, text, "instance", kInstanceFormats);
    }
    putOnGraph(loaded, source);
    return loaded;
}

} // namespace

LoadedGraph loadGraph(const std::filesystem::path &file, const Passability &rule)
{
    return parseGraph(file, readFile(file), rule);
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
    if (loaded.robotNames.size() > instance.robotCount())
        loaded.robotNames.resize(instance.robotCount());
    loaded.scenario = source.instance.filename().string();
    return loaded;
}

namespace
{

TrackerContext trackerContextOf(const LoadedInstance &loaded)
{
    TrackerContext context;
    context.map = loaded.graphName;
    if (const auto name = trackerName(loaded.scenario))
    {
        context.map = context.map.empty() ? name->map : context.map;
        context.type = name->type;
        context.number = name->number;
    }
    return context;
}

} // namespace

SolutionRows loadSolution(const std::filesystem::path &file, const Instance &instance)
{
    return loadSolution(file, LoadedInstance{instance, {}, {}});
}

SolutionRows loadSolution(const std::filesystem::path &file, const LoadedInstance &loaded)
{
    const Instance &instance = loaded.instance;
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
        return parseLibMrpSchedule(text, name, instance, loaded.vertexNames, loaded.robotNames);
    case FormatId::vetandInstance: // an answer without moves
    case FormatId::vetandResult:
        return parseVetandResult(text, name, instance);
    case FormatId::trackerCsv:
        return parseTracker(text, name, TrackerForm::csv, instance, trackerContextOf(loaded));
    case FormatId::trackerJson:
        return parseTracker(text, name, TrackerForm::json, instance, trackerContextOf(loaded));
    case FormatId::graphRec:
        return graphRecRows(parseGraphRec(text, name), instance);
    case FormatId::graphRecXml:
        return graphRecRows(parseGraphRecXml(text, name), instance);
    default:
        refuseKind(file, text, "solution", kSolutionFormats);
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
        return beside(std::string(fileNameIn(parseKei18Instance(text, instance.string()).map)));
    case FormatId::cpf:
    case FormatId::libMrpInstance:
    case FormatId::vetandInstance:
    case FormatId::vetandResult:
    case FormatId::graphRec:
    case FormatId::graphRecXml:
        return std::nullopt; // the graph stands in the file itself
    case FormatId::unknown:
        refuseKind(instance, text, "instance", kInstanceFormats);
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
                  const std::filesystem::path &graphFile, std::optional<InstanceForm> form,
                  const Supervision::Listener &listener)
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
        files.add(file).write(
            formatMovingAiScenario(map, moved, graphFile.filename().string(), {.listener = listener}));
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
