#include "framework/analysis/DistanceSearch.h"

#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>

namespace mrpp
{

std::uint32_t BidirectionalSearch::distance(Vertex a, Vertex b)
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

void BidirectionalSearch::nextQuery()
{
    markA_ += 2;
    if (markA_ >= kUnreachable - 2)
    {
        std::fill(owner_.begin(), owner_.end(), 0);
        markA_ = 2;
    }
}

/// True when the other side's ball was touched.
bool BidirectionalSearch::grow(std::vector<Vertex> &rim, std::uint32_t own, std::uint32_t other)
{
    visits_ += rim.size();
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

std::uint32_t LandmarkSearch::distance(Vertex from, Vertex to)
{
    nextQuery();
    std::uint32_t total = landmarks_->lowerBound(from, to);
    reach(from, 0, total);
    for (int empty = 0; empty < 3; ++total)
    {
        std::vector<Open> &bucket = buckets_[total % 3];
        empty = bucket.empty() ? empty + 1 : 0;
        while (!bucket.empty())
        {
            const auto [v, distance] = bucket.back();
            bucket.pop_back();
            if (labels_[v].distance != distance)
                continue; // it was reached on a shorter way later
            if (v == to)
                return distance;
            ++visits_;
            for (const Vertex w : graph_->neighbors(v))
                if (labels_[w].stamp != stamp_ || distance + 1 < labels_[w].distance)
                    reach(w, distance + 1, distance + 1 + landmarks_->lowerBound(w, to));
        }
    }
    return kUnreachable;
}

void LandmarkSearch::nextQuery()
{
    for (std::vector<Open> &bucket : buckets_)
        bucket.clear();
    if (++stamp_ == 0)
    {
        std::fill(labels_.begin(), labels_.end(), Label{});
        stamp_ = 1;
    }
}

void LandmarkSearch::reach(Vertex v, std::uint32_t distance, std::uint32_t total)
{
    labels_[v] = {distance, stamp_};
    buckets_[total % 3].emplace_back(v, distance);
}

} // namespace mrpp
