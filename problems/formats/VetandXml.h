#pragma once
/// \file
/// Instances and answers of V. Andreev's program Push and Rotate (github.com/vetand/PushAndRotate), in XML:
/// robots on a grid, and where each of them goes in which step.
///
/// \code
/// <root>
///   <map>
///     <width>3</width> <height>2</height>
///     <agents>
///       <agent id="1"> <startx>0</startx> <starty>0</starty> <finishx>2</finishx> <finishy>0</finishy>
///       </agent>
///     </agents>
///     <grid> <row>0 0 0</row> <row>0 1 0</row> </grid>
///     <allowdiagonal>false</allowdiagonal> <cutcorners>false</cutcorners> <allowsqueeze>false</allowsqueeze>
///   </map>
///   <log>                                       (in an answer)
///     <paths> <agent id="1"> <movement x="1" y="0" step="0"/> </agent> </paths>
///   </log>
/// </root>
/// \endcode
///
/// x is the column, y the row, from the upper left corner; 1 is an obstacle. Robots count from 1, steps from
/// 0; a movement says where the robot stands after its step.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/MovingAiMap.h"
#include "problems/formats/SolutionRows.h"

#include <optional>
#include <string>
#include <string_view>

namespace mrpp
{

struct VetandInstance
{
    Instance instance; ///< robots in the order of their ids; with diagonal edges where the file allows them
    std::optional<GridMap> map; ///< where it allows none
};

/// The map of an instance or answer. Diagonal neighbours are joined under `allowdiagonal`; past one obstacle
/// beside the way under `cutcorners`, between two under `allowsqueeze`. Throws ParseError where an element is
/// missing or not known, rows do not fit the size, or robots stand on obstacles or each other.
[[nodiscard]] VetandInstance parseVetandInstance(std::string_view text, const std::string &file);

/// \param map of the graph, which may end with rows of obstacles; found where it is null
/// Throws InputError where the graph is no grid whose neighbours are joined as one of these rules says.
[[nodiscard]] std::string formatVetandInstance(const Instance &instance, const GridMap *map = nullptr);

/// The moves of an answer. Throws ParseError for what is none, a robot that the instance does not have, and
/// cells that are no vertices; NoSolution where there is no `<log>`, as the program gave up.
[[nodiscard]] SolutionRows parseVetandResult(std::string_view text, const std::string &file,
                                             const Instance &instance);

/// Throws as formatVetandInstance() does.
[[nodiscard]] std::string formatVetandResult(const Instance &instance, const Schedule &schedule,
                                             const GridMap *map = nullptr);

} // namespace mrpp
