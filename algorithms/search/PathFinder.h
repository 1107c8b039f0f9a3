#pragma once
/// \file
/// Short paths between two vertices where entering a vertex has a small whole-number price: A* with landmark
/// bounds. Run many times on one graph; a search costs what it visits.
///
/// Where robots stand in the way, cheapest paths cost more than the bounds can know, and A* floods an area in
/// place of a corridor. A search that visits many more vertices than its path has therefore weighs the bounds
/// (weighted A*): the path costs at most weight() times the cheapest. The weight begins at 1 in every search
/// and is learnt from that search's own effort: each time the visits double, what it has above 1 doubles.
/// Nothing is carried over to the next search, and a search that is nearly done without a weight gets none.
///
/// Keys of weight 1 are whole numbers that never fall, and the open vertices are in buckets; those of other
/// weights may fall, and they are in a heap then. No vertex is visited twice: the bounds are
/// consistent, and then the promise holds without opening vertices again (Likhachev et al.). It also holds
/// when the weight grows during the search, as every vertex was reached within the smaller weight.
///
/// Sources: I. Pohl, "Heuristic search viewed as path finding in a graph", Artificial Intelligence 1, 1970
/// (the weight); M. Likhachev, G. Gordon, S. Thrun, "ARA*: anytime A* with provable bounds on
/// sub-optimality", NIPS 2003 (no vertex twice).

#include "algorithms/search/BucketQueue.h"
#include "framework/analysis/Landmarks.h"
#include "framework/support/TerminationCondition.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
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

    /// A search weighs the bounds once it has visited kFewVisits vertices, and kVisitsPerStep for each step
    /// that the path has at least.
    static constexpr std::size_t kFewVisits = 256;
    static constexpr std::size_t kVisitsPerStep = 2;
    /// What it learns at most.
    static constexpr double kMostWeight = 2;

    /// Keeps references to both.
    PathFinder(const Graph &graph, const Landmarks &landmarks)
        : graph_(graph), landmarks_(landmarks), labels_(graph.vertexCount())
    {}

    /// From now on every search has this weight, and none learns its own. \pre 1 or more; rounded down to a
    /// multiple of 1/128
    void fixWeight(double weight)
    {
        assert(weight >= 1);
        isFixed_ = true;
        weight_ = static_cast<Cost>(std::floor(weight * kOne));
    }

    /// Of the last search: its path costs at most so many times the cheapest.
    [[nodiscard]] double weight() const { return static_cast<double>(weight_) / kOne; }
    /// Vertices whose neighbours the last search looked at.
    [[nodiscard]] std::size_t visits() const { return visits_; }

    /// A path from `from` to `to`, both included, that costs at most weight() times the cheapest; empty where
    /// there is none, or where the termination condition says stop. Valid until the next call. Each vertex is
    /// visited once at most.
    /// \param enterCost a function of a vertex: kStep … kMaxEnterCost, or kImpassable; the start's is not
    /// asked
    template <class EnterCost>
    const std::vector<Vertex> &find(Vertex from, Vertex to, const EnterCost &enterCost,
                                    const TerminationCondition &ptc = {})
    {
        constexpr std::size_t kPollInterval = 4096;
        const std::uint32_t least = landmarks_.lowerBound(from, to);
        begin(kStep * least);
        std::size_t enough = kFewVisits + kVisitsPerStep * least;
        reach(from, kNoVertex, 0, least);
        for (Vertex v = pop(); v != kNoVertex; v = pop())
        {
            if (v == to)
            {
                tracePath(to);
                break;
            }
            if (++visits_ % kPollInterval == 0 && ptc())
                break;
            if (visits_ > enough)
            {
                enough *= 2;
                growWeight();
            }
            const Cost cost = labels_[v].cost;
            for (const Vertex w : graph_.neighbors(v))
            {
                if (labels_[w].stamp == closed())
                    continue;
                const Cost price = enterCost(w);
                if (price == kImpassable)
                    continue;
                assert(price >= kStep && price <= kMaxEnterCost);
                if (labels_[w].stamp != open())
                    reach(w, v, cost + price, landmarks_.lowerBound(w, to));
                else if (cost + price < labels_[w].cost)
                    reach(w, v, cost + price, labels_[w].least);
            }
        }
        return path_;
    }

