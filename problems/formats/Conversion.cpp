#include "problems/formats/Conversion.h"

#include "framework/support/Error.h"
#include "framework/support/Suggestion.h"
#include "framework/system/File.h"
#include "problems/formats/FormatId.h"
#include "problems/formats/Formats.h"
#include "problems/formats/GraphMl.h"
#include "problems/formats/GraphRec.h"
#include "problems/formats/GraphText.h"
#include "problems/formats/Kei18.h"
#include "problems/formats/LibMrpYaml.h"
#include "problems/formats/MovingAiScenario.h"
#include "problems/formats/Paths.h"
#include "problems/formats/PlanViz.h"
#include "problems/formats/SolutionCsv.h"
#include "problems/formats/Surynek.h"
#include "problems/formats/Tracker.h"
#include "problems/formats/VetandXml.h"
#include "problems/formats/support/Cells.h"
#include "problems/formats/support/ForeignFormats.h"

#include <algorithm>
#include <cctype>

namespace mrpp
{

namespace
{

enum class Holds
{
    graph,
    instance,
    solution,
};

/// What of the vertices' coordinates a format can say.
enum class Coordinates
{
    all,
    flatUp,   ///< x and y, which grows upwards
    flatDown, ///< x and y, which grows downwards
    scaled,   ///< x and y in another unit, drawn the right way up
    none,
};

/// A format that is written, and what of a graph it can say.
struct Target
{
    const char *name;
    FormatId id;
    Holds holds;
    Coordinates coordinates = Coordinates::all;
    bool weights = true;
    LibMrpForm libMrp = LibMrpForm::fitting;
};

constexpr Target kTargets[] = {
    {"graphml", FormatId::graphMl, Holds::graph},
    {"movingai_map", FormatId::movingAiMap, Holds::graph, Coordinates::flatDown, false},
    {"dimacs", FormatId::dimacs, Holds::graph, Coordinates::none},
    {"edge_list", FormatId::edgeList, Holds::graph, Coordinates::none},
    {"instance", FormatId::instanceText, Holds::instance},
    {"movingai_scenario", FormatId::scenario, Holds::instance, Coordinates::flatDown, false},
    {"cpf", FormatId::cpf, Holds::instance, Coordinates::none, false},
    {"kei18_instance", FormatId::kei18Instance, Holds::instance, Coordinates::flatDown, false},
    {"libmrp_instance", FormatId::libMrpInstance, Holds::instance, Coordinates::flatUp, false},
    {"libmrp_map", FormatId::libMrpInstance, Holds::instance, Coordinates::flatUp, false, LibMrpForm::map},
    {"libmrp_roadmap", FormatId::libMrpInstance, Holds::instance, Coordinates::flatUp, false,
     LibMrpForm::roadmap},
    {"vetand_instance", FormatId::vetandInstance, Holds::instance, Coordinates::flatDown, false},
    {"solution", FormatId::solutionCsv, Holds::solution},
    {"surynek_solution", FormatId::surynekSolution, Holds::solution},
    {"kei18_result", FormatId::kei18Result, Holds::solution},
    {"libmrp_schedule", FormatId::libMrpSchedule, Holds::solution},
    {"vetand_result", FormatId::vetandResult, Holds::solution, Coordinates::flatDown, false},
    {"paths", FormatId::paths, Holds::solution},
    {"tracker_csv", FormatId::trackerCsv, Holds::solution},
    {"tracker_json", FormatId::trackerJson, Holds::solution},
    {"graphrec", FormatId::graphRec, Holds::solution, Coordinates::scaled, false},
    {"graphrec_xml", FormatId::graphRecXml, Holds::solution, Coordinates::scaled, false},
    {"planviz", FormatId::planViz, Holds::solution},
    {"planviz_2_0", FormatId::planViz, Holds::solution},
};

const char *toString(Holds holds)
{
    return holds == Holds::graph ? "graph" : holds == Holds::instance ? "instance" : "solution";
}

bool canRead(FormatId format, Holds wanted)
{
    return wanted == Holds::graph      ? holdsGraph(format)
           : wanted == Holds::instance ? holdsInstance(format)
                                       : holdsSolution(format);
}

const Target &targetNamed(const std::string &name)
{
    std::vector<std::string> names;
    for (const Target &target : kTargets)
    {
        if (target.name == name)
            return target;
        names.emplace_back(target.name);
    }
    throw InputError("there is no format '" + name + "' that is written" + suggestion(name, names));
}

bool hasExtension(const Target &target, const std::string &extension)
{
    const auto formats = fileFormats();
    const auto listed = std::find_if(formats.begin(), formats.end(),
                                     [&](const FileFormat &format) { return format.name == target.name; });
    return (" " + listed->extensions + " ").find(" " + extension + " ") != std::string::npos;
}

/// The one that an extension means where nothing else is said.
bool isUsual(std::string_view name)
{
    return name == "graphml" || name == "solution" || name == "libmrp_instance";
}

/// The format of OUT: the one that was asked for, else the only one of its extension that holds something
/// that IN has; this program's own where there are several.
const Target &chooseTarget(const ConversionRequest &request, FormatId in)
{
    if (request.format)
        return targetNamed(*request.format);
    std::string extension = request.out.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::vector<const Target *> fitting;
    for (const Target &target : kTargets)
        if (!extension.empty() && hasExtension(target, extension) && canRead(in, target.holds))
            fitting.push_back(&target);
    for (const Target *target : fitting)
        if (isUsual(target->name))
            return *target;
    if (fitting.size() == 1)
        return *fitting.front();
    std::string names;
    for (const Target &target : kTargets)
        if (canRead(in, target.holds) &&
            (fitting.empty() || std::find(fitting.begin(), fitting.end(), &target) != fitting.end()))
            names += (names.empty() ? "" : ", ") + std::string(target.name);
    throw InputError({request.out.string()},
                     (fitting.empty()
                          ? "no format with the extension '" + extension + "' holds what can be read here"
                          : "several formats have the extension '" + extension + "'") +
                         "; say --to with one of: " + names);
}

/// Throws ParseError where the input is of no format that is read.
FormatId formatOfInput(const ConversionRequest &request)
{
    const std::string text = readFile(request.in);
    const FormatId format = formatOf(request.in, text);
    const bool isOther = formatOf(text) == FormatId::unknown && describeUnknown(text) != kPlainText;
    if (isOther || (!canRead(format, Holds::graph) && !canRead(format, Holds::instance) &&
                    !canRead(format, Holds::solution)))
        throw ParseError({request.in.string(), 1, 1},
                         "this is " + describe(formatOf(text), text) +
                             ", which is not read; `mrppsim list formats` says what is");
    return format;
}

class Converter
{
public:
    Converter(const ConversionRequest &request, FileSet &files, const Supervision::Listener &listener)
        : request_(request), in_(formatOfInput(request)), target_(chooseTarget(request, in_)), files_(files),
          listener_(listener)
    {}

