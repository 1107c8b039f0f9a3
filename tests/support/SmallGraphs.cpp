#include "tests/support/SmallGraphs.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <set>
#include <utility>

namespace mrpp::test
{

namespace
{

using Adjacency = std::vector<std::uint32_t>; ///< a vertex's neighbours as bits

std::uint32_t degree(const Adjacency &graph, std::size_t v)
{
    return static_cast<std::uint32_t>(std::popcount(graph[v]));
}

/// Equal for two vertices that an automorphism exchanges.
std::uint32_t invariant(const Adjacency &graph, std::size_t v)
{
    std::uint32_t sum = 0;
    for (std::size_t u = 0; u < graph.size(); ++u)
        if ((graph[v] >> u & 1U) != 0)
            sum += degree(graph, u) * degree(graph, u);
    return degree(graph, v) * 1000 + sum;
}

/// The adjacency matrix's upper triangle as bits, the vertices in the given order.
std::uint32_t code(const Adjacency &graph, const std::vector<std::size_t> &order)
{
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j)
            bits = bits << 1 | (graph[order[i]] >> order[j] & 1U);
    return bits;
}

/// The smallest code among the orders in which the invariants ascend: the same for isomorphic graphs.
class Canonical
{
public:
    explicit Canonical(const Adjacency &graph) : graph_(graph), order_(graph.size())
    {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        for (std::size_t v = 0; v < graph.size(); ++v)
            invariants_.push_back(invariant(graph, v));
        std::ranges::sort(order_, {}, [&](std::size_t v) { return invariants_[v]; });
        permute(0);
    }
    [[nodiscard]] std::uint32_t code() const { return best_; }

private:
    void permute(std::size_t i)
    {
        if (i == order_.size())
        {
            best_ = std::min(best_, test::code(graph_, order_));
            return;
        }
        for (std::size_t j = i; j < order_.size(); ++j)
        {
            if (invariants_[order_[j]] != invariants_[order_[i]])
                continue;
            std::swap(order_[i], order_[j]);
            permute(i + 1);
            std::swap(order_[i], order_[j]);
        }
    }

    const Adjacency &graph_;
    std::vector<std::size_t> order_;
    std::vector<std::uint32_t> invariants_;
    std::uint32_t best_ = static_cast<std::uint32_t>(-1);
};

/// Each is a smaller one with a vertex more: a connected graph has a vertex that is no cut vertex.
std::vector<Adjacency> adjacencies(std::size_t vertices)
{
    if (vertices <= 1)
        return {{0}};
    std::set<std::uint32_t> seen;
    std::vector<Adjacency> graphs;
    for (const Adjacency &smaller : adjacencies(vertices - 1))
    {
        for (std::uint32_t neighbours = 1; neighbours < 1U << (vertices - 1); ++neighbours)
        {
            Adjacency graph = smaller;
            for (std::size_t v = 0; v + 1 < vertices; ++v)
                graph[v] |= (neighbours >> v & 1U) << (vertices - 1);
            graph.push_back(neighbours);
            if (seen.insert(Canonical(graph).code()).second)
                graphs.push_back(std::move(graph));
        }
    }
    return graphs;
}

void extendPath(const Graph &graph, std::vector<Vertex> &path, std::vector<std::vector<Vertex>> &cycles)
{
    for (const Vertex v : graph.neighbors(path.back()))
    {
        // Each cycle from its smallest vertex, in one of its two directions.
        if (v == path.front() && path.size() >= 3 && path[1] < path.back())
            cycles.push_back(path);
        if (v <= path.front() || std::ranges::find(path, v) != path.end())
            continue;
        path.push_back(v);
        extendPath(graph, path, cycles);
        path.pop_back();
    }
}

/// Union-find whose leaders are the smallest members.
class Classes
{
public:
    explicit Classes(std::size_t size) : leader_(size)
    {
        std::iota(leader_.begin(), leader_.end(), std::uint32_t{0});
    }
    std::uint32_t find(std::uint32_t i)
    {
        while (leader_[i] != i)
            i = leader_[i] = leader_[leader_[i]];
        return i;
    }
    void unite(std::size_t i, std::size_t j)
    {
        const std::uint32_t a = find(static_cast<std::uint32_t>(i));
        const std::uint32_t b = find(static_cast<std::uint32_t>(j));
        leader_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> leader_;
};

} // namespace

std::vector<std::shared_ptr<const Graph>> connectedGraphs(std::size_t vertices)
{
    assert(vertices >= 1 && vertices <= 7);
    std::vector<std::shared_ptr<const Graph>> graphs;
    for (const Adjacency &adjacency : adjacencies(vertices))
    {
        std::vector<Graph::Edge> edges;
        for (Vertex a = 0; a < vertices; ++a)
            for (Vertex b = a + 1; b < vertices; ++b)
                if ((adjacency[a] >> b & 1U) != 0)
                    edges.push_back({a, b});
        graphs.push_back(Graph::fromEdges(vertices, edges));
    }
    return graphs;
}

std::vector<std::vector<Vertex>> simpleCycles(const Graph &graph)
{
    std::vector<std::vector<Vertex>> cycles;
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        std::vector<Vertex> path = {v};
        extendPath(graph, path, cycles);
    }
    return cycles;
}

std::vector<Vertex> positionOrbits(const Graph &graph, MotionRule rule)
{
    const std::size_t n = graph.vertexCount();
    const auto cycles =
        rule == MotionRule::rotation ? simpleCycles(graph) : std::vector<std::vector<Vertex>>();
    Classes classes(n << n);
    for (std::size_t set = 0; set < std::size_t{1} << n; ++set)
    {
        const auto occupied = [&](Vertex v) { return (set >> v & 1U) != 0; };
        for (const Graph::Edge &edge : graph.edges())
        {
            const auto [from, to] = occupied(edge.a) ? std::pair(edge.a, edge.b) : std::pair(edge.b, edge.a);
            if (!occupied(from) || occupied(to))
                continue;
            const std::size_t next = set ^ std::size_t{1} << from ^ std::size_t{1} << to;
            for (Vertex v = 0; v < n; ++v)
                if (occupied(v))
                    classes.unite(set * n + v, next * n + (v == from ? to : v));
        }
        for (const auto &cycle : cycles)
            if (std::ranges::all_of(cycle, occupied))
                for (std::size_t i = 1; i < cycle.size(); ++i)
                    classes.unite(set * n + cycle[0], set * n + cycle[i]);
    }
    std::vector<Vertex> orbits(n << n, kNoVertex);
    for (std::size_t set = 0; set < std::size_t{1} << n; ++set)
    {
        for (Vertex v = 0; v < n; ++v)
        {
            if ((set >> v & 1U) == 0)
                continue;
            Vertex &orbit = orbits[set * n + v];
            for (orbit = 0;
                 (set >> orbit & 1U) == 0 || classes.find(static_cast<std::uint32_t>(set * n + orbit)) !=
                                                 classes.find(static_cast<std::uint32_t>(set * n + v));)
                ++orbit;
        }
    }
    return orbits;
}

} // namespace mrpp::test
