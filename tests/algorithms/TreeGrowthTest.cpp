/// \file
/// Time per move on trees that are half full hardly grows with the tree: what a robot does looks at what is
/// near its way, not at the whole graph. MRPP_TREE_VERTICES=48000 goes on to as many vertices (minutes), and
/// allows 1.3 for each doubling, which a quiet machine keeps.

#include "algorithms/PushAndRotate.h"
#include "algorithms/PushAndSpin.h"
#include "tests/support/CpuClock.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>

namespace mrpp
{
namespace
{

enum class Family
{
    recursive,   ///< each vertex hangs at one before it, by chance
    caterpillar, ///< a path with a leaf at each vertex
    binary,
    random,  ///< all trees are equally likely (H. Prüfer, 1918)
    friends, ///< triangles that hang at each other
};

std::vector<Graph::Edge> prueferTree(std::size_t vertices, Random &random)
{
    std::vector<Vertex> code(vertices - 2);
    std::vector<std::size_t> degrees(vertices, 1);
    for (Vertex &v : code)
        ++degrees[v = static_cast<Vertex>(random.below(vertices))];
    std::vector<Graph::Edge> edges;
    Vertex next = 0;
    while (degrees[next] != 1)
        ++next;
    Vertex leaf = next;
    for (const Vertex v : code)
    {
        edges.push_back({leaf, v});
        if (--degrees[v] == 1 && v < next)
        {
            leaf = v;
            continue;
        }
        do
            ++next;
        while (degrees[next] != 1);
        leaf = next;
    }
    edges.push_back({leaf, static_cast<Vertex>(vertices - 1)});
    return edges;
}

std::shared_ptr<const Graph> tree(Family family, std::size_t vertices)
{
    Random random(7);
    std::vector<Graph::Edge> edges;
    const std::size_t spine = vertices / 2;
    for (Vertex v = 1; v < vertices; ++v)
    {
        if (family == Family::recursive)
            edges.push_back({static_cast<Vertex>(random.below(v)), v});
        else if (family == Family::binary)
            edges.push_back({(v - 1) / 2, v});
        else if (family == Family::caterpillar)
            edges.push_back({v < spine ? v - 1 : static_cast<Vertex>(v - spine), v});
    }
    for (Vertex v = 1; family == Family::friends && v + 2 <= vertices; v += 2)
    {
        const auto parent = static_cast<Vertex>(random.below(v));
        edges.insert(edges.end(), {{parent, v}, {v, v + 1}, {parent, v + 1}});
    }
    if (family == Family::random)
        edges = prueferTree(vertices, random);
    const bool oneIsLeft = family == Family::friends && vertices % 2 == 0;
    return Graph::fromEdges(oneIsLeft ? vertices - 1 : vertices, edges);
}

std::shared_ptr<const Instance> halfFull(const std::shared_ptr<const Graph> &graph)
{
    Random random(5);
    std::vector<Vertex> starts(graph->vertexCount());
    std::iota(starts.begin(), starts.end(), Vertex{0});
    std::vector<Vertex> goals = starts;
    random.shuffle(std::span(starts));
    random.shuffle(std::span(goals));
    starts.resize(starts.size() / 2);
    goals.resize(starts.size());
    return std::make_shared<const Instance>(Instance{graph, starts, goals});
}

/// Seconds, the least of some runs.
template <class Solver>
double timePerMove(Family family, std::size_t vertices)
{
    Solver planner;
    const auto instance = halfFull(tree(family, vertices));
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
        planner.setInstance(instance);
        planner.setup();
        const double start = test::cpuSeconds();
        EXPECT_EQ(planner.solve({}), PlannerStatus::solved);
        const auto moves = static_cast<double>(planner.solution().pathLength());
        least = std::min(least, (test::cpuSeconds() - start) / moves);
    }
    return least;
}

class GrowthOnTrees : public testing::TestWithParam<Family>
{
protected:
    template <class Solver>
    void expectSteadyTimePerMove() const
    {
        const char *asked = std::getenv("MRPP_TREE_VERTICES");
        const bool manyMoves = GetParam() == Family::caterpillar || GetParam() == Family::random;
        const std::size_t most = asked != nullptr ? std::strtoul(asked, nullptr, 10)
                                 : manyMoves      ? 3'000
                                                  : 12'000;
        const double allowed = asked != nullptr ? 1.3 : 1.6; // for a doubling
        const std::size_t fewest = most / 4;
        const double small = timePerMove<Solver>(GetParam(), fewest);
        const double large = timePerMove<Solver>(GetParam(), most);
        std::cout << fewest << " vertices: " << small * 1e9 << " ns a move; " << most << ": " << large * 1e9
                  << '\n';
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        EXPECT_LT(std::sqrt(large / small), allowed);
#endif
    }
};

TEST_P(GrowthOnTrees, PushAndRotateTakesATimePerMoveThatHardlyGrows)
{
    expectSteadyTimePerMove<PushAndRotate>();
}

TEST_P(GrowthOnTrees, PushAndSpinTakesATimePerMoveThatHardlyGrows)
{
    expectSteadyTimePerMove<PushAndSpin>();
}

std::string familyName(const testing::TestParamInfo<Family> &test)
{
    switch (test.param)
    {
    case Family::recursive:
        return "recursive";
    case Family::caterpillar:
        return "caterpillar";
    case Family::binary:
        return "binary";
    case Family::random:
        return "random";
    case Family::friends:
        return "friends";
    }
    return "";
}

INSTANTIATE_TEST_SUITE_P(Families, GrowthOnTrees,
                         testing::Values(Family::recursive, Family::caterpillar, Family::binary,
                                         Family::random, Family::friends),
                         familyName);

} // namespace
} // namespace mrpp