private:
    /// Weights are multiples of 1 / kOne.
    static constexpr Cost kOne = 128;
    static_assert(BucketQueue::kBuckets > kMaxEnterCost + kStep);

    /// What a search knows of a vertex; together in memory, for large graphs.
    struct Label
    {
        Cost cost = 0;
        Vertex parent = kNoVertex;
        std::uint32_t least = 0; ///< steps to the goal
        std::uint32_t stamp = 0; ///< open() or closed() of the search that reached it last
    };

    /// An open vertex, perhaps not for the first time: the first that comes out of the heap counts.
    struct Open
    {
        std::uint64_t order = 0; ///< the key, then the latest first
        Vertex vertex = kNoVertex;

        friend bool operator>(const Open &a, const Open &b) { return a.order > b.order; }
    };

    [[nodiscard]] std::uint32_t open() const { return stamp_; }
    [[nodiscard]] std::uint32_t closed() const { return stamp_ + 1; }

    void begin(Cost key)
    {
        path_.clear();
        heap_.clear();
        buckets_.begin(key);
        visits_ = 0;
        reached_ = 0;
        if (!isFixed_)
            weight_ = kOne;
        stamp_ += 2;
        if (stamp_ == 0)
        {
            std::fill(labels_.begin(), labels_.end(), Label{});
            stamp_ = 2;
        }
    }

    void reach(Vertex v, Vertex parent, Cost cost, std::uint32_t least)
    {
        labels_[v] = {cost, parent, least, open()};
        if (weight_ == kOne)
            return buckets_.push(cost + kStep * least, v);
        heap_.push_back({order(labels_[v], ++reached_), v});
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    }

    /// Closes the open vertex with the smallest key; kNoVertex where there is none.
    Vertex pop()
    {
        for (Vertex v = popAny(); v != kNoVertex; v = popAny())
        {
            if (labels_[v].stamp == closed())
                continue;
            labels_[v].stamp = closed();
            return v;
        }
        return kNoVertex;
    }

    Vertex popAny()
    {
        if (weight_ == kOne)
            return buckets_.pop();
        if (heap_.empty())
            return kNoVertex;
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const Vertex v = heap_.back().vertex;
        heap_.pop_back();
        return v;
    }

    static constexpr unsigned kReachedBits = 20; ///< of an order; more only mix up equal keys

    [[nodiscard]] std::uint64_t order(const Label &label, std::uint64_t reached) const
    {
        const std::uint64_t key =
            std::uint64_t{kOne} * label.cost + std::uint64_t{weight_} * kStep * label.least;
        return (key << kReachedBits) | (~reached & ((1U << kReachedBits) - 1));
    }

    /// 1, 1 + 1/kOne, 1 + 2/kOne, 1 + 4/kOne … kMostWeight.
    void growWeight()
    {
        constexpr auto kMost = static_cast<Cost>(kMostWeight * kOne);
        if (isFixed_ || weight_ >= kMost)
            return;
        // Out of the buckets comes the latest of equal keys first, and so it has to stay.
        reached_ += buckets_.size();
        for (Vertex v = buckets_.pop(); v != kNoVertex; v = buckets_.pop())
            heap_.push_back({order(labels_[v], buckets_.size()), v});
        weight_ = std::min(kMost, weight_ + std::max<Cost>(1, weight_ - kOne));
        std::erase_if(heap_, [this](const Open &entry) { return labels_[entry.vertex].stamp == closed(); });
        for (Open &entry : heap_)
            entry.order = order(labels_[entry.vertex], ~entry.order);
        std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
    }

    void tracePath(Vertex to)
    {
        for (Vertex v = to; v != kNoVertex; v = labels_[v].parent)
            path_.push_back(v);
        std::reverse(path_.begin(), path_.end());
    }

    const Graph &graph_;
    const Landmarks &landmarks_;
    std::vector<Label> labels_; ///< size = vertices
    BucketQueue buckets_;       ///< of the open vertices while the weight is 1
    std::vector<Open> heap_;    ///< and later
    std::vector<Vertex> path_;
    std::uint32_t stamp_ = 0;
    std::uint64_t reached_ = 0; ///< how often the last search reached a vertex
    std::size_t visits_ = 0;    ///< of the last search
    Cost weight_ = kOne;        ///< of the last search, or of all
    bool isFixed_ = false;
};

} // namespace mrpp
