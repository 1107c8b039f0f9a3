#pragma once
/// \file
/// Which pictures of a campaign's instances there are, under which names and with which captions.

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
    bool showsStructure = true;          ///< false where the plan before has the same graph
    std::vector<const RunRecord *> runs; ///< on this very instance; never empty
};

/// The first repetition of every problem; of a sweep its smallest and its largest point. \pre the
/// results outlive the plans
[[nodiscard]] std::vector<LayoutPlan> plannedLayouts(const ResultTable &results);

struct Layout
{
    std::string name; ///< file name without extension
    Picture picture;
    std::string missing; ///< why there is no picture; empty where there is one
    std::string caption; ///< what it is, its size and whose routes; can stand alone
};

/// Makes the instance again and draws it: with the routes of the first kept solution; the structure of its
/// graph (`NAME-structure`, up to kLargestGraph vertices); and key steps of that solution (`NAME-steps`).
/// What cannot be drawn is missing alone.
[[nodiscard]] std::vector<Layout> drawLayouts(const ResultTable &results, const LayoutPlan &plan);

} // namespace mrpp
