#pragma once
/// \file
/// Who has to go before whom: a robot whose paths touch another's goal goes first, because the other one
/// stays there for good. Robots are taken out one after another, when nobody is before them.

#include "framework/model/Graph.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mrpp::mapp
{

class Units;

class GoalOrder
{
public:
    /// Of the SLIDABLE robots. Keeps the reference.
    explicit GoalOrder(const Units &units);

    /// Those that nobody is before any more and that were not given yet.
    [[nodiscard]] std::vector<Robot> takeReady() { return std::exchange(ready_, {}); }

    /// Takes a robot out; those that it was before may become ready. Nothing where it is out.
    void remove(Robot r);

    /// A robot that is, with others, before itself: the one of its circle with most others before and after
    /// it. kNoRobot where nobody is left. \pre nobody is ready. O(robots).
    [[nodiscard]] Robot fromCircle();

private:
    [[nodiscard]] std::uint64_t weight(Robot r) const;

    const Units &units_;
    std::vector<char> in_;                     ///< size robots, as all below
    std::vector<std::uint32_t> waitsFor_;      ///< how many that are in are before it
    std::vector<std::uint32_t> beforeOffsets_; ///< size robots + 1
    std::vector<Robot> before_;
    std::vector<std::uint32_t> seen_; ///< the walk of fromCircle() that came by
    std::uint32_t walk_ = 0;
    Robot firstIn_ = 0; ///< nobody before it is in
    std::vector<Robot> ready_;
};

} // namespace mrpp::mapp
