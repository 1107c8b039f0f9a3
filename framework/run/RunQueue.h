#pragma once
/// \file
/// The order in which runs are carried out, and who takes the next one.

#include "framework/plan/BenchmarkPlan.h"

#include <cstddef>
#include <mutex>
#include <vector>

namespace mrpp
{

/// Cases in random order, and the planners of each case, so that a slow spell of the machine does not hit one
/// planner or one part of a sweep. Each taker works case by case, as its worker then has the instance
/// already; when no case is left untouched it helps with those of others.
class RunQueue
{
public:
    /// \param seed of the order \param takers how many will call take()
    RunQueue(std::vector<RunSpec> runs, Seed seed, std::size_t takers);

    /// The next run for that taker, 0 … takers − 1; null where none is left. From any thread.
    [[nodiscard]] const RunSpec *take(std::size_t taker);

    [[nodiscard]] std::size_t size() const { return runs_.size(); }

private:
    /// The runs of a case that are not taken yet: places in runs_.
    struct Case
    {
        std::size_t next = 0;
        std::size_t end = 0;
    };

    std::vector<RunSpec> runs_;
    std::vector<Case> cases_;
    std::mutex mutex_;              // guards what follows, and cases_
    std::size_t untouched_ = 0;     ///< the first case that nobody has begun
    std::size_t unfinished_ = 0;    ///< all cases before it are taken whole
    std::vector<std::size_t> case_; ///< of each taker; cases_.size() where it has none
};

} // namespace mrpp
