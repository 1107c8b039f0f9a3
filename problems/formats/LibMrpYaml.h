#pragma once
/// \file
/// Instances and schedules of libMultiRobotPlanning (W. Hönig), in YAML: robots on a grid or on a roadmap.
///
/// \code
/// agents:                               schedule:
///   - {name: a, start: [0, 0],            agent0:
///      goal: [2, 0]}                        - {x: 0, y: 0, t: 0}
/// map:                                      - {x: 1, y: 0, t: 1}
///   dimensions: [3, 2]
///   obstacles: [[1, 1]]
/// \endcode
///
/// Points are column and row. A roadmap has `vertices: {name: [x, y], …}` and `edges: [[name, name], …]`
/// instead of the map, names as starts and goals, and a schedule with `v: name`; vertices are numbered in the
/// order of the file. What a name in a schedule means, the instance alone knows.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/SolutionRows.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct LibMrpInstance
{
    Instance instance;                    ///< with its graph
    std::optional<GridMap> map;           ///< where it is one
    std::vector<std::string> vertexNames; ///< of a roadmap; empty for a map
    std::vector<std::string> robotNames;  ///< empty where they are agent0, agent1, … or not all distinct
    std::vector<std::string> warnings;
};

/// Reads the inputs of cbs and its kind (a map), cbs_roadmap (a roadmap, with or without `vertices`), cbs_ta
/// (where each robot has one goal to choose from) and sipp (one robot, where nothing else moves). Throws
/// ParseError for what is no YAML or lacks a part, keys that are not known, obstacles and robots outside the
/// map or on each other, robots without one goal, conflicts between edges, and maps of more than 2^21 cells.
[[nodiscard]] LibMrpInstance parseLibMrpInstance(std::string_view text, const std::string &file);

enum class LibMrpForm
{
    fitting, ///< a map where the graph is one and has no names, else a roadmap
    map,
    roadmap,
};

/// What formatLibMrpInstance() may say beyond the instance.
struct LibMrpNames
{
    std::span<const std::string> vertices = {}; ///< of a roadmap; their numbers where empty
    std::span<const std::string> robots = {};   ///< agent0, agent1, … where empty
    const GridMap *map = nullptr;               ///< the graph's map, which may end with rows of obstacles
};

/// Throws InputError where the graph does not fit the form.
[[nodiscard]] std::string formatLibMrpInstance(const Instance &instance, const LibMrpNames &names = {},
                                               LibMrpForm form = LibMrpForm::fitting);

/// Robots are agent0, agent1, …, or called as in the instance. A vertex is named by its cell or as in the
/// roadmap. Times ascend from 0; a robot stays where it is until just before the next one. Throws ParseError
/// for what is no schedule and for robots that stand on no vertex, NoSolution where the file says that there
/// is none, for all robots or for one.
[[nodiscard]] SolutionRows parseLibMrpSchedule(std::string_view text, const std::string &file,
                                               const Instance &instance,
                                               std::span<const std::string> vertexNames = {},
                                               std::span<const std::string> robotNames = {});

/// Cells for a grid without names, else `v: <name>`.
[[nodiscard]] std::string formatLibMrpSchedule(const Instance &instance, const Schedule &schedule,
                                               std::span<const std::string> vertexNames = {},
                                               std::span<const std::string> robotNames = {});

} // namespace mrpp
