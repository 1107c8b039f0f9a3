#include "algorithms/RestartingPlanner.h"

#include "algorithms/optimizers/RedundancyRemoval.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace mrpp
{

namespace
{

bool hasSolution(PlannerStatus status)
{
    return status == PlannerStatus::solved || status == PlannerStatus::partial;
}

/// The best of the attempts so far; for several threads.
class Best
{
public:
    Best(const Instance &instance, const TerminationCondition &ptc) : instance_(instance), ptc_(ptc) {}

    void offer(std::uint64_t number, RestartingPlanner::Outcome outcome)
    {
        const std::size_t away = hasSolution(outcome.status) ? awayAfter(outcome.solution) : kNoSolution;
        const std::size_t length =
            away == 0 ? RedundancyRemoval().improve(instance_, outcome.solution, ptc_).pathLength()
                      : outcome.solution.pathLength();
        const Key key{away, length, number};
        const std::lock_guard lock(mutex_);
        if (key < key_)
        {
            key_ = key;
            outcome_ = std::move(outcome);
        }
    }

    void fail(std::exception_ptr error)
    {
        const std::lock_guard lock(mutex_);
        error_ = std::move(error);
    }

    /// \pre every thread has ended and something was offered
    RestartingPlanner::Outcome take()
    {
        if (error_)
            std::rethrow_exception(error_);
        return std::move(outcome_);
    }

private:
    /// The fewer robots not at their goals the better, then by length, then by number.
    using Key = std::tuple<std::size_t, std::size_t, std::uint64_t>;
    static constexpr std::size_t kNoSolution = static_cast<std::size_t>(-2);

    [[nodiscard]] std::size_t awayAfter(const Solution &solution) const
    {
        std::vector<Vertex> positions = instance_.starts;
        for (const Move &move : solution.moves())
            positions[move.robot] = move.to;
        std::size_t away = 0;
        for (Robot r = 0; r < positions.size(); ++r)
            away += positions[r] == instance_.goals[r] ? 0U : 1U;
        return away;
    }

    const Instance &instance_;
    const TerminationCondition &ptc_;
    std::mutex mutex_;
    Key key_{kNoSolution + 1, 0, 0};
    RestartingPlanner::Outcome outcome_{};
    std::exception_ptr error_;
};

} // namespace

RestartingPlanner::RestartingPlanner(PlannerSpecs specs) : Planner(std::move(specs))
{
    declareParam("restarts", restarts_, "1:1000000",
                 "attempts with other orders and tie-breaks; the shortest after redundancy removal is kept");
    declareParam("threads", threads_, "0:256",
                 "threads for the restarts; 0: as many as the machine has cores");
}

PlannerStatus RestartingPlanner::solve(const TerminationCondition &ptc)
{
    Outcome outcome = attempt(0, ptc);
    // The first attempt's proof, refusal or end of time stands; only chance can be tried again.
    const bool again = hasSolution(outcome.status) || outcome.status == PlannerStatus::gave_up;
    if (restarts_ > 1 && again && !ptc())
    {
        Best best(instance(), ptc);
        best.offer(0, std::move(outcome));
        std::atomic<std::uint64_t> next = 1;
        const auto restarts = static_cast<std::uint64_t>(restarts_);
        const auto work = [&]
        {
            try
            {
                for (std::uint64_t number = next++; number < restarts && !ptc(); number = next++)
                    best.offer(number, attempt(number, ptc));
            }
            catch (...)
            {
                best.fail(std::current_exception());
                next = restarts;
            }
        };
        const std::uint64_t cores = threads_ > 0 ? static_cast<std::uint64_t>(threads_)
                                                 : std::max(1U, std::thread::hardware_concurrency());
        {
            std::vector<std::jthread> helpers;
            for (std::uint64_t i = 1; i < std::min(cores, restarts); ++i)
                helpers.emplace_back(work);
            work();
        }
        outcome = best.take();
    }
    if (hasSolution(outcome.status))
        setSolution(std::move(outcome.solution));
    return because(outcome.status, std::move(outcome.reason));
}

} // namespace mrpp
