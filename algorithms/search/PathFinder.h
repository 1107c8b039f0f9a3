#pragma once
/// \file
/// Cheapest paths between two vertices where entering a vertex has a small whole-number price: A* with
/// landmark bounds and a bucket queue. Run many times on one graph; a search costs what it visits.
///
/// Where many vertices are dear, cheapest paths cost more than the bounds can know, and A* floods an area in
/// place of a corridor. Searches that visit many more vertices than their paths have therefore weigh the
/// bounds, as little as keeps them near the path (weighted A*: a path costs at most that weight times the
/// cheapest; I. Pohl, "Heuristic search viewed as path finding in a graph", Artificial Intelligence 1, 1970).
/// The weight is learnt from search to search. Graphs of up to kFewVisits vertices never see it.

#include "framework/analysis/Landmarks.h"
#include "framework/support/TerminationCondition.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
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

    /// A search that visits more vertices than this, and kVisitsPerStep for each step that the path has at
    /// least, weighs the bounds.
    static constexpr std::size_t kFewVisits = 4096;
    static constexpr std::size_t kVisitsPerStep = 8;

    /// The cheapest path from `from` to `to`, both included, or on large graphs one of at most twice its
    /// cost; empty where there is none, or where the termination condition says stop. Valid until the next
    /// call.
    /// \param enterCost a function of a vertex: kStep … kMaxEnterCost, or kImpassable; the start's is not
    /// asked
    template <class EnterCost>
    const std::vector<Vertex> &find(Vertex from, Vertex to, const EnterCost &enterCost,
                                    const TerminationCondition &ptc = {})
    {
        constexpr int kTries = 4;
        const std::size_t enough = kFewVisits + kVisitsPerStep * landmarks_.lowerBound(from, to);
        bool done = false;
        for (int tries = 1; !done; ++tries)
        {
            const bool last = tries == kTries || weight_ == kMostWeight;
            done = search(from, to, enterCost, last ? std::numeric_limits<std::size_t>::max() : enough, ptc);
            weight_ += done ? 0 : 1;
        }
        if (4 * visits_ < enough && weight_ > kNoWeight)
            --weight_;
        return path_;
    }

private:
    /// Makes path_. False where it came to nothing after so many visits.
    template <class EnterCost>
    bool search(Vertex from, Vertex to, const EnterCost &enterCost, std::size_t mostVisits,
                const TerminationCondition &ptc)
    {
        constexpr std::size_t kPollInterval = 4096;
        begin();
        path_.clear();
        reach(from, kNoVertex, 0, weighed(from, to));
        while (const auto open = pop())
        {
            const auto [v, cost] = *open;
            if (cost != labels_[v].cost)
                continue;
            if (v == to)
            {
                for (Vertex u = to; u != kNoVertex; u = labels_[u].parent)
                    path_.push_back(u);
                std::reverse(path_.begin(), path_.end());
                break;
            }
            if (++visits_ % kPollInterval == 0 && ptc())
                break;
            if (visits_ > mostVisits)
                return false;
            for (const Vertex w : graph_.neighbors(v))
            {
                const Cost price = enterCost(w);
                if (price == kImpassable)
                    continue;
                assert(price >= kStep && price <= kMaxEnterCost);
                const Cost newCost = cost + price;
                // Keys never fall: weights make the bounds inconsistent.
                if (labels_[w].stamp != stamp_ || newCost < labels_[w].cost)
                    reach(w, v, newCost, std::max(key_, newCost + weighed(w, to)));
            }
        }
        return true;
    }

    [[nodiscard]] Cost weighed(Vertex v, Vertex to) const
    {
        return kStep * landmarks_.lowerBound(v, to) * weight_ / kNoWeight;
    }

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

    /// Weights are multiples of 1 / kNoWeight.
    static constexpr Cost kNoWeight = 32;
    static constexpr Cost kMostWeight = 2 * kNoWeight;

    /// Keys grow by at most kMaxEnterCost and a weighed step from a vertex to its neighbour, so that a ring
    /// of buckets does.
    static constexpr std::size_t kBuckets = 256;
    static_assert(kBuckets > kMaxEnterCost + kStep * kMostWeight / kNoWeight + 1);

    void begin()
    {
        for (auto &bucket : buckets_)
            bucket.clear();
        open_ = 0;
        visits_ = 0;
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
    std::size_t visits_ = 0;  ///< of the last search
    Cost weight_ = kNoWeight; ///< of the next one
    Cost key_ = 0;
    bool started_ = false;
    std::vector<Vertex> path_;
};

} // namespace mrpp
