#pragma once
/// \file
/// Figures that compare planners over many cases at once: cactus, performance profile, distribution function,
/// boxes, one planner against another, and mean ranks.

#include "reports/figures/FigureList.h"
#include "reports/summary/CaseTable.h"

#include <string>
#include <string_view>

namespace mrpp
{

/// For the whole campaign: cactus of times; where there are several planners also profiles, boxes of path
/// lengths over their bound, planner against planner, and ranks.
void addOverallFigures(FigureList &figures, const CaseTable &cases);

// Each of a cost column over these cases; `where` ends titles and captions ("on grid"). The caller names
// them.
[[nodiscard]] Figure cactusFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                  const std::string &where);
[[nodiscard]] Figure profileFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                   const std::string &where);
[[nodiscard]] Figure ecdfFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                const std::string &where);
/// \param bound a column to divide by, or empty
[[nodiscard]] Figure boxesFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                 std::string_view bound, const std::string &where);
/// \param x, y positions of two planners
[[nodiscard]] Figure scatterFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                   std::size_t x, std::size_t y, const std::string &where);
/// Throws DrawingError where the test refuses.
[[nodiscard]] Figure ranksFigure(const FigureList &figures, const CaseTable &cases, std::string_view column,
                                 const std::string &where);

} // namespace mrpp
