#pragma once
/// \file
/// Exact answers for tiny instances, by breadth-first search over all configurations: the yardstick for
/// planners, condensing and solvability tests. Shares no code with them.
///
/// A configuration is packed into 64 bits, so robots · ⌈log2 vertices⌉ must not exceed 64. Some 10^6
/// configurations a second and 40 bytes each one move at a time; parallel steps multiply the time by their
/// number in each configuration. Problems of 7 robots on 9 vertices (181 440 configurations) take a second.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpp::test
{

/// The least number of steps under the rule; under `pebble` that is the least number of moves. Nothing where
/// the instance is unsolvable under the rule. Throws std::length_error where the search meets more than
/// `limit` configurations or they do not fit 64 bits.
[[nodiscard]] std::optional<std::uint32_t> leastMakespan(const Instance &instance, MotionRule rule,
                                                         std::size_t limit = 5'000'000);

/// The least number of moves, one robot at a time.
[[nodiscard]] inline std::optional<std::uint32_t> fewestMoves(const Instance &instance,
                                                              std::size_t limit = 5'000'000)
{
    return leastMakespan(instance, MotionRule::pebble, limit);
}

/// Whether there is any solution under the rule; throws as leastMakespan().
[[nodiscard]] inline bool isSolvable(const Instance &instance, MotionRule rule, std::size_t limit = 5'000'000)
{
    // Three rules solve the same instances, and the pebble rule's steps are the fewest to try.
    return leastMakespan(instance, rule == MotionRule::rotation ? rule : MotionRule::pebble, limit)
        .has_value();
}

} // namespace mrpp::test
