#pragma once
/// \file
/// Who carries a run out: here in this process; worker processes stand behind the same interface.

#include "framework/model/Instance.h"
#include "framework/model/Solution.h"
#include "framework/run/ProgressSampler.h"
#include "framework/run/RunRecord.h"

#include <memory>
#include <stop_token>

namespace mrpp
{

struct RunSpec;

/// A finished run.
struct RunResult
{
    RunRecord record;
    Solution solution;                        ///< the planner's, checked; empty where there is none
    Solution optimized;                       ///< after the optimizers, checked; empty without them
    std::shared_ptr<const Instance> instance; ///< what the planner was asked; null where there is none
    Progress progress;                        ///< of solve(); empty for planners without such properties
    bool startedProcesses = false;            ///< the planner did
    bool paused = false;       ///< who measured it stood still for a while: it has to be measured again
    bool lastOfWorker = false; ///< its process is spoiled for other runs, and ends
};

class Executor
{
public:
    Executor() = default;
    virtual ~Executor() = default;
    Executor(const Executor &) = delete;
    Executor &operator=(const Executor &) = delete;

    /// Carries one run out. Whatever the planner does, a record comes back: a planner's exception is a
    /// `crash`, a wrong solution `invalid`. May be called from several threads at once. Robots
    /// that do not fit a graph drawn by chance make an `unsupported` run. Throws InputError where the
    /// instance cannot be made for another reason, and HarnessError where something else than the planner
    /// failed.
    [[nodiscard]] virtual RunResult execute(const RunSpec &spec, const std::stop_token &stop) = 0;
};

} // namespace mrpp
