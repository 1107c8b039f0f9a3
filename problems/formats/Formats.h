#pragma once
/// \file
/// One door to all formats: tells by a file's contents and extension what it is, reads it, or says which
/// formats there are.
///
/// \code
/// const LoadedInstance loaded = loadInstance({"room.scen", "room.map", 20});
/// \endcode

#include "framework/Catalog.h"
#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"
#include "framework/system/File.h"
#include "framework/system/Supervision.h"
#include "problems/formats/GraphRec.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/SolutionRows.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct LoadedGraph
{
    std::shared_ptr<const Graph> graph;
    std::optional<GridMap> map;           ///< where the file is a map of cells
    std::vector<std::string> warnings;    ///< see GraphMl
    std::vector<std::string> vertexNames; ///< of roadmaps, and of lists of edges with gaps; else empty
};

/// Reads a graph of any format, also out of a file that holds its robots too. Throws InputError where the
/// file holds no graph, or is malformed. \param rule which symbols of a MovingAI map robots may stand on
[[nodiscard]] LoadedGraph loadGraph(const std::filesystem::path &file,
                                    const Passability &rule = passability());

struct InstanceSource
{
    std::filesystem::path instance;             ///< of any format that holds robots
    std::optional<std::filesystem::path> graph; ///< overrides the graph that the instance names or holds
    std::optional<std::size_t> robots;          ///< how many of the file's robots; all where it is missing
    std::string passability = "movingai";       ///< of a MovingAI map, see passabilities()
};

struct LoadedInstance
{
    Instance instance;
    std::vector<std::string> warnings;
    std::vector<std::string> vertexNames;      ///< of a roadmap, whose schedules speak of them; else empty
    std::vector<std::string> robotNames = {};  ///< other ones than agent0, agent1, …; else empty
    std::optional<GridMap> map = std::nullopt; ///< where the graph is a map of cells
    std::string graphName = {};                ///< of the file in which the graph lies, without extension
    std::string scenario = {};                 ///< the instance's file name, which may tell its scenario
};

/// Reads an instance and its graph. Without `graph`, instance text names it, the map of a scenario or of
/// Kei18's text is looked for beside the file, and other formats hold it. Throws InputError where a file
/// cannot be used, the instance does not fit its graph or holds fewer robots than asked for.
[[nodiscard]] LoadedInstance loadInstance(const InstanceSource &source);

/// Reads a solution or schedule of any format. The moves may be wrong; validate() says so. Throws InputError
/// where the file is malformed or cannot speak of this instance.
[[nodiscard]] SolutionRows loadSolution(const std::filesystem::path &file, const LoadedInstance &loaded);
/// The same where nothing but the instance is known.
[[nodiscard]] SolutionRows loadSolution(const std::filesystem::path &file, const Instance &instance);

/// The file in which the graph of an instance file lies, if the instance says so. Throws InputError where the
/// instance cannot be read.
[[nodiscard]] std::optional<std::filesystem::path> graphFileOf(const std::filesystem::path &instance);

// The functions below write into a set of files, to be committed, or one file at once. All throw FileError
// where a file cannot be written.

/// Writes `.map` as a MovingAI map, everything else as GraphML. Throws InputError where the graph is no grid
/// map.
void saveGraph(FileSet &files, const std::filesystem::path &file, const Graph &graph);
void saveGraph(const std::filesystem::path &file, const Graph &graph);

enum class InstanceForm
{
    text,
    scenario,
};

/// Writes an instance as text or as a MovingAI scenario (the graph must then be a grid map); without `form`
/// `.scen` is a scenario, everything else text. Throws InputError where the graph of a scenario is no grid
/// map. \param listener hears of the lengths of a scenario's paths \param graphFile where the graph lies; the
/// instance names it relative to its own folder
void saveInstance(FileSet &files, const std::filesystem::path &file, const Instance &instance,
                  const std::filesystem::path &graphFile, std::optional<InstanceForm> form = std::nullopt,
                  const Supervision::Listener &listener = {});
void saveInstance(const std::filesystem::path &file, const Instance &instance,
                  const std::filesystem::path &graphFile, std::optional<InstanceForm> form = std::nullopt);

/// Writes CSV rows, see SolutionCsv.h.
void saveSolution(FileSet &files, const std::filesystem::path &file, const Solution &solution);
void saveSolution(FileSet &files, const std::filesystem::path &file, const Schedule &schedule);

/// Writes a GraphRec animation piece by piece: `.xml` as GraphRec's XML, everything else as its text, see
/// GraphRec.h. GraphRec is told the narrowest rule that the schedule obeys.
/// \pre the schedule is legal on the instance under `rotation`
void saveAnimation(FileSet &files, const std::filesystem::path &file, const Instance &instance,
                   const Schedule &schedule, std::optional<GraphRecForm> form = std::nullopt);
void saveAnimation(const std::filesystem::path &file, const Instance &instance, const Schedule &schedule);

/// What the functions above know, for `mrppsim list formats`.
[[nodiscard]] std::vector<FileFormat> fileFormats();

} // namespace mrpp
