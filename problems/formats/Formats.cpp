#include "problems/formats/Formats.h"

#include "framework/support/File.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphRec.h"
#include "problems/formats/InstanceText.h"
#include "problems/formats/MovingAiScenario.h"
#include "problems/formats/SolutionCsv.h"
#include "problems/formats/TextReader.h"

#include <algorithm>
#include <cctype>

namespace mrpp
{

namespace
{

enum class Kind
{
    graphMl,
    map,
    scenario,
    instanceText,
    unknown,
};

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// By the first word; by the extension where that says nothing.
Kind kindOf(const std::filesystem::path &file, std::string_view text)
{
    text = trimmed(withoutByteOrderMark(text));
    if (!text.empty() && text.front() == '<')
        return Kind::graphMl;
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n:="));
    if (isOneOf(word, {"type", "height", "width", "map"}))
        return Kind::map;
    if (word == "version")
        return Kind::scenario;
    const std::string_view line = text.substr(0, text.find('\n'));
    if (word == "agent" || (word == "graph" && line.find('=') != std::string_view::npos))
        return Kind::instanceText;

    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (isOneOf(extension, {".graphml", ".xml", ".gml"}))
        return Kind::graphMl;
    if (extension == ".map")
        return Kind::map;
    if (extension == ".scen")
        return Kind::scenario;
    return extension == ".instance" ? Kind::instanceText : Kind::unknown;
}

constexpr const char *kGraphFormats =
    "a graph is a MovingAI map (.map) or GraphML (.graphml, .xml, .gml; begins with '<')";
constexpr const char *kInstanceFormats =
    "an instance is text ('graph = <file>', 'agent: start = <vertex>, goal = <vertex>') or a MovingAI "
    "scenario (.scen)";

LoadedGraph parseGraph(const std::filesystem::path &file, std::string_view text)
{
    switch (kindOf(file, text))
    {
    case Kind::graphMl: {
        GraphMl read = parseGraphMl(text, file.string());
        return {std::move(read.graph), std::nullopt, std::move(read.warnings)};
    }
    case Kind::map: {
        GridMap map = parseMovingAiMap(text, file.string());
        auto graph = map.graph;
        return {std::move(graph), std::move(map), {}};
    }
    case Kind::scenario:
    case Kind::instanceText:
        throw ParseError({file.string(), 1, 1},
                         std::string("this is an instance, no graph; ") + kGraphFormats);
    case Kind::unknown:
        break;
    }
    throw ParseError({file.string(), 1, 1}, std::string("of no known format; ") + kGraphFormats);
}

LoadedInstance fromScenario(const InstanceSource &source, std::string_view text)
{
    const Scenario scenario = parseMovingAiScenario(text, source.instance.string());
    const std::filesystem::path file =
        source.graph ? *source.graph : source.instance.parent_path() / scenario.mapName();
    std::error_code error;
    if (!source.graph && (scenario.records.empty() || !std::filesystem::exists(file, error)))
        throw FileError({source.instance.string()}, "its map " + inQuotes(scenario.mapName()) +
                                                        " does not lie beside it; name the map's file");
    LoadedGraph graph = loadGraph(file);
    if (!graph.map)
        throw ParseError({file.string(), 1, 1}, "a scenario needs a MovingAI map, but this is another graph");
    return {scenarioInstance(scenario, *graph.map, source.robots.value_or(scenario.records.size())),
            std::move(graph.warnings)};
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
    Instance instance = textInstance(parsed, std::move(graph.graph));
    if (source.robots && *source.robots > instance.robotCount())
        throw InputError({parsed.file}, "there are " + std::to_string(instance.robotCount()) +
                                            " agents, fewer than the " + std::to_string(*source.robots) +
                                            " robots asked for");
    instance.starts.resize(source.robots.value_or(instance.robotCount()));
    instance.goals.resize(instance.starts.size());
    return {std::move(instance), std::move(graph.warnings)};
}

} // namespace

LoadedGraph loadGraph(const std::filesystem::path &file)
{
    return parseGraph(file, readFile(file));
}

LoadedInstance loadInstance(const InstanceSource &source)
{
    const std::string text = readFile(source.instance);
    switch (kindOf(source.instance, text))
    {
    case Kind::scenario:
        return fromScenario(source, text);
    case Kind::instanceText:
        return fromText(source, text);
    case Kind::graphMl:
    case Kind::map:
        throw ParseError({source.instance.string(), 1, 1},
                         std::string("this is a graph, no instance; ") + kInstanceFormats);
    case Kind::unknown:
        break;
    }
    throw ParseError({source.instance.string(), 1, 1},
                     std::string("of no known format; ") + kInstanceFormats);
}

std::optional<std::filesystem::path> graphFileOf(const std::filesystem::path &instance)
{
    const std::string text = readFile(instance);
    if (kindOf(instance, text) == Kind::scenario)
    {
        const std::string map = parseMovingAiScenario(text, instance.string()).mapName();
        return map.empty() ? std::nullopt : std::optional(instance.parent_path() / map);
    }
    const InstanceText parsed = parseInstanceText(text, instance.string());
    return parsed.graphLine == 0 ? std::nullopt : std::optional(parsed.graphPath());
}

void saveGraph(const std::filesystem::path &file, const Graph &graph)
{
    if (file.extension() == ".map")
        writeFile(file, formatMovingAiMap(gridMapOf(graph)));
    else
        writeFile(file, formatGraphMl(graph));
}

void saveInstance(const std::filesystem::path &file, const Instance &instance,
                  const std::filesystem::path &graphFile)
{
    if (file.extension() == ".scen")
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
        writeFile(file, formatMovingAiScenario(map, moved, graphFile.filename().string()));
        return;
    }
    std::filesystem::path named = graphFile;
    if (!graphFile.empty())
        if (const auto relative = std::filesystem::absolute(graphFile).lexically_normal().lexically_relative(
                std::filesystem::absolute(file).lexically_normal().parent_path());
            !relative.empty())
            named = relative;
    writeFile(file, formatInstanceText(instance, named.generic_string()));
}

void saveSolution(const std::filesystem::path &file, const Solution &solution)
{
    writeFile(file, formatSolutionCsv(solution));
}

void saveSolution(const std::filesystem::path &file, const Schedule &schedule)
{
    writeFile(file, formatSolutionCsv(schedule));
}

void saveAnimation(const std::filesystem::path &file, const Instance &instance, const Schedule &schedule,
                   MotionRule rule)
{
    FileWriter writer(file);
    writeGraphRec(instance, schedule, rule,
                  file.extension() == ".xml" ? GraphRecForm::xml : GraphRecForm::text,
                  [&writer](std::string_view piece) { writer.write(piece); });
    writer.commit();
}

std::vector<FileFormat> fileFormats()
{
    return {
        {"graphml", ".graphml .xml .gml", "graph", true, true,
         "GraphML of this program and of others (NetworkX, yEd, igraph, Boost, roadmaps)"},
        {"instance", ".instance", "instance", true, true,
         "text: 'graph = <file>', then 'agent: start = <vertex>, goal = <vertex>' for each robot"},
        {"movingai_map", ".map", "graph", true, true, "grid map of the Moving AI Lab's benchmarks"},
        {"movingai_scenario", ".scen", "instance", true, true,
         "starts and goals on a grid map, of the Moving AI Lab's benchmarks"},
        {"solution", ".csv", "solution", true, true,
         "rows 'step,robot,from,to': a solution, or a schedule of moves at once"},
        {"graphrec", ".txt", "animation", false, true, "animation for GraphRec, its text form 'Multirobot'"},
    };
}

} // namespace mrpp
