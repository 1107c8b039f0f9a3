#pragma once
/// \file
/// Which instances of a campaign are drawn, under which names and with which captions.

#include "framework/campaign/ResultTable.h"
#include "reports/drawing/Picture.h"

#include <string>
#include <vector>

namespace mrpp
{

/// An instance to be drawn.
struct LayoutPlan
{
    std::string name;                    ///< file name without extension
    std::string title;                   ///< of the problem, with its sweep point
    std::vector<const RunRecord *> runs; ///< on this very instance; never empty
};

/// The first repetition of every problem; of a sweep its smallest and its largest point. \pre the
/// results outlive the plans
[[nodiscard]] std::vector<LayoutPlan> plannedLayouts(const ResultTable &results);

struct Layout
{
    Picture picture;
    std::string caption; ///< what it is, its size and whose routes
};

/// Makes the instance again and draws it, with the routes of the first kept solution.
/// Throws DrawingError where that is not possible.
[[nodiscard]] Layout drawLayout(const ResultTable &results, const LayoutPlan &plan);

} // namespace mrpp
