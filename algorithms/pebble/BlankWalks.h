#pragma once
/// \file
/// Between whole graphs, where robots have numbers, and the puzzles of their blocks, where everything is
/// named by where it has to go.

#include "algorithms/pebble/BlockPuzzle.h"
#include "framework/analysis/Blocks.h"
#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "framework/support/Random.h"

#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

/// In words, with vertices of the whole graph. \pre what != BlockObstacle::none
[[nodiscard]] std::string describe(BlockObstacle what, const Blocks &blocks, std::uint32_t block);

/// The moves that a walk of the blank makes, once what is taken back at once is taken out of it. Where it
/// comes to a free vertex nothing moves.
/// \param occupants who stands where before; kNoRobot on free vertices
/// \return nothing where the termination condition says stop
[[nodiscard]] std::optional<Solution> movesOf(std::vector<Vertex> walk, std::vector<Robot> occupants,
                                              const TerminationCondition &ptc);

/// Who stands where at the start. Size = vertices.
[[nodiscard]] std::vector<Robot> occupantsAtStart(const Instance &instance);

} // namespace mrpp
