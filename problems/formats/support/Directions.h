#pragma once
/// \file
/// Paths on a grid as letters. Internal to the writers of this folder.

#include "framework/model/Instance.h"
#include "framework/model/Schedule.h"
#include "problems/formats/support/Cells.h"

#include <string>
#include <vector>

namespace mrpp
{

/// For each robot what it does in each step until its last move: u, d, l, r, or w for a wait; d goes to the
/// next row. Throws InputError where a move does not go to a cell beside.
[[nodiscard]] std::vector<std::string> directionsOf(const Instance &instance, const Schedule &schedule,
                                                    const Cells &cells);

} // namespace mrpp
