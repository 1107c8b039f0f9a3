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
/// order of the file. What a name in a schedule means, the roadmap alone knows.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/SolutionRows.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrpp
{

struct LibMrpInstance
{
    Instance instance;                    ///< with its graph
    std::vector<std::string> vertexNames; ///< of a roadmap; empty for a map
    std::vector<std::string> warnings;
};

/// Throws ParseError for what is no YAML or lacks a part, obstacles and robots outside the map or on each
/// other, robots without one goal, and maps of more than 2^21 cells.
[[nodiscard]] LibMrpInstance parseLibMrpInstance(std::string_view text, const std::string &file);

// Below, `vertexNames` are those of the roadmap; where they are empty, vertices are named by their numbers.

/// A grid where the graph is one and has no names, else a roadmap. Throws InputError where a roadmap has no
/// coordinates.
[[nodiscard]] std::string formatLibMrpInstance(const Instance &instance,
                                               std::span<const std::string> vertexNames = {});

/// Robots are agent0, agent1, …. A vertex is named by its cell or as in the roadmap. Throws ParseError for
/// what is no schedule, times that are not 0, 1, 2, …, and robots that stand on no vertex.
[[nodiscard]] SolutionRows parseLibMrpSchedule(std::string_view text, const std::string &file,
                                               const Instance &instance,
                                               std::span<const std::string> vertexNames = {});

/// Cells for a grid without names, else `v: <name>`.
[[nodiscard]] std::string formatLibMrpSchedule(const Instance &instance, const Schedule &schedule,
                                               std::span<const std::string> vertexNames = {});

} // namespace mrpp
