#pragma once
/// \file
/// Where a path between two vertices can lead at all: through the blocks between them, which are a path in
/// the tree of blocks and cut vertices. On a tree that is one path, whatever it costs; a search that knows it
/// does not look into side branches.
///
/// \code
/// BlockRoute route(blocks);
/// route.lead(start, goal);
/// if (route.has(v))
///     …
/// \endcode

#include "framework/analysis/Blocks.h"

#include <cstdint>
#include <vector>

namespace mrpp
{

/// Run many times on one graph, whose blocks must outlive it.
class BlockRoute
{
public:
    explicit BlockRoute(const Blocks &blocks)
        : blocks_(blocks), blockStamps_(blocks.count(), 0), topStamps_(blocks.preorder().size(), 0)
    {}

    /// Whether that saves much: on most vertices more than one block counts.
    [[nodiscard]] static bool isWorthwhile(const Blocks &blocks);

    /// From now on between these two. O(blocks between them). \pre they are of one component
    void lead(Vertex from, Vertex to);

    /// Whether v is a vertex of a block between the two. O(1).
    [[nodiscard]] bool has(Vertex v) const
    {
        const std::uint32_t block = blocks_.towardsRoot(v);
        return topStamps_[v] == stamp_ || (block != Blocks::kNoBlock && blockStamps_[block] == stamp_);
    }

private:
    const Blocks &blocks_;
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> blockStamps_; ///< equal to stamp_ for the blocks between
    std::vector<std::uint32_t> topStamps_;   ///< for the tops of these, and the two vertices
};

} // namespace mrpp
