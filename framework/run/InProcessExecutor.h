#pragma once
/// \file
/// Carries runs out in this process: fast and simple, but a planner that dies takes the campaign with it, and
/// one that ignores its termination condition holds it up.

#include "framework/Catalog.h"
#include "framework/plan/BenchmarkPlan.h"
#include "framework/plan/Configuration.h"
#include "framework/run/Executor.h"
#include "framework/run/InputWatch.h"
#include "framework/run/RecentCache.h"
#include "framework/run/RunPlanner.h"
#include "framework/system/PauseWatch.h"

#include <functional>
#include <memory>

namespace mrpp
{

class InProcessExecutor final : public Executor
{
public:
    /// Called with the configured planner before it gets its instance.
    using PreRunEvent = std::function<void(Planner &, const RunSpec &)>;

    /// \param plan and \param catalog must outlive the executor
    /// \param jobs how many threads will call execute() at once; memory is measured where it is one
    InProcessExecutor(const BenchmarkPlan &plan, const Catalog &catalog, std::int64_t jobs,
                      PreRunEvent preRun = {});

    /// Told when a phase of a run begins.
    void setPhaseEvent(std::function<void(RunPhase, const RunRecord &)> event)
    {
        onPhase_ = std::move(event);
    }

    /// Whether the runs to come are measured by what plugins added (Catalog::metrics).
    void setAddsMetrics(bool adds) { addsMetrics_ = adds; }

    /// What the input files have to hold whenever they are read; without it nothing is checked.
    void setInputs(std::shared_ptr<InputWatch> inputs) { inputs_ = std::move(inputs); }

    /// Throws HarnessError also where an input file has changed.
    [[nodiscard]] RunResult execute(const RunSpec &spec, const std::stop_token &stop) override;

    /// The instance of the run's case. Throws InputError (DoesNotFit) where there is none.
    [[nodiscard]] std::shared_ptr<const PreparedInstance> instance(const RunSpec &spec,
                                                                   const std::stop_token &stop = {});

private:
    [[nodiscard]] RunResult executeOnce(const RunSpec &spec, const std::stop_token &stop);
    void checkCommand(const RunSpec &spec) const;
    void checkInputs(const Problem &problem) const;
    void addMetrics(RunResult &result) const;
    [[nodiscard]] std::shared_ptr<const Graph> graph(const RunSpec &spec);

    const BenchmarkPlan &plan_;
    const Catalog &catalog_;
    std::shared_ptr<InputWatch> inputs_; ///< or null
    PauseWatch pauses_;
    bool addsMetrics_ = true;
    std::int64_t jobs_;
    PreRunEvent preRun_;
    std::function<void(RunPhase, const RunRecord &)> onPhase_;
    RecentCache<std::shared_ptr<const Graph>> graphs_;
    RecentCache<std::shared_ptr<const PreparedInstance>> instances_;
};

} // namespace mrpp
