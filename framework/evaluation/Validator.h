#pragma once
/// \file
/// Replays answers and says whether they are right. Trusts nobody: shares no code with planners, condensing
/// or optimizers, and checks every move of every answer against the instance and the motion rule.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace mrpp
{

/// What the validator found.
struct Verdict
{
    bool legal = true;      ///< every move may be made
    std::size_t atGoal = 0; ///< robots on their goals at the end (or where the replay stopped)
    bool complete = true;   ///< every robot is at its goal at the end (or where the replay stopped)
    /// The first thing that is wrong, naming step, robots and vertices, and the wider rule under which the
    /// step would be legal where there is one; empty where valid.
    std::string violation;
    std::size_t badMove = 0; ///< index of the first bad move among all moves; their number where none is bad

    [[nodiscard]] bool valid() const { return legal && complete; }
};

/// Replays a sequential answer; its steps are its actions. Rotations must be closed cycles and are legal
/// under `rotation` only. O(V + robots + moves · log degree), as are the others.
[[nodiscard]] Verdict validate(const Instance &instance, const Solution &solution, MotionRule rule);

/// Replays a parallel answer.
[[nodiscard]] Verdict validate(const Instance &instance, const Schedule &schedule, MotionRule rule);

/// A move as a file from outside gives it: nothing is known about its numbers.
struct TimedMove
{
    std::int64_t step = 0;
    std::int64_t robot = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
};

/// Replays the rows of a solution file in their order: steps must be 0, 1, 2, … without gaps, robots and
/// vertices must exist, and no step may break the motion rule. Any numbers are safe.
[[nodiscard]] Verdict validate(const Instance &instance, std::span<const TimedMove> rows, MotionRule rule);

} // namespace mrpp
