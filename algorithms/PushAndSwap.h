#pragma once
/// \file
/// Push and Swap.
///
/// Robots are brought to their goals one after another. A robot follows a path to its goal; a robot in its
/// way is *pushed* aside when free space can be reached without touching those that have arrived, else the
/// two *swap* at a vertex of degree three or more, and the swap leaves everybody else where they were. A
/// robot that had arrived and was swapped away is brought back by *resolve*.
///
/// Use it for: instances with at least two free vertices. It is fast (time is mostly path search), but not
/// complete: it may give up on instances that can be solved, and its giving up proves nothing.
///
/// Complexity: one path search a robot plus what pushes and swaps touch; O(robots · V) moves without swaps,
/// at most O(robots · V^3) with them; in practice near the sum of the shortest distances. Memory O(V + E +
/// moves).
///
/// Source: R. Luna, K. E. Bekris, "Push and Swap: fast cooperative path-finding with completeness
/// guarantees", IJCAI 2011, pp. 294–300. Differences: *clear* has the four stages of Push and Rotate (JAIR
/// 51, 2014); paths go around robots that have arrived when that is cheaper than a swap; where neither push
/// nor swap works, robots that have arrived may be pushed away and planned anew, and orders are tried again a
/// bounded number of times.

#include "algorithms/RestartingPlanner.h"
#include "algorithms/pebble/PebbleOperations.h"
#include "algorithms/search/PathFinder.h"

#include <memory>
#include <optional>
#include <vector>

namespace mrpp
{

class PushAndSwap final : public RestartingPlanner
{
public:
    PushAndSwap();

    void setup() override;
    void clear() override;
    [[nodiscard]] bool usesChance() const override
    {
        return order_ == "random" || attempts_ > 1 || RestartingPlanner::usesChance();
    }

private:
    Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
    std::vector<Robot> priorities(std::uint64_t attempt, std::int64_t retry) const;

    std::string order_ = "far_first";
    std::int64_t attempts_ = 20;
    std::int64_t swapPrice_ = 10;
    std::unique_ptr<Landmarks> landmarks_;
    std::vector<Robot> farFirst_;   ///< the first order
    std::vector<char> unswappable_; ///< of robots
};

} // namespace mrpp