    Conversion run()
    {
        if (!canRead(in_, target_.holds))
            throw InputError({request_.in.string()}, std::string("there is no ") + toString(target_.holds) +
                                                         " in this file, but '" + target_.name +
                                                         "' holds one");
        result_.format = target_.name;
        if (target_.holds == Holds::graph)
            convertGraph();
        else if (target_.holds == Holds::instance)
            convertInstance();
        else
            convertSolution();
        files_.commit();
        return std::move(result_);
    }

private:
    void note(const std::vector<std::string> &notes)
    {
        result_.notes.insert(result_.notes.end(), notes.begin(), notes.end());
    }

    void noteLosses(const Graph &graph)
    {
        if (graph.hasCoordinates())
            noteCoordinates(graph);
        if (!target_.weights && graph.isWeighted())
            note({"lost: the edges' weights"});
    }

    void noteCoordinates(const Graph &graph)
    {
        if (target_.coordinates == Coordinates::all)
            return;
        if (target_.coordinates == Coordinates::none)
            return note({"lost: the vertices' coordinates"});
        const auto points = graph.coordinates();
        if (std::any_of(points.begin(), points.end(), [](const Point &point) { return point.z != 0; }))
            note({"lost: the vertices' heights (z)"});
        if (target_.coordinates == Coordinates::scaled)
            return note({"changed: coordinates are scaled to 60 units between neighbours"});
        if ((graph.yAxis() == YAxis::up) != (target_.coordinates == Coordinates::flatUp))
            note({std::string("changed: the direction of y, which grows ") +
                  (graph.yAxis() == YAxis::up ? "downwards" : "upwards") + " here"});
    }

    void write(const std::filesystem::path &file, const std::string &text)
    {
        files_.add(file).write(text);
        result_.files.push_back(file);
    }

    /// Runs a writer; its complaint names the format that cannot express what is asked.
    template <class Work>
    auto asTarget(Work &&work) const
    {
        try
        {
            return work();
        }
        catch (const InputError &error)
        {
            throw InputError({request_.out.string()},
                             std::string("'") + target_.name + "' cannot hold this: " + error.complaint());
        }
    }

