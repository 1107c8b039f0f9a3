#pragma once
/// \file
/// Solutions and schedules as rows of moves, this program's own format and the one in which answers of others
/// are checked.
///
/// \code
/// step,robot,from,to
/// 0,0,3,4
/// 1,1,7,8
/// \endcode
///
/// Robots and vertices count from 0. Rows are sorted by step, steps are 0, 1, 2, … without gaps, the rows of
/// one step happen at once, waits are not written.

#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"
#include "problems/formats/SolutionRows.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace mrpp
{

/// Reads the rows as they are; whether they make sense is the validator's business. Throws ParseError where
/// the heading is another, a row has not four cells, or a cell is no whole number. O(file).
[[nodiscard]] SolutionRows readSolutionCsv(const std::filesystem::path &file);
[[nodiscard]] SolutionRows parseSolutionCsv(std::string_view text, const std::string &file);

/// One step for each action: a move, or a rotation's moves together. O(moves).
[[nodiscard]] std::string formatSolutionCsv(const Solution &solution);
[[nodiscard]] std::string formatSolutionCsv(const Schedule &schedule);

} // namespace mrpp
