#include "framework/analysis/EarDecomposition.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace mrpp
{

EarDecomposition::EarDecomposition(const Graph &graph, std::span<const Vertex> cycle, Growth growth,
                                   std::optional<Seed> shuffle)
    : levels_(graph.vertexCount(), kNew)
{
    assert(cycle.size() >= 3);
    std::optional<Random> random;
    if (shuffle)
        random.emplace(*shuffle);
    paths_.reserve(graph.vertexCount());
    add(cycle);
    if (growth == Growth::depthFirst)
        growDepthFirst(graph, random ? &*random : nullptr);
    else
        growShortest(graph, random ? &*random : nullptr);
}

void EarDecomposition::add(std::span<const Vertex> path)
{
    const auto level = static_cast<std::uint32_t>(offsets_.size() - 1);
    for (const Vertex v : path)
        if (isNew(v))
            levels_[v] = level;
    paths_.insert(paths_.end(), path.begin(), path.end());
    offsets_.push_back(paths_.size());
}

namespace
{

/// A depth-first tree whose first path is a given cycle, from its first vertex to its last.
struct DepthFirstTree
{
    std::vector<Vertex> preorder;
    std::vector<Vertex> parent;
    std::vector<std::vector<Vertex>::size_type> position; ///< in preorder

    DepthFirstTree(const Graph &graph, std::span<const Vertex> cycle, Random *random)
        : parent(graph.vertexCount(), kNoVertex), position(graph.vertexCount(), kUnmet)
    {
        preorder.reserve(graph.vertexCount());
        std::vector<std::uint32_t> next(graph.vertexCount(), 0);
        std::vector<std::uint32_t> first(graph.vertexCount(), 0);
        const auto meet = [&](Vertex v, Vertex from)
        {
            parent[v] = from;
            position[v] = preorder.size();
            preorder.push_back(v);
            if (random != nullptr)
                first[v] = static_cast<std::uint32_t>(random->below(graph.degree(v)));
        };
        meet(cycle[0], kNoVertex);
        for (std::size_t i = 1; i < cycle.size(); ++i)
            meet(cycle[i], cycle[i - 1]);
        for (Vertex v = cycle.back(); v != kNoVertex;)
        {
            if (next[v] == graph.degree(v))
            {
                v = parent[v];
                continue;
            }
            const Vertex w = graph.neighbors(v)[(first[v] + next[v]++) % graph.degree(v)];
            if (position[w] != kUnmet)
                continue;
            meet(w, v);
            v = w;
        }
    }

private:
    static constexpr auto kUnmet = std::numeric_limits<std::size_t>::max();
};

} // namespace

/// Each edge that leads down past the tree begins a chain: along it, then up the tree to what is there.
void EarDecomposition::growDepthFirst(const Graph &graph, Random *random)
{
    const DepthFirstTree tree(graph, cycle(), random);
    std::vector<Vertex> chain;
    for (const Vertex v : tree.preorder)
        for (const Vertex w : graph.neighbors(v))
        {
            if (tree.position[w] < tree.position[v] || tree.parent[w] == v || !isNew(w))
                continue;
            chain.assign({v, w});
            while (isNew(chain.back()))
                chain.push_back(tree.parent[chain.back()]);
            add(chain);
        }
}

namespace
{

/// A forest of shortest paths to what is there already, and the edges that join two of its trees: each makes
/// a handle. Work waits in buckets by the length of the shortest handle that may come of it.
class HandleSearch
{
public:
    HandleSearch(const Graph &graph, Random *random)
        : graph_(graph), random_(random), distance_(graph.vertexCount(), kFar),
          root_(graph.vertexCount(), kNoVertex), parent_(graph.vertexCount(), kNoVertex)
    {}

    /// v is there now.
    void addSource(Vertex v) { reach(v, 0, v, kNoVertex); }

    /// The shortest handle; empty when everything is there.
    [[nodiscard]] std::span<const Vertex> next()
    {
        while (lowest_ < buckets_.size())
        {
            if (buckets_[lowest_].empty())
            {
                ++lowest_;
                continue;
            }
            const auto [u, v] = buckets_[lowest_].take(random_);
            if (v == kNoVertex)
                expand(u);
            else if (root_[u] != root_[v] && length(u, v) == lowest_)
                return handle(u, v);
        }
        return {};
    }

private:
    static constexpr std::uint32_t kFar = static_cast<std::uint32_t>(-1);

    /// The edge u–v closes a handle; without v: look around u.
    struct Work
    {
        Vertex u = kNoVertex;
        Vertex v = kNoVertex;
    };
    struct Bucket
    {
        std::vector<Work> items;
        std::size_t head = 0;

        [[nodiscard]] bool empty() const { return head == items.size(); }
        Work take(Random *random)
        {
            if (random != nullptr)
                std::swap(items[head], items[head + random->below(items.size() - head)]);
            const Work work = items[head++];
            if (empty())
            {
                items.clear();
                head = 0;
            }
            return work;
        }
    };

    [[nodiscard]] std::size_t length(Vertex u, Vertex v) const
    {
        return std::size_t{1} + distance_[u] + distance_[v];
    }

    void put(std::size_t length, Work work)
    {
        if (length >= buckets_.size())
            buckets_.resize(length + 1);
        buckets_[length].items.push_back(work);
        lowest_ = std::min(lowest_, length);
    }

    void reach(Vertex v, std::uint32_t distance, Vertex root, Vertex parent)
    {
        distance_[v] = distance;
        root_[v] = root;
        parent_[v] = parent;
        put(distance + std::size_t{1}, {v, kNoVertex});
    }

    void expand(Vertex v)
    {
        if (distance_[v] + std::size_t{1} != lowest_) // it came nearer since
            return;
        for (const Vertex w : graph_.neighbors(v))
        {
            if (distance_[w] == kFar || distance_[w] > distance_[v] + 1)
                reach(w, distance_[v] + 1, root_[v], v);
            else if (root_[w] != root_[v] && distance_[v] + distance_[w] > 0)
                put(length(v, w), {v, w});
        }
    }

    [[nodiscard]] std::span<const Vertex> handle(Vertex u, Vertex v)
    {
        handle_.clear();
        for (; u != kNoVertex; u = parent_[u])
            handle_.push_back(u);
        std::reverse(handle_.begin(), handle_.end());
        for (; v != kNoVertex; v = parent_[v])
            handle_.push_back(v);
        return handle_;
    }

    const Graph &graph_;
    Random *random_;
    std::vector<std::uint32_t> distance_; ///< edges to the nearest vertex that is there, as far as is known
    std::vector<Vertex> root_;            ///< that vertex
    std::vector<Vertex> parent_;          ///< towards it
    std::vector<Bucket> buckets_;
    std::size_t lowest_ = 0; ///< buckets below are empty
    std::vector<Vertex> handle_;
};

} // namespace

void EarDecomposition::growShortest(const Graph &graph, Random *random)
{
    HandleSearch search(graph, random);
    for (const Vertex v : cycle())
        search.addSource(v);
    for (auto handle = search.next(); !handle.empty(); handle = search.next())
    {
        add(handle);
        for (const Vertex v : handle.subspan(1, handle.size() - 2))
            search.addSource(v);
    }
}

namespace
{

/// Looks for short cycles through one vertex after another.
class CycleSearch
{
public:
    explicit CycleSearch(const Graph &graph)
        : graph_(graph), stamps_(graph.vertexCount(), 0), distance_(graph.vertexCount()),
          branch_(graph.vertexCount()), parent_(graph.vertexCount())
    {}

    /// Edges looked at so far.
    [[nodiscard]] std::size_t work() const { return work_; }

    /// A shortest cycle through v, if it is shorter than `limit`.
    [[nodiscard]] std::vector<Vertex> run(Vertex v, std::size_t limit)
    {
        ++stamp_;
        queue_.clear();
        meet(v, kNoVertex, v, 0);
        Graph::Edge closing;
        std::size_t length = limit;
        for (std::size_t head = 0; head < queue_.size(); ++head)
        {
            const Vertex u = queue_[head];
            if (2 * std::size_t{distance_[u]} + 1 >= length)
                break;
            work_ += graph_.degree(u);
            for (const Vertex w : graph_.neighbors(u))
            {
                if (stamps_[w] != stamp_)
                {
                    meet(w, u, u == v ? w : branch_[u], distance_[u] + 1);
                }
                else if (w != parent_[u] && branch_[w] != branch_[u] && w != v && u != v &&
                         std::size_t{1} + distance_[u] + distance_[w] < length)
                {
                    length = std::size_t{1} + distance_[u] + distance_[w];
                    closing = {u, w};
                }
            }
        }
        if (length == limit)
            return {};
        std::vector<Vertex> cycle;
        for (Vertex u = closing.a; u != kNoVertex; u = parent_[u])
            cycle.push_back(u);
        std::reverse(cycle.begin(), cycle.end());
        for (Vertex u = closing.b; u != v; u = parent_[u])
            cycle.push_back(u);
        return cycle;
    }

private:
    void meet(Vertex v, Vertex parent, Vertex branch, std::uint32_t distance)
    {
        stamps_[v] = stamp_;
        parent_[v] = parent;
        branch_[v] = branch;
        distance_[v] = distance;
        queue_.push_back(v);
    }

    const Graph &graph_;
    std::vector<std::uint32_t> stamps_;
    std::vector<std::uint32_t> distance_;
    std::vector<Vertex> branch_; ///< the neighbour of the source on the way; the source's own is itself
    std::vector<Vertex> parent_;
    std::vector<Vertex> queue_;
    std::uint32_t stamp_ = 0;
    std::size_t work_ = 0;
};

} // namespace

std::vector<Vertex> shortestCycleThrough(const Graph &graph, Vertex v)
{
    return CycleSearch(graph).run(v, std::numeric_limits<std::size_t>::max());
}

std::vector<Vertex> shortCycle(const Graph &graph)
{
    constexpr std::size_t kSearches = 30; // of the whole graph
    CycleSearch search(graph);
    std::vector<Vertex> best;
    // Every cycle of a biconnected graph that is no cycle itself passes through vertices of degree three.
    for (const std::size_t leastDegree : {3U, 2U})
    {
        for (Vertex v = 0; v < graph.vertexCount() && best.size() != 3; ++v)
        {
            if (graph.degree(v) < leastDegree)
                continue;
            auto cycle = search.run(v, best.empty() ? std::numeric_limits<std::size_t>::max() : best.size());
            if (!cycle.empty())
                best = std::move(cycle);
            if (search.work() > kSearches * (graph.vertexCount() + 2 * graph.edgeCount()))
                break;
        }
        if (!best.empty())
            break;
    }
    return best;
}

} // namespace mrpp
