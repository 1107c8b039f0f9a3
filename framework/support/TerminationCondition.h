#pragma once
/// \file
/// When a planner has to stop: a deadline, a request from outside, or any condition of the caller's.
///
/// \code
/// PlannerStatus MyPlanner::solve(const TerminationCondition &ptc)
/// {
///     while (work())
///         if (ptc())
///             return PlannerStatus::timeout;
/// }
/// \endcode
///
/// A call costs about as much as reading the monotonic clock (some 25 ns): call it every few microseconds of
/// work, and at least every 50 ms.

#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>

namespace mrpp
{

class TerminationCondition
{
public:
    using Clock = std::chrono::steady_clock;

    /// Never stops.
    TerminationCondition() = default;

    [[nodiscard]] static TerminationCondition never() { return {}; }

    /// Stops `seconds` (wall time) after this call.
    [[nodiscard]] static TerminationCondition after(double seconds);

    /// Stops when the token is triggered.
    [[nodiscard]] static TerminationCondition when(std::stop_token stop);

    /// Stops when the predicate says so. The predicate must be cheap and may be called from several threads.
    [[nodiscard]] static TerminationCondition when(std::function<bool()> predicate);

    /// Stops as soon as one of the two does.
    [[nodiscard]] TerminationCondition operator||(const TerminationCondition &other) const;

    /// True when the planner has to stop; stays true for deadlines and tokens.
    [[nodiscard]] bool operator()() const
    {
        return (stop_.stop_possible() && stop_.stop_requested()) ||
               (deadline_ && Clock::now() >= *deadline_) || (predicate_ && predicate_());
    }

    [[nodiscard]] const std::optional<Clock::time_point> &deadline() const { return deadline_; }

private:
    std::optional<Clock::time_point> deadline_;
    std::stop_token stop_;
    std::function<bool()> predicate_;
};

} // namespace mrpp
