#include "tests/exhaustive/RandomFamilies.h"

#include "framework/Problem.h"
#include "tests/support/RandomCases.h"

#include <algorithm>
#include <array>
#include <vector>

namespace mrpp::test
{

namespace
{

/// Edges that grow vertex by vertex.
struct Growing
{
    std::vector<Graph::Edge> edges;
    Vertex vertices = 1;

    /// A path over new vertices; returns its end.
    Vertex path(Vertex from, Vertex length)
    {
        for (; length > 0; --length)
        {
            edges.push_back({from, vertices});
            from = vertices++;
        }
        return from;
    }

    /// A cycle of new vertices through an old one.
    void cycle(Vertex through, Vertex length) { edges.push_back({path(through, length - 1), through}); }

    [[nodiscard]] std::shared_ptr<const Graph> graph() const { return Graph::fromEdges(vertices, edges); }
};

Vertex between(Random &random, std::size_t low, std::size_t high)
{
    return static_cast<Vertex>(low + random.below(high - low + 1));
}

std::shared_ptr<const Graph> dumbbell(Random &random, std::size_t size)
{
    Growing growing;
    growing.cycle(0, between(random, 3, 3 + size / 4));
    const Vertex end = growing.path(between(random, 0, growing.vertices - 1), between(random, 0, 6));
    growing.cycle(end, between(random, 3, 3 + size / 4));
    for (std::size_t chord = random.below(3); chord > 0; --chord)
        growing.edges.push_back({between(random, 0, 2), between(random, 0, 2)});
    return growing.graph();
}

std::shared_ptr<const Graph> treeWithCycleLeaves(Random &random, std::size_t size)
{
    Growing growing;
    std::vector<Vertex> ends = {0};
    while (growing.vertices < size)
    {
        const Vertex from = ends[random.below(ends.size())];
        ends.push_back(growing.path(from, between(random, 1, 4)));
        if (random.below(2) == 0)
            growing.cycle(ends.back(), between(random, 3, 6));
    }
    return growing.graph();
}

std::shared_ptr<const Graph> biconnected(Random &random, std::size_t size)
{
    Growing growing;
    growing.cycle(0, between(random, 3, 6));
    while (growing.vertices < size)
    {
        const Vertex from = between(random, 0, growing.vertices - 1);
        Vertex to = from;
        while (to == from)
            to = between(random, 0, growing.vertices - 1);
        growing.edges.push_back({growing.path(from, between(random, 1, 4)), to});
    }
    return growing.graph();
}

std::shared_ptr<const Graph> grid(Random &random, std::size_t size)
{
    const std::size_t width = 2 + random.below(11);
    return gridGraph(width, std::clamp<std::size_t>(size / width, 2, 12));
}

} // namespace

Instance randomFamilyInstance(Seed seed, RandomGoals goals)
{
    Random random(deriveSeed(seed, "families"));
    // Small ones are more telling, large ones are rarer.
    static constexpr std::array<std::size_t, 4> kSizes = {12, 25, 60, 150};
    const std::size_t size = 4 + random.below(kSizes[random.below(kSizes.size())] - 3);
    std::shared_ptr<const Graph> graph;
    switch (random.below(6))
    {
    case 0:
        graph = randomConnectedGraph(size, 0, seed);
        break;
    case 1:
        graph = randomConnectedGraph(size, 1 + random.below(1 + size / 4), seed);
        break;
    case 2:
        graph = dumbbell(random, size);
        break;
    case 3:
        graph = treeWithCycleLeaves(random, size);
        break;
    case 4:
        graph = biconnected(random, size);
        break;
    default:
        graph = grid(random, size);
        break;
    }
    const std::size_t n = graph->vertexCount();
    const std::size_t free = 1 + random.below(std::min<std::size_t>(6, n - 1));
    switch (goals)
    {
    case RandomGoals::moves:
        return randomWalks(graph, n - free, 60 * n, seed).instance;
    case RandomGoals::rotations:
        return randomSolvedCaseWithRotations(graph, n - free, 3 * n, seed).instance;
    default:
        return randomInstance(graph, n - free, seed);
    }
}

} // namespace mrpp::test
