#include "framework/run/RunQueue.h"

#include "framework/support/Random.h"

#include <algorithm>
#include <unordered_map>

namespace mrpp
{

RunQueue::RunQueue(std::vector<RunSpec> runs, Seed seed, std::size_t takers) : runs_(std::move(runs))
{
    Random random(deriveSeed(seed, "order"));
    random.shuffle(std::span(runs_));
    // A case comes where the first of its runs came.
    std::unordered_map<std::uint64_t, std::size_t> places;
    std::vector<std::pair<std::size_t, std::size_t>> order; // of the case, of the run
    order.reserve(runs_.size());
    for (const RunSpec &run : runs_)
    {
        const std::uint64_t name =
            (std::uint64_t{run.point} << 32U) | static_cast<std::uint64_t>(run.repetition);
        const std::size_t place = places.emplace(name, places.size()).first->second;
        order.emplace_back(place, order.size());
    }
    std::sort(order.begin(), order.end());
    std::vector<RunSpec> sorted;
    sorted.reserve(runs_.size());
    for (const auto &[place, run] : order)
    {
        if (place == cases_.size())
            cases_.push_back({sorted.size(), sorted.size()});
        sorted.push_back(std::move(runs_[run]));
        cases_.back().end = sorted.size();
    }
    runs_ = std::move(sorted);
    case_.assign(takers, cases_.size());
}

const RunSpec *RunQueue::take(std::size_t taker)
{
    const std::lock_guard lock(mutex_);
    const auto isOpen = [this](std::size_t i) { return cases_[i].next < cases_[i].end; };
    std::size_t &mine = case_[taker];
    if (mine == cases_.size() || !isOpen(mine))
    {
        if (untouched_ < cases_.size())
        {
            mine = untouched_++;
        }
        else
        {
            while (unfinished_ < cases_.size() && !isOpen(unfinished_))
                ++unfinished_;
            mine = unfinished_;
        }
    }
    return mine < cases_.size() ? &runs_[cases_[mine].next++] : nullptr;
}

} // namespace mrpp
