#include "algorithms/mapp/GoalOrder.h"

#include "algorithms/mapp/Units.h"

#include <algorithm>
#include <utility>

namespace mrpp::mapp
{

GoalOrder::GoalOrder(const Units &units)
    : units_(units), in_(units.robotCount(), 0), waitsFor_(units.robotCount(), 0),
      beforeOffsets_(units.robotCount() + 1, 0), seen_(units.robotCount(), 0)
{
    for (Robot r = 0; r < in_.size(); ++r)
    {
        in_[r] = units.isSlidable(r) ? 1 : 0;
        if (in_[r] == 0)
            continue;
        for (const Robot other : units.crossed(r))
            ++waitsFor_[other];
    }
    for (Robot r = 0; r < in_.size(); ++r)
        beforeOffsets_[r + 1] = beforeOffsets_[r] + waitsFor_[r];
    before_.resize(beforeOffsets_.back());
    std::vector<std::uint32_t> filled(beforeOffsets_.begin(), beforeOffsets_.end() - 1);
    for (Robot r = 0; r < in_.size(); ++r)
    {
        if (in_[r] == 0)
            continue;
        for (const Robot other : units.crossed(r))
            before_[filled[other]++] = r;
        if (waitsFor_[r] == 0)
            ready_.push_back(r);
    }
}

void GoalOrder::remove(Robot r)
{
    if (in_[r] == 0)
        return;
    in_[r] = 0;
    std::erase(ready_, r);
    for (const Robot other : units_.crossed(r))
        if (--waitsFor_[other] == 0 && in_[other] != 0)
            ready_.push_back(other);
}

std::uint64_t GoalOrder::weight(Robot r) const
{
    const auto crossed = units_.crossed(r);
    const auto after =
        std::count_if(crossed.begin(), crossed.end(), [&](Robot other) { return in_[other] != 0; });
    return std::uint64_t{waitsFor_[r]} * static_cast<std::uint64_t>(after);
}

Robot GoalOrder::fromCircle()
{
    while (firstIn_ < in_.size() && in_[firstIn_] == 0)
        ++firstIn_;
    if (firstIn_ == in_.size())
        return kNoRobot;
    const auto previous = [&](Robot r)
    {
        return *std::find_if(before_.begin() + beforeOffsets_[r], before_.begin() + beforeOffsets_[r + 1],
                             [&](Robot p) { return in_[p] != 0; });
    };
    // Backwards from anybody: sooner or later somebody comes twice.
    ++walk_;
    Robot r = firstIn_;
    for (; seen_[r] != walk_; r = previous(r))
        seen_[r] = walk_;
    Robot best = r;
    for (Robot p = previous(r); p != r; p = previous(p))
        if (weight(p) > weight(best))
            best = p;
    return best;
}

} // namespace mrpp::mapp
