#pragma once
/// \file
/// Paths as EECBS and MAPF-LNS write them: one robot a line, the cells that it visits, row before column.
///
/// \code
/// Agent 0: (5,16)->(5,17)->(6,17)->
/// Agent 1: (21,29)->
/// \endcode
///
/// A path has a cell for each time from 0 on and ends at the arrival.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/SolutionRows.h"

#include <string>
#include <string_view>

namespace mrpp
{

/// Throws ParseError where a line breaks the grammar, robots are not 0, 1, 2, …, or one stands on no vertex;
/// InputError where the graph does not lie on cells.
[[nodiscard]] SolutionRows parsePaths(std::string_view text, const std::string &file,
                                      const Instance &instance);

/// Throws InputError where the graph does not lie on cells.
[[nodiscard]] std::string formatPaths(const Instance &instance, const Schedule &schedule);

} // namespace mrpp
