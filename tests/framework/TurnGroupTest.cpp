/// \file
/// What framework/analysis/SolvabilityNoneFree.cpp claims of larger components: the turns of the simple
/// cycles of a 2-edge-connected graph that is no cycle generate all permutations, or the even ones where
/// every block is an odd cycle.

#include "framework/analysis/Blocks.h"
#include "framework/support/Random.h"
#include "tests/support/SmallGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace mrpp
{
namespace
{

using Permutation = std::vector<Vertex>; ///< i goes to [i]

/// First p, then q.
Permutation product(const Permutation &p, const Permutation &q)
{
    Permutation result(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        result[i] = q[p[i]];
    return result;
}

Permutation inverse(const Permutation &p)
{
    Permutation result(p.size());
    for (Vertex i = 0; i < p.size(); ++i)
        result[p[i]] = i;
    return result;
}

/// The stabilizer chain of Schreier and Sims: level i fixes the points below i.
class StabilizerChain
{
public:
    explicit StabilizerChain(std::size_t points)
        : identity_(points), generators_(points),
          transversals_(points, std::vector<std::optional<Permutation>>(points))
    {
        std::iota(identity_.begin(), identity_.end(), Vertex{0});
        for (std::size_t i = 0; i < points; ++i)
            transversals_[i][i] = identity_;
    }

    void add(const Permutation &generator) { add(0, generator); }

    [[nodiscard]] std::uint64_t order() const
    {
        std::uint64_t order = 1;
        for (const auto &level : transversals_)
            order *= static_cast<std::uint64_t>(
                std::ranges::count_if(level, [](const auto &element) { return element.has_value(); }));
        return order;
    }

private:
    /// \pre the generator fixes the points below `level`
    void add(std::size_t level, const Permutation &generator)
    {
        if (sifts(level, generator))
            return;
        generators_[level].push_back(generator);
        for (Vertex point = 0; point < identity_.size(); ++point)
            if (transversals_[level][point])
                visit(level, product(*transversals_[level][point], generator));
    }

    /// A new point of the orbit, or a generator of the next level.
    void visit(std::size_t level, const Permutation &element)
    {
        auto &known = transversals_[level][element[level]];
        if (known)
            return add(level + 1, product(element, inverse(*known)));
        known = element;
        for (std::size_t i = 0; i < generators_[level].size(); ++i)
            visit(level, product(element, generators_[level][i]));
    }

    [[nodiscard]] bool sifts(std::size_t level, Permutation element) const
    {
        for (; level < identity_.size(); ++level)
        {
            const auto &known = transversals_[level][element[level]];
            if (!known)
                return false;
            element = product(element, inverse(*known));
        }
        return true;
    }

    Permutation identity_;
    std::vector<std::vector<Permutation>> generators_;
    std::vector<std::vector<std::optional<Permutation>>> transversals_; ///< [level][image of level]
};

std::uint64_t orderOfTurns(const Graph &graph)
{
    StabilizerChain chain(graph.vertexCount());
    for (const auto &cycle : test::simpleCycles(graph))
    {
        Permutation turn(graph.vertexCount());
        std::iota(turn.begin(), turn.end(), Vertex{0});
        for (std::size_t i = 0; i < cycle.size(); ++i)
            turn[cycle[i]] = cycle[(i + 1) % cycle.size()];
        chain.add(turn);
    }
    return chain.order();
}

void expectOrder(const Graph &graph)
{
    const std::size_t n = graph.vertexCount();
    const Blocks blocks(graph);
    ASSERT_EQ(blocks.twoEdgeCount(), 1U);
    std::uint64_t expected = 1;
    for (std::size_t i = 2; i <= n; ++i)
        expected *= i;
    bool onlyOddCycles = true;
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
        onlyOddCycles = onlyOddCycles && blocks.isCycle(block) && blocks.vertices(block).size() % 2 != 0;
    if (blocks.count() == 1 && blocks.isCycle(0))
        expected = n;
    else if (onlyOddCycles)
        expected /= 2;
    std::string text;
    for (const Graph::Edge &edge : graph.edges())
        text += std::to_string(edge.a) + "-" + std::to_string(edge.b) + " ";
    EXPECT_EQ(orderOfTurns(graph), expected) << text;
}

TEST(TurnGroup, OfSmallGraphsIsAsLargeAsClaimed)
{
    std::size_t checked = 0;
    for (std::size_t n = 3; n <= 6; ++n)
    {
        for (const auto &graph : test::connectedGraphs(n))
        {
            if (Blocks(*graph).twoEdgeCount() != 1)
                continue;
            expectOrder(*graph);
            ++checked;
        }
    }
    EXPECT_EQ(checked, 75U); // A007146: 1 + 3 + 11 + 60
}

TEST(TurnGroup, OfKnownGraphsIsAsLargeAsClaimed)
{
    // K3,3; the cube; a prism over a pentagon; Petersen's graph.
    expectOrder(
        *Graph::fromEdges(6, {{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}}));
    expectOrder(*Graph::fromEdges(
        8, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}));
    std::vector<Graph::Edge> prism;
    std::vector<Graph::Edge> petersen;
    for (Vertex i = 0; i < 5; ++i)
    {
        prism.insert(prism.end(), {{i, (i + 1) % 5}, {i + 5, (i + 1) % 5 + 5}, {i, i + 5}});
        petersen.insert(petersen.end(), {{i, (i + 1) % 5}, {i + 5, (i + 2) % 5 + 5}, {i, i + 5}});
    }
    expectOrder(*Graph::fromEdges(10, prism));
    expectOrder(*Graph::fromEdges(10, petersen));
}

TEST(TurnGroup, OfThetasIsAsLargeAsClaimed)
{
    // Paths over a, b and c vertices from 0 to 1.
    for (Vertex a = 0; a <= 4; ++a)
    {
        for (Vertex b = std::max(a, 1U); b <= 5; ++b)
        {
            for (Vertex c = b; a + b + c <= 10; ++c)
            {
                std::vector<Graph::Edge> edges;
                Vertex next = 2;
                for (const Vertex inner : {a, b, c})
                {
                    Vertex last = 0;
                    for (Vertex i = 0; i < inner; ++i)
                    {
                        edges.push_back({last, next});
                        last = next++;
                    }
                    edges.push_back({last, 1});
                }
                expectOrder(*Graph::fromEdges(next, edges));
            }
        }
    }
}

TEST(TurnGroup, OfCactiIsAsLargeAsClaimed)
{
    for (Seed seed = 0; seed < 60; ++seed)
    {
        Random random(seed);
        const std::size_t n = 8 + random.below(5);
        std::vector<Graph::Edge> edges;
        for (Vertex next = 1; next < n;)
        {
            // A cycle of `fresh` new vertices through an old one; every second cactus has odd cycles only.
            const auto left = static_cast<Vertex>(n) - next;
            auto fresh = static_cast<Vertex>(2 + random.below(4));
            if (seed % 2 == 0)
                fresh -= fresh % 2;
            fresh = std::min(fresh, left);
            if (fresh < 2)
                break;
            Vertex last = static_cast<Vertex>(random.below(next));
            const Vertex first = last;
            for (Vertex i = 0; i < fresh; ++i, ++next)
                edges.push_back({std::exchange(last, next), next});
            edges.push_back({last, first});
        }
        Vertex used = 0;
        for (const Graph::Edge &edge : edges)
            used = std::max({used, edge.a, edge.b});
        expectOrder(*Graph::fromEdges(used + 1, edges));
    }
}

TEST(TurnGroup, OfRandomGraphsIsAsLargeAsClaimed)
{
    // A cycle with ears, some of them closed.
    for (Seed seed = 0; seed < 60; ++seed)
    {
        Random random(seed);
        const auto n = static_cast<Vertex>(8 + random.below(5));
        auto next = static_cast<Vertex>(3 + random.below(n - 3));
        std::vector<Graph::Edge> edges;
        for (Vertex i = 0; i < next; ++i)
            edges.push_back({i, (i + 1) % next});
        while (next < n)
        {
            const auto from = static_cast<Vertex>(random.below(next));
            const auto to = static_cast<Vertex>(random.below(next));
            auto inner = static_cast<Vertex>(1 + random.below(n - next));
            if (from == to && inner < 2)
                continue;
            Vertex last = from;
            for (; inner > 0; --inner, ++next)
                edges.push_back({std::exchange(last, next), next});
            edges.push_back({last, to});
        }
        expectOrder(*Graph::fromEdges(n, edges));
    }
}

} // namespace
} // namespace mrpp
