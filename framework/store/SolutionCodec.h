#pragma once
/// \file
/// Solutions in few bytes, for keeping many of them: each move as differences from the robot and the place
/// that are likely to come next, in variable-length integers. About 3 bytes a move instead of 12.

#include "framework/model/Solution.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

/// Any solution, also an illegal one, comes back the same from unpackSolution(). O(moves).
[[nodiscard]] std::vector<std::uint8_t> packSolution(const Solution &solution);

/// Nothing where the bytes are damaged. Needs no more memory than the bytes can stand for. O(bytes).
[[nodiscard]] std::optional<Solution> unpackSolution(std::span<const std::uint8_t> bytes);

} // namespace mrpp
