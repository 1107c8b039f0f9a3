#pragma once
/// \file
/// Animations for GraphRec (P. Koupý, 2010, https://www.koupy.net/graphrec.php), in its text form
/// "Multirobot (*.txt)".
///
/// GraphRec counts robots and vertices from 1 here, draws y downwards, and looks right with some 60 units
/// between neighbours. A goal is the second and third number in a vertex's brackets, which GraphRec itself
/// does not show.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"

#include <string>

namespace mrpp
{

/// Steps in which nobody moves are left out, as GraphRec needs steps without gaps. Without coordinates
/// GraphRec lays the graph out itself.
/// \pre the schedule is legal on the instance
/// O(V + E + moves).
[[nodiscard]] std::string formatGraphRec(const Instance &instance, const Schedule &schedule);

} // namespace mrpp
