#pragma once
/// \file
/// Who carries a run out: here in this process; worker processes stand behind the same interface.

#include "framework/campaign/RunRecord.h"
#include "framework/model/Solution.h"

#include <stop_token>

namespace mrpp
{

struct RunSpec;

/// A finished run: its record, and the planner's solution where there is one.
struct RunResult
{
    RunRecord record;
    Solution solution;
};

class Executor
{
public:
    Executor() = default;
    virtual ~Executor() = default;
    Executor(const Executor &) = delete;
    Executor &operator=(const Executor &) = delete;

    /// Carries one run out. Whatever the planner does, a record comes back: a planner's exception is a
    /// `crash`, a wrong solution `invalid`. May be called from several threads at once.
    [[nodiscard]] virtual RunResult execute(const RunSpec &spec, std::stop_token stop) = 0;
};

} // namespace mrpp
