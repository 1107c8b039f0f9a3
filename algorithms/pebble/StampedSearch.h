#pragma once
/// \file
/// The memory of a breadth-first search that is run many times on one graph: instead of clearing its arrays
/// it marks what belongs to the current search with a stamp, so that a search costs only what it visits.

#include "framework/model/Graph.h"
#include "framework/support/TerminationCondition.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace mrpp
{

class StampedSearch
{
public:
    /// \param ptc ends long searches; kept as a pointer. Null: nothing does
    explicit StampedSearch(std::size_t vertexCount, const TerminationCondition *ptc = nullptr)
        : ptc_(ptc), stamps_(vertexCount, 0), parents_(vertexCount)
    {}

    /// Forgets the last search. O(1), but once in 2^32 times O(V).
    void begin()
    {
        queue_.clear();
        head_ = 0;
        if (++stamp_ == 0)
        {
            std::fill(stamps_.begin(), stamps_.end(), 0);
            stamp_ = 1;
        }
    }

    [[nodiscard]] bool visited(Vertex v) const { return stamps_[v] == stamp_; }

    /// Marks v as reached from `parent` (kNoVertex for a root) and puts it into the queue.
    void visit(Vertex v, Vertex parent)
    {
        stamps_[v] = stamp_;
        parents_[v] = parent;
        queue_.push_back(v);
    }

    /// Nothing is left to look at; or the termination condition, which is asked now and then, says stop.
    [[nodiscard]] bool done() const
    {
        constexpr std::size_t kPollInterval = 4096;
        return head_ == queue_.size() ||
               (head_ % kPollInterval == kPollInterval - 1 && ptc_ != nullptr && (*ptc_)());
    }
    Vertex next() { return queue_[head_++]; }

    /// \pre visited(v)
    [[nodiscard]] Vertex parent(Vertex v) const { return parents_[v]; }

private:
    const TerminationCondition *ptc_;
    std::vector<std::uint32_t> stamps_;
    std::vector<Vertex> parents_;
    std::vector<Vertex> queue_;
    std::size_t head_ = 0;
    std::uint32_t stamp_ = 0;
};

} // namespace mrpp
