#pragma once
/// \file
/// The explorer: one HTML file that carries its program, its data and nothing else. The program is that of
/// reports/web/, built by Node; without it there is no page.
///
/// The data stand in <script> elements of types that browsers do not run: `explorer` holds JSON (in which `<`
/// is written \u003c), `runs`, `graphN`, `caseN`, `solutionN` and `optimizedN` hold packedText().

#include "framework/run/RunRecord.h"
#include "reports/explorer/PlayableRuns.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mrpp
{

struct ExplorerContents
{
    std::string title;
    std::vector<std::string> facts; ///< sentences
    std::vector<std::pair<std::string, std::string>> provenance;
    std::string plan;                  ///< YAML; empty where the page is not about a campaign
    std::vector<std::string> planners; ///< in the order of their styles
    std::span<const RunRecord> records;
    std::vector<std::string> absences; ///< for each record why it cannot be played; empty where it can
    const PlayableRuns *playable = nullptr;
};

/// Whether this program was built with the explorer.
[[nodiscard]] bool hasExplorer();

/// The page, the same for the same contents. Throws InputError where this program has no explorer.
[[nodiscard]] std::string explorerPage(const ExplorerContents &contents);

} // namespace mrpp
