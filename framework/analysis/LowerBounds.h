#pragma once
/// \file
/// What no solution can beat: each robot needs at least its shortest path.
///
/// Shortest paths of all robots take a search a robot, which on large maps is more than anybody wants to
/// wait for. Where they would, weaker bounds are given in their place; which they are, they say.
///
/// | name | a robot needs at least |
/// |---|---|
/// | `distances` | its distance |
/// | `landmarks` | what landmarks see of its distance (Landmarks.h) |
/// | `displaced` | one step where its start is not its goal |
///
/// \code
/// const auto bounds = lowerBounds(instance, {.stop = TerminationCondition::after(1)});
/// if (bounds)
///     std::cout << bounds->pathLength << " (" << toString(bounds->means) << ")\n";
/// \endcode

#include "framework/model/Instance.h"
#include "framework/system/Supervision.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace mrpp
{

/// From the weakest to the strongest.
enum class BoundMeans : std::uint8_t
{
    displaced,
    landmarks,
    distances,
};

/// "distances", …
[[nodiscard]] const char *toString(BoundMeans means);

struct LowerBounds
{
    std::uint64_t pathLength = 0; ///< moves: the sum of the robots' bounds; also of their costs (steps)
    std::uint64_t makespan = 0;   ///< steps: the largest of these
    BoundMeans means = BoundMeans::distances;
};

/// Visits of vertices in all searches together that take some seconds.
inline constexpr std::uint64_t kReasonableVisits = 50'000'000;

/// Nothing where some goal cannot be reached from its start.
/// \param supervision ends the search for better bounds, and hears of the robots
/// \param mostVisits no more vertices are visited for `distances`; where the first robots need so many that
/// all would need more, they are not looked for further
[[nodiscard]] std::optional<LowerBounds>
lowerBounds(const Instance &instance, const Supervision &supervision = {},
            std::uint64_t mostVisits = std::numeric_limits<std::uint64_t>::max());

} // namespace mrpp
