#pragma once
/// \file
/// Who plans first: robots with goals far from the middle, and, where robots of different subgraphs must not
/// lock each other in, one subgraph after another.

#include "framework/analysis/Landmarks.h"
#include "framework/analysis/Subgraphs.h"
#include "framework/model/Instance.h"
#include "framework/support/Random.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mrpp
{

/// The robots ordered by how far their goals are from the middle of their component (see Landmarks), the
/// farthest first: nobody who comes later has to pass there. O(V + E + robots · log robots).
[[nodiscard]] std::vector<Robot> farFirst(const Instance &instance, const Landmarks &landmarks);

/// Which subgraph's robots have to be at home before which other's: those whose goals lie behind the goals of
/// others on a corridor.
///
/// Source: B. de Wilde, A. W. ter Mors, C. Witteveen, JAIR 51 (2014), algorithm 3.
class SubgraphPriorities
{
public:
    /// \param assignment the subgraph of each robot, or kNoSubgraph; size = robots
    /// O(V + robots).
    SubgraphPriorities(const Subgraphs &subgraphs, const Instance &instance,
                       std::span<const std::uint32_t> assignment);

    /// The given order rearranged: the robots of a subgraph follow each other, no subgraph comes before one
    /// that has priority over it, and robots without a subgraph come last; otherwise the first of the given
    /// order is first. Subgraphs that have priority over each other, as in unsolvable instances, come before
    /// the last ones in any order. O(robots + subgraphs · log subgraphs + priorities).
    [[nodiscard]] std::vector<Robot> arrange(std::span<const Robot> order) const;

private:
    [[nodiscard]] std::vector<Robot> sortedByRank(std::span<const Robot> order,
                                                  std::span<const std::uint32_t> ranks) const;

    std::vector<std::uint32_t> assignment_;
    std::size_t subgraphCount_ = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> before_; ///< (first, later) subgraphs, sorted
};

} // namespace mrpp