    void convertGraph()
    {
        const LoadedGraph loaded = loadGraph(request_.in, passability(request_.passability));
        note(loaded.warnings);
        if (holdsInstance(in_))
            note({"lost: the robots"});
        if (holdsSolution(in_))
            note({"lost: the moves"});
        if (loaded.map && target_.id == FormatId::movingAiMap)
            return write(request_.out, formatMovingAiMap(*loaded.map));
        const Graph &graph = *loaded.graph;
        noteLosses(graph);
        const bool keepsNames = target_.id == FormatId::edgeList && fitsEdgeList(graph, loaded.vertexNames);
        if (!keepsNames && !loaded.vertexNames.empty())
            note({"lost: the vertices' names"});
        if (loaded.map)
            if (const auto kept = gridMapIfOne(graph);
                !kept || formatMovingAiMap(*kept) != formatMovingAiMap(*loaded.map))
                note({"lost: the map's size, and what its obstacles are"});
        write(request_.out, asTarget(
                                [&]
                                {
                                    switch (target_.id)
                                    {
                                    case FormatId::movingAiMap:
                                        return mapText(graph);
                                    case FormatId::dimacs:
                                        return formatDimacs(graph);
                                    case FormatId::edgeList:
                                        return formatEdgeList(graph, keepsNames ? loaded.vertexNames
                                                                                : std::vector<std::string>());
                                    default:
                                        return formatGraphMl(graph);
                                    }
                                }));
    }

    std::string mapText(const Graph &graph)
    {
        const GridMap map = gridMapOf(graph);
        noteRenumbering(graph, map);
        return formatMovingAiMap(map);
    }

    void noteRenumbering(const Graph &graph, const GridMap &map)
    {
        if (!std::equal(graph.coordinates().begin(), graph.coordinates().end(),
                        map.graph->coordinates().begin()))
            note({"lost: the vertices' numbers; a map's cells are numbered row by row"});
    }

    void convertInstance()
    {
        const LoadedInstance loaded =
            loadInstance({request_.in, request_.graph, std::nullopt, request_.passability});
        note(loaded.warnings);
        if (holdsSolution(in_))
            note({"lost: the moves"});
        const Instance &instance = loaded.instance;
        noteLosses(*instance.graph);
        noteNames(loaded);
        if (target_.id == FormatId::cpf)
            return write(request_.out, formatCpf(instance));
        const GridMap *map = loaded.map ? &*loaded.map : nullptr;
        if (target_.id == FormatId::libMrpInstance)
        {
            if (const auto grid = loaded.vertexNames.empty() ? gridMapIfOne(*instance.graph) : std::nullopt)
                noteRenumbering(*instance.graph, *grid);
            return write(request_.out, asTarget(
                                           [&] {
                                               return formatLibMrpInstance(
                                                   instance, {loaded.vertexNames, loaded.robotNames, map},
                                                   target_.libMrp);
                                           }));
        }
        if (target_.id == FormatId::vetandInstance)
        {
            const std::string text = asTarget([&] { return formatVetandInstance(instance, map); });
            const auto points = instance.graph->coordinates();
            if (!std::is_sorted(points.begin(), points.end(),
                                [](const Point &p, const Point &q)
                                { return std::pair(p.y, p.x) < std::pair(q.y, q.x); }))
                note({"lost: the vertices' numbers; a map's cells are numbered row by row"});
            return write(request_.out, text);
        }
        convertOnGraph(loaded);
    }

    void noteNames(const LoadedInstance &loaded)
    {
        const bool isYaml = target_.id == FormatId::libMrpInstance;
        if (!loaded.vertexNames.empty() && (!isYaml || target_.libMrp == LibMrpForm::map))
            note({"lost: the vertices' names"});
        if (!loaded.robotNames.empty() && !isYaml)
            note({"lost: the robots' names"});
    }

    /// An instance whose graph stands in another file.
    void convertOnGraph(const LoadedInstance &loaded)
    {
        const Instance &instance = loaded.instance;
        const auto [graphFile, map] = asTarget([&] { return graphFor(loaded); });
        if (target_.id != FormatId::instanceText &&
            graphFile.parent_path().lexically_normal() != request_.out.parent_path().lexically_normal())
            note({"the map does not lie beside it, as its name alone stands in the file: " +
                  graphFile.string()});
        if (map && target_.id == FormatId::scenario)
            return write(request_.out, formatMovingAiScenario(*map, instance, graphFile.filename().string(),
                                                              {.listener = listener_}));
        if (target_.id == FormatId::kei18Instance)
            return write(request_.out,
                         asTarget([&, &file = graphFile]
                                  { return formatKei18Instance(instance, file.filename().string()); }));
        saveInstance(files_, request_.out, instance, graphFile,
                     target_.id == FormatId::scenario ? InstanceForm::scenario : InstanceForm::text,
                     listener_);
        result_.files.push_back(request_.out);
    }

