#pragma once
/// \file
/// What robots may do in one step. Under every rule a robot moves along one edge or waits, no two robots
/// stand on one vertex, and no two swap along an edge.

#include <optional>
#include <string_view>

namespace mrpp
{

/// Each rule allows what the one before it allows. What can be solved is the same under the first three and
/// larger under `rotation`.
enum class MotionRule
{
    pebble,    ///< one robot a step, into a vertex that is empty
    parallel,  ///< many at once, each into a vertex that is empty at the step's start
    following, ///< a vertex may be entered in the step in which it is left, but no closed cycle of robots
               ///< turns
    rotation,  ///< following, and closed cycles of three or more robots may turn at once
};

[[nodiscard]] std::string_view toString(MotionRule rule);

/// The rule of that name, if there is one.
[[nodiscard]] std::optional<MotionRule> motionRule(std::string_view name);

} // namespace mrpp
