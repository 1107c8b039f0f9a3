#include "tests/support/BiconnectedGraphs.h"

#include "framework/analysis/Blocks.h"
#include "tests/support/RandomCases.h"

#include <algorithm>
#include <vector>

namespace mrpp::test
{

namespace
{

using Edges = std::vector<Graph::Edge>;

/// The graph with its vertices numbered by chance.
std::shared_ptr<const Graph> shuffled(std::size_t vertices, Edges edges, Random &random)
{
    std::vector<Vertex> number(vertices);
    for (Vertex v = 0; v < vertices; ++v)
        number[v] = v;
    random.shuffle(std::span(number));
    for (Graph::Edge &edge : edges)
        edge = {number[edge.a], number[edge.b]};
    return Graph::fromEdges(vertices, edges);
}

/// Adds a path with so many inner vertices, numbered from `next` on.
void addPath(Edges &edges, Vertex from, Vertex to, std::size_t inner, Vertex &next)
{
    for (; inner > 0; --inner)
    {
        edges.push_back({from, next});
        from = next++;
    }
    edges.push_back({from, to});
}

std::shared_ptr<const Graph> theta(Random &random)
{
    Edges edges;
    Vertex next = 2;
    for (const std::size_t least : {0U, 1U, 1U})
        addPath(edges, 0, 1, least + random.below(9), next);
    return shuffled(next, edges, random);
}

std::shared_ptr<const Graph> wheel(Random &random)
{
    Edges edges;
    Vertex next = 2;
    addPath(edges, 1, 1, 2 + random.below(12), next);
    for (Vertex v = 1; v < next; ++v)
        edges.push_back({0, v});
    return shuffled(next, edges, random);
}

/// Two cycles, vertex by vertex joined.
std::shared_ptr<const Graph> prism(Random &random)
{
    const auto size = static_cast<Vertex>(3 + random.below(8));
    Edges edges;
    for (Vertex v = 0; v < size; ++v)
    {
        edges.push_back({v, (v + 1) % size});
        edges.push_back({size + v, size + (v + 1) % size});
        edges.push_back({v, size + v});
    }
    return shuffled(2 * std::size_t{size}, edges, random);
}

std::shared_ptr<const Graph> complete(Random &random)
{
    const auto size = static_cast<Vertex>(4 + random.below(9));
    Edges edges;
    for (Vertex v = 0; v < size; ++v)
        for (Vertex w = 0; w < v; ++w)
            edges.push_back({v, w});
    return shuffled(size, edges, random);
}

std::shared_ptr<const Graph> completeBipartite(Random &random)
{
    const auto left = static_cast<Vertex>(2 + random.below(6));
    const auto right = static_cast<Vertex>(3 + random.below(6));
    Edges edges;
    for (Vertex v = 0; v < left; ++v)
        for (Vertex w = 0; w < right; ++w)
            edges.push_back({v, left + w});
    return shuffled(std::size_t{left} + right, edges, random);
}

std::shared_ptr<const Graph> largestBlock(const Graph &graph)
{
    const Blocks blocks(graph);
    std::uint32_t best = 0;
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
        if (blocks.vertices(block).size() > blocks.vertices(best).size())
            best = block;
    const auto vertices = blocks.vertices(best);
    const auto number = [&](Vertex v)
    { return static_cast<Vertex>(std::ranges::lower_bound(vertices, v) - vertices.begin()); };
    Edges edges;
    for (const Blocks::Edge &edge : blocks.edges(best))
        edges.push_back({number(edge.a), number(edge.b)});
    return Graph::fromEdges(vertices.size(), edges);
}

std::shared_ptr<const Graph> blockOfMap(Random &random)
{
    const auto width = static_cast<Vertex>(4 + random.below(6));
    const auto grid = gridGraph(width, 4 + random.below(6));
    std::vector<char> obstacle(grid->vertexCount(), 0);
    for (char &cell : obstacle)
        cell = random.below(5) == 0 ? 1 : 0;
    Edges edges = grid->edges();
    std::erase_if(edges,
                  [&](const Graph::Edge &edge) { return obstacle[edge.a] != 0 || obstacle[edge.b] != 0; });
    edges.push_back({0, 1}); // so that there is a block
    return largestBlock(*Graph::fromEdges(grid->vertexCount(), edges));
}

std::shared_ptr<const Graph> make(Random &random, std::size_t kind)
{
    switch (kind)
    {
    case 0:
        return cycleWithHandles(3 + random.below(9), 1 + random.below(10), 1 + random.below(6),
                                random.bits());
    case 1:
        return theta(random);
    case 2:
        return wheel(random);
    case 3:
        return gridGraph(3 + random.below(15), 2);
    case 4:
        return prism(random);
    case 5:
        return complete(random);
    case 6:
        return completeBipartite(random);
    case 7:
        return gridGraph(3 + random.below(5), 3 + random.below(5));
    case 8:
        return blockOfMap(random);
    default:
        return largestBlock(
            *randomConnectedGraph(10 + random.below(40), 5 + random.below(30), random.bits()));
    }
}

} // namespace

bool isBiconnected(const Graph &graph)
{
    const Blocks blocks(graph);
    return graph.vertexCount() >= 3 && blocks.count() == 1 &&
           blocks.vertices(0).size() == graph.vertexCount();
}

std::shared_ptr<const Graph> cycleWithHandles(std::size_t cycle, std::size_t handles, std::size_t longest,
                                              Seed seed)
{
    Random random(seed);
    Edges edges;
    Vertex next = 1;
    addPath(edges, 0, 0, cycle - 1, next);
    for (std::size_t i = 0; i < handles; ++i)
    {
        const auto from = static_cast<Vertex>(random.below(next));
        const auto to = static_cast<Vertex>((from + 1 + random.below(next - 1)) % next);
        addPath(edges, from, to, 1 + random.below(longest), next);
    }
    return shuffled(next, edges, random);
}

std::shared_ptr<const Graph> randomBiconnectedGraph(Seed seed)
{
    constexpr std::size_t kKinds = 10;
    Random random(seed);
    auto graph = make(random, seed % kKinds);
    while (graph->vertexCount() < 4 || Blocks(*graph).isCycle(0))
        graph = make(random, seed % kKinds);
    return graph;
}

} // namespace mrpp::test
