#pragma once
/// \file
/// What no solution can beat: each robot needs at least its shortest path.

#include "framework/model/Instance.h"

#include <cstdint>
#include <optional>

namespace mrpp
{

struct LowerBounds
{
    std::uint64_t pathLength = 0; ///< moves: the sum over robots of the distance from start to goal
    std::uint64_t makespan = 0;   ///< steps: the largest of these distances
};

/// Nothing where some goal cannot be reached from its start. One bidirectional breadth-first search a robot.
[[nodiscard]] std::optional<LowerBounds> lowerBounds(const Instance &instance);

} // namespace mrpp
