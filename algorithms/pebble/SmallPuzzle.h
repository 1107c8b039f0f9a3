#pragma once
/// \file
/// Shortest solutions of boards with one blank and so few vertices that all their states fit a table.
///
/// Breadth-first search from both ends over the n! states, which Myrvold and Ruskey, "Ranking and unranking
/// permutations in linear time", IPL 79 (2001), number. For n = 9 some 10 ms and a megabyte at worst.

#include "algorithms/pebble/OneBlankBoard.h"
#include "framework/support/TerminationCondition.h"

#include <optional>
#include <vector>

namespace mrpp
{

/// The largest number of vertices that shortestWalk() takes.
inline constexpr std::size_t kSmallPuzzle = 9;

struct WalkSearch
{
    bool stopped = false;                    ///< by the termination condition; there may be a walk
    std::optional<std::vector<Vertex>> walk; ///< vertices that the blank goes to, its start not among them
};

/// The shortest walk of the blank over `vertices` that brings every one of them home; no walk where there is
/// none. \pre at most kSmallPuzzle vertices, on which stand those that belong there, the blank among them
[[nodiscard]] WalkSearch shortestWalk(const OneBlankBoard &board, std::span<const Vertex> vertices,
                                      const TerminationCondition &ptc);

} // namespace mrpp
