#include "framework/analysis/LowerBounds.h"

#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>
#include <vector>

namespace mrpp
{

namespace
{

/// Distances between pairs of vertices: two searches meet half-way, each time the one with fewer vertices on
/// its rim grows by a whole level.
class BidirectionalSearch
{
public:
    explicit BidirectionalSearch(const Graph &graph) : graph_(&graph), owner_(graph.vertexCount(), 0) {}

    std::uint32_t distance(Vertex a, Vertex b)
    {
        if (a == b)
            return 0;
        nextQuery();
        rimA_.assign(1, a);
        rimB_.assign(1, b);
        owner_[a] = markA_;
        owner_[b] = markA_ + 1;
        // As long as the two balls are disjoint, their radii add up to less than the distance; so the first
        // vertex in which they touch gives the distance.
        for (std::uint32_t radii = 0; !rimA_.empty() && !rimB_.empty(); ++radii)
        {
            const bool fromA = rimA_.size() <= rimB_.size();
            if (fromA ? grow(rimA_, markA_, markA_ + 1) : grow(rimB_, markA_ + 1, markA_))
                return radii + 1;
        }
        return kUnreachable;
    }

private:
    void nextQuery()
    {
        markA_ += 2;
        if (markA_ >= kUnreachable - 2)
        {
            std::fill(owner_.begin(), owner_.end(), 0);
            markA_ = 2;
        }
    }

    /// True when the other side's ball was touched.
    bool grow(std::vector<Vertex> &rim, std::uint32_t own, std::uint32_t other)
    {
        next_.clear();
        for (const Vertex v : rim)
        {
            for (const Vertex w : graph_->neighbors(v))
            {
                if (owner_[w] == other)
                    return true;
                if (owner_[w] == own)
                    continue;
                owner_[w] = own;
                next_.push_back(w);
            }
        }
        std::swap(rim, next_);
        return false;
    }

    const Graph *graph_;
    std::vector<std::uint32_t> owner_; ///< markA_ in the ball of a, markA_ + 1 in that of b, less elsewhere
    std::uint32_t markA_ = 0;
    std::vector<Vertex> rimA_;
    std::vector<Vertex> rimB_;
    std::vector<Vertex> next_;
};

} // namespace

std::optional<LowerBounds> lowerBounds(const Instance &instance)
{
    BidirectionalSearch search(*instance.graph);
    LowerBounds bounds;
    for (Robot robot = 0; robot < instance.robotCount(); ++robot)
    {
        const std::uint32_t distance = search.distance(instance.starts[robot], instance.goals[robot]);
        if (distance == kUnreachable)
            return std::nullopt;
        bounds.pathLength += distance;
        bounds.makespan = std::max<std::uint64_t>(bounds.makespan, distance);
    }
    return bounds;
}

} // namespace mrpp
