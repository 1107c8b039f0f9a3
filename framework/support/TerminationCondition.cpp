#include "framework/support/TerminationCondition.h"

#include <algorithm>

namespace mrpp
{

TerminationCondition TerminationCondition::after(double seconds)
{
    // Beyond a century the clock's range would overflow; nobody waits for longer.
    constexpr double kCentury = 3.2e9;
    TerminationCondition condition;
    if (seconds < kCentury)
        condition.deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                 std::chrono::duration<double>(std::max(0.0, seconds)));
    return condition;
}

TerminationCondition TerminationCondition::when(std::stop_token stop)
{
    TerminationCondition condition;
    condition.stop_ = std::move(stop);
    return condition;
}

TerminationCondition TerminationCondition::when(std::function<bool()> predicate)
{
    TerminationCondition condition;
    condition.predicate_ = std::move(predicate);
    return condition;
}

TerminationCondition TerminationCondition::operator||(const TerminationCondition &other) const
{
    TerminationCondition both = *this;
    if (other.deadline_)
        both.deadline_ = both.deadline_ ? std::min(*both.deadline_, *other.deadline_) : *other.deadline_;
    if (other.predicate_ || other.stop_.stop_possible())
    {
        if (!both.stop_.stop_possible())
            both.stop_ = other.stop_;
        else if (other.stop_.stop_possible())
            both.predicate_ = [first = both.predicate_, stop = other.stop_]
            { return stop.stop_requested() || (first && first()); };
        if (other.predicate_)
            both.predicate_ = [first = both.predicate_, second = other.predicate_]
            { return second() || (first && first()); };
    }
    return both;
}

} // namespace mrpp
