#pragma once

#include "framework/PlannerStatus.h"

namespace mrpp
{

/// What a planner is, too, whose answer still has to be read when solve() is over: outside of the run's time
/// and limits.
class LateAnswer
{
public:
    LateAnswer() = default;
    virtual ~LateAnswer() = default;
    LateAnswer(const LateAnswer &) = delete;
    LateAnswer &operator=(const LateAnswer &) = delete;

    /// Called once after solve(), where that said `solved`. Returns what it is after all; the planner's
    /// solution() and reason() hold it then.
    virtual PlannerStatus collect() = 0;
};

} // namespace mrpp
