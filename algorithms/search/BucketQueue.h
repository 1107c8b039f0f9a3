#pragma once
/// \file
/// Vertices by whole-number keys that never fall below the one taken last: a ring of buckets. Of equal keys
/// the latest comes first. Several times as fast as a heap.
///
/// Source: R. B. Dial, "Algorithm 360: shortest-path forest with topological ordering", CACM 12, 1969.

#include "framework/model/Graph.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpp
{

class BucketQueue
{
public:
    /// Keys lie less than this above the one taken last.
    static constexpr std::size_t kBuckets = 256;

    /// Forgets everything; keys begin with this one.
    void begin(std::uint32_t key)
    {
        if (size_ > 0)
            for (auto &bucket : buckets_)
                bucket.clear();
        size_ = 0;
        key_ = key;
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// O(1).
    void push(std::uint32_t key, Vertex v)
    {
        buckets_[key % kBuckets].push_back(v);
        ++size_;
    }

    /// One with the smallest key; kNoVertex where there is none. O(1), but for keys that nobody has.
    Vertex pop()
    {
        if (size_ == 0)
            return kNoVertex;
        while (buckets_[key_ % kBuckets].empty())
            ++key_;
        const Vertex v = buckets_[key_ % kBuckets].back();
        buckets_[key_ % kBuckets].pop_back();
        --size_;
        return v;
    }

private:
    std::array<std::vector<Vertex>, kBuckets> buckets_;
    std::size_t size_ = 0;
    std::uint32_t key_ = 0;
};

} // namespace mrpp
