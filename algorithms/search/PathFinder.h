#pragma once
/// \file
/// Cheapest paths between two vertices where entering a vertex has a small whole-number price: A* with
/// landmark bounds and a bucket queue. Run many times on one graph; a search costs what it visits.

#include "algorithms/search/Landmarks.h"
#include "framework/support/TerminationCondition.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

namespace mrpp
{

class PathFinder
{
public:
    using Cost = std::uint32_t;

    /// Cost of a step onto a free vertex, and the largest price that enterCost may give.
    static constexpr Cost kStep = 4;
    static constexpr Cost kMaxEnterCost = 120;
    /// enterCost's way to say that a vertex cannot be entered.
    static constexpr Cost kImpassable = static_cast<Cost>(-1);

    /// Keeps references to both.
    PathFinder(const Graph &graph, const Landmarks &landmarks)
        : graph_(graph), landmarks_(landmarks), labels_(graph.vertexCount())
    {}

    /// The cheapest path from `from` to `to`, both included; empty where there is none, or where the
    /// termination condition says stop. Valid until the next call.
    /// \param enterCost a function of a vertex: kStep … kMaxEnterCost, or kImpassable; the start's is not
    /// asked
    template <class EnterCost>
    const std::vector<Vertex> &find(Vertex from, Vertex to, const EnterCost &enterCost,
                                    const TerminationCondition &ptc = {})
    {
        constexpr std::uint32_t kPollInterval = 4096;
        std::uint32_t untilPoll = kPollInterval;
        begin();
        path_.clear();
        reach(from, kNoVertex, 0, kStep * landmarks_.lowerBound(from, to));
        while (const auto open = pop())
        {
            const auto [v, cost] = *open;
            if (cost != labels_[v].cost)
                continue;
            if (--untilPoll == 0)
            {
                if (ptc())
                    break;
                untilPoll = kPollInterval;
            }
            if (v == to)
            {
                for (Vertex u = to; u != kNoVertex; u = labels_[u].parent)
                    path_.push_back(u);
                std::reverse(path_.begin(), path_.end());
                break;
            }
            for (const Vertex w : graph_.neighbors(v))
            {
                const Cost price = enterCost(w);
                if (price == kImpassable)
                    continue;
                assert(price >= kStep && price <= kMaxEnterCost);
                const Cost newCost = cost + price;
                if (labels_[w].stamp != stamp_ || newCost < labels_[w].cost)
                    reach(w, v, newCost, newCost + kStep * landmarks_.lowerBound(w, to));
            }
        }
        return path_;
    }

private:
    struct Open
    {
        Vertex vertex = kNoVertex;
        Cost cost = 0;
        explicit operator bool() const { return vertex != kNoVertex; }
        const Open &operator*() const { return *this; }
    };

    /// What a search knows of a vertex; together in memory, for large graphs.
    struct Label
    {
        Cost cost = 0;
        Vertex parent = kNoVertex;
        std::uint32_t stamp = 0; ///< of the search that reached it last
    };

    /// Keys grow by at most kMaxEnterCost + kStep from a vertex to its neighbour, so that a ring of buckets
    /// does.
    static constexpr std::size_t kBuckets = 128;
    static_assert(kBuckets > kMaxEnterCost + kStep);

    void begin()
    {
        for (auto &bucket : buckets_)
            bucket.clear();
        open_ = 0;
        started_ = false;
        if (++stamp_ == 0)
        {
            std::fill(labels_.begin(), labels_.end(), Label{});
            stamp_ = 1;
        }
    }

    void reach(Vertex v, Vertex parent, Cost cost, Cost key)
    {
        labels_[v] = {cost, parent, stamp_};
        if (!started_)
            key_ = key;
        started_ = true;
        buckets_[key % kBuckets].push_back({v, cost});
        ++open_;
    }

    Open pop()
    {
        if (open_ == 0)
            return {};
        while (buckets_[key_ % kBuckets].empty())
            ++key_;
        const Open last = buckets_[key_ % kBuckets].back();
        buckets_[key_ % kBuckets].pop_back();
        --open_;
        return last;
    }

    const Graph &graph_;
    const Landmarks &landmarks_;
    std::vector<Label> labels_; ///< size = vertices
    std::uint32_t stamp_ = 0;
    std::array<std::vector<Open>, kBuckets> buckets_;
    std::size_t open_ = 0;
    Cost key_ = 0;
    bool started_ = false;
    std::vector<Vertex> path_;
};

} // namespace mrpp
