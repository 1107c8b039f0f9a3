#pragma once
/// \file
/// Which pictures of a campaign's instances there are, under which names and with which captions.

#include "framework/store/ResultTable.h"
#include "reports/picture/Picture.h"

#include <filesystem>
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
    Picture picture = {};
    std::string missing = {}; ///< why there is no picture; empty where there is one
    std::string caption;      ///< what it is, its size and whose routes; can stand alone
    std::string inputs = {};  ///< a hash of all that it was drawn from
    bool isFresh = true;      ///< false where the folder held it already
};

/// Makes the instance again and draws it: with the routes of the first kept solution; the structure of its
/// graph (`NAME-structure`, up to kLargestGraph vertices); and key steps of that solution (`NAME-steps`).
/// What cannot be drawn is missing alone. A layout that `folder` holds, drawn by this program from the same
/// inputs, is taken from there: NAME.txt is written after the pictures, so it vouches for them.
[[nodiscard]] std::vector<Layout> drawLayouts(const ResultTable &results, const LayoutPlan &plan,
                                              const std::filesystem::path &folder);

/// Writes the pictures and last NAME.txt, where they are not there already: the caption, and what vouches for
/// the pictures. Returns the files' paths. Throws FileError. \pre it is not missing
std::vector<std::filesystem::path> writeLayout(const Layout &layout, const std::filesystem::path &folder);

} // namespace mrpp
