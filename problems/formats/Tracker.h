#pragma once
/// \file
/// Plans of the MAPF tracker (tracker.pathfinding.ai) as CSV and JSON: for each robot a string of the letters
/// u d l r w, with or without counts in front ("5r2d3w").
///
/// \code
/// map_name,scen_type,type_id,agents,solution_plan,flip_up_down
/// empty-8-8,even,1,2,"5r2d
/// 2u3wl",FALSE
/// \endcode

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/SolutionRows.h"

#include <optional>
#include <string>
#include <string_view>

namespace mrpp
{

/// How the tracker names a benchmark instance: `empty-8-8`, `even` or `random`, 1 to 25.
struct TrackerName
{
    std::string map;
    std::string type;
    int number = 0;
};

/// The name within a file name like `empty-8-8-even-1.scen`, if it has that form.
[[nodiscard]] std::optional<TrackerName> trackerName(std::string_view fileName);

enum class TrackerForm
{
    csv,
    json,
};

/// What is known of an instance beside itself; empty or 0 where it is not.
struct TrackerContext
{
    std::string map = {};  ///< the map's name without extension
    std::string type = {}; ///< of the scenario
    int number = 0;
};

/// Reads the plan of this instance out of a file, which may hold those of other maps, scenarios and numbers
/// of robots. Where several remain, it is the only one that solves the instance, with a warning. d goes to
/// the next row unless `flip_up_down` says otherwise. Old downloads have no such field and turn up and down:
/// where it is missing, and the plan is valid for the instance that way only, it is read that way, with a
/// warning. Throws ParseError where the file breaks its form, holds no plan of this map and scenario, several
/// that may be meant, or a robot leaves the graph; InputError where the graph does not lie on cells.
[[nodiscard]] SolutionRows parseTracker(std::string_view text, const std::string &file, TrackerForm form,
                                        const Instance &instance, const TrackerContext &context = {});

/// With counts, d to the next row. Throws InputError where the graph does not lie on cells or a move does not
/// go to a cell beside.
[[nodiscard]] std::string formatTracker(const Instance &instance, const Schedule &schedule, TrackerForm form,
                                        const TrackerName &name);

} // namespace mrpp
