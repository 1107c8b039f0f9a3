#pragma once
/// \file
/// Folders of one campaign's parts into one folder, as if the campaign had run there.
///
/// \code
/// const auto merged = mergeCampaigns("results/all", {"results/shard1", "results/shard2"});
/// \endcode

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mrpp
{

struct MergedCampaign
{
    std::size_t runs = 0;           ///< that `out` has now
    std::size_t taken = 0;          ///< of them new
    std::size_t twice = 0;          ///< that two folders had
    std::vector<std::string> notes; ///< about folders whose parts ran under another version
};

/// Joins the campaigns in `folders` (shards, finished or not, and goes at the same shard) in `out`: results,
/// kept instances and solutions, plan and provenance. Merging a folder again changes nothing. What `out`
/// holds of this campaign stays; a new one appears as a whole, an old one gets all new results at once, or
/// nothing happens. `out` itself may stand among the folders. Throws InputError where the plans differ or two
/// answers to one question do, naming both places, and FileError where a folder holds no campaign, or `out`
/// is in use or holds something else.
MergedCampaign mergeCampaigns(const std::filesystem::path &out,
                              std::span<const std::filesystem::path> folders);

} // namespace mrpp