    /// Where the graph of the new instance lies: where it lay before if that suits, else beside the instance.
    /// With the map, if one is needed and lies there already.
    std::pair<std::filesystem::path, std::optional<GridMap>> graphFor(const LoadedInstance &loaded)
    {
        const Instance &instance = loaded.instance;
        const bool needsMap = target_.id != FormatId::instanceText;
        const auto known = request_.graph ? request_.graph : graphFileOf(request_.in);
        std::error_code error;
        if (known && std::filesystem::exists(*known, error))
        {
            if (!needsMap)
                return {*known, std::nullopt};
            if (auto map = loadGraph(*known, passability(request_.passability)).map;
                map && formatOf(*known, readFile(*known)) == FormatId::movingAiMap)
                return {*known, std::move(map)};
        }
        std::filesystem::path file = request_.out;
        file.replace_extension(needsMap ? ".map" : ".graphml");
        const std::string text = !needsMap    ? formatGraphMl(*instance.graph)
                                 : loaded.map ? formatMovingAiMap(*loaded.map)
                                              : mapText(*instance.graph);
        if (std::filesystem::exists(file, error) && readFile(file) != text)
            throw InputError("its graph would be written to " + file.string() +
                             ", but there is another file of that name");
        write(file, text);
        note({"the graph is in a file of its own: " + file.string()});
        return {file, needsMap ? loaded.map : std::nullopt};
    }

    void convertSolution()
    {
        if (!request_.instance && !holdsInstance(in_))
            throw InputError({request_.in.string()},
                             "a solution can only be read with its instance; name it (--instance FILE)");
        const std::filesystem::path instanceFile = request_.instance.value_or(request_.in);
        const LoadedInstance loaded =
            loadInstance({instanceFile, request_.graph, std::nullopt, request_.passability});
        note(loaded.warnings);
        const Instance &instance = loaded.instance;
        noteLosses(*instance.graph);
        const SolutionRows rows = loadSolution(request_.in, loaded);
        note(rows.warnings);
        const Schedule schedule = scheduleOf(rows, instance);
        if (!validate(instance, schedule, MotionRule::rotation).complete)
            note({"not all robots end at their goals"});
        if (target_.id == FormatId::graphRecXml)
            note({"lost: the robots' goals"});
        if (target_.id == FormatId::graphRec || target_.id == FormatId::graphRecXml)
        {
            saveAnimation(files_, request_.out, instance, schedule,
                          target_.id == FormatId::graphRec ? GraphRecForm::text : GraphRecForm::xml);
            result_.files.push_back(request_.out);
            return;
        }
        write(request_.out, asTarget([&] { return solutionText(loaded, schedule, instanceFile); }));
    }

    std::string solutionText(const LoadedInstance &loaded, const Schedule &schedule,
                             const std::filesystem::path &instanceFile) const
    {
        const Instance &instance = loaded.instance;
        switch (target_.id)
        {
        case FormatId::surynekSolution:
            return formatSurynekSolution(schedule);
        case FormatId::kei18Result: {
            const auto graph = request_.graph ? request_.graph : graphFileOf(instanceFile);
            const auto map = graph ? graph->filename() : instanceFile.stem().concat(".map");
            return formatKei18Result(instance, schedule, map.string());
        }
        case FormatId::libMrpSchedule:
            return formatLibMrpSchedule(instance, schedule, loaded.vertexNames, loaded.robotNames);
        case FormatId::vetandResult:
            return formatVetandResult(instance, schedule, loaded.map ? &*loaded.map : nullptr);
        case FormatId::paths:
            return formatPaths(instance, schedule);
        case FormatId::planViz:
            return formatPlanViz(instance, schedule,
                                 std::string_view(target_.name) == "planviz_2_0" ? PlanVizVersion::upTo2_0
                                                                                 : PlanVizVersion::current);
        case FormatId::trackerCsv:
        case FormatId::trackerJson: {
            const auto name = trackerName(instanceFile.filename().string());
            if (!name)
                throw InputError(
                    "the tracker wants to know which of its scenarios this is; give the instance a "
                    "name like empty-8-8-even-1.scen");
            return formatTracker(instance, schedule,
                                 target_.id == FormatId::trackerCsv ? TrackerForm::csv : TrackerForm::json,
                                 *name);
        }
        default:
            return formatSolutionCsv(schedule);
        }
    }

    const ConversionRequest &request_;
    FormatId in_;
    const Target &target_;
    FileSet &files_;
    const Supervision::Listener &listener_;
    Conversion result_;
};

} // namespace

Conversion convertFile(const ConversionRequest &request)
{
    FileSet files;
    return convertFile(request, files, {});
}

Conversion convertFile(const ConversionRequest &request, FileSet &files,
                       const Supervision::Listener &listener)
{
    return Converter(request, files, listener).run();
}

} // namespace mrpp
