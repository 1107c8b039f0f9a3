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
    bool complete = true;   ///< every robot is at its goal at the end
    std::string
        violation; ///< the first thing that is wrong, naming step, robot and vertices; empty where valid
    std::size_t badMove = 0; ///< index of the first bad move among all moves, if there is one

    [[nodiscard]] bool valid() const { return legal && complete; }
};

/// Replays a sequential answer. Rotations are legal under `rotation` only. O(moves + robots + vertices).
[[nodiscard]] Verdict validate(const Instance &instance, const Solution &solution, MotionRule rule);

/// Replays a parallel answer. O(moves + robots + vertices).
[[nodiscard]] Verdict validate(const Instance &instance, const Schedule &schedule, MotionRule rule);

/// A move as a file from outside gives it: nothing is known about its numbers.
struct TimedMove
{
    std::int64_t step = 0;
    std::int64_t robot = 0;
    std::int64_t from = 0;
    std::int64_t to = 0;
};

/// Replays rows of a solution file: steps must be 0, 1, 2, … without gaps, rows in their order, robots and
/// vertices must exist, and all rules above hold.
[[nodiscard]] Verdict validate(const Instance &instance, std::span<const TimedMove> rows, MotionRule rule);

} // namespace mrpp
