#include "problems/generators/RandomGraph.h"

#include "framework/support/Error.h"
#include "problems/generators/Drawing.h"
#include "problems/generators/RandomTree.h"

#include <algorithm>
#include <cmath>

namespace mrpp
{

namespace
{

using Pair = std::uint64_t; ///< the smaller vertex in the upper half, the larger one in the lower

Pair pairOf(Vertex a, Vertex b)
{
    return static_cast<Pair>(std::min(a, b)) << 32 | std::max(a, b);
}

void sortUnique(std::vector<Pair> &pairs)
{
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Adds uniformly random new pairs up to `count`. Every round draws exactly what is missing, so that no pair
/// is ever taken out again.
void addRandomPairs(std::vector<Pair> &pairs, std::size_t count, std::size_t vertices, Random &random)
{
    while (pairs.size() < count)
    {
        for (std::size_t missing = count - pairs.size(); missing > 0; --missing)
        {
            const auto a = static_cast<Vertex>(random.below(vertices));
            const auto b = static_cast<Vertex>(random.below(vertices - 1));
            pairs.push_back(pairOf(a, b < a ? b : b + 1));
        }
        sortUnique(pairs);
    }
}

/// The same for graphs that are nearly complete, where few draws would be new.
void addListedPairs(std::vector<Pair> &pairs, std::size_t count, std::size_t vertices, Random &random)
{
    std::vector<Pair> others;
    for (Vertex a = 0; a < vertices; ++a)
        for (Vertex b = a + 1; b < vertices; ++b)
            if (!std::binary_search(pairs.begin(), pairs.end(), pairOf(a, b)))
                others.push_back(pairOf(a, b));
    const std::size_t missing = count - pairs.size();
    random.shuffleFront(std::span(others), missing);
    pairs.insert(pairs.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(missing));
}

double mostEdges(std::int64_t vertices)
{
    return static_cast<double>(vertices) * static_cast<double>(vertices - 1) / 2;
}

} // namespace

RandomGraph::RandomGraph()
{
    declareParam("vertices", vertices_, "1:100000000", "how many vertices");
    declareParam("edges", edges_, "0:100000000", "how many edges; 0 for what the mean degree gives");
    declareParam(
        "mean_degree", meanDegree_, "0:1000000",
        "edges · 2 / vertices, where `edges` is not given; kept between a tree and a complete graph");
}

std::size_t RandomGraph::edgeCount() const
{
    if (edges_ > 0)
        return static_cast<std::size_t>(edges_);
    const double edges = std::round(meanDegree_ * static_cast<double>(vertices_) / 2);
    return static_cast<std::size_t>(
        std::clamp(edges, static_cast<double>(vertices_ - 1), mostEdges(vertices_)));
}

void RandomGraph::checkParameters() const
{
    if (edges_ > 0 && (edges_ < vertices_ - 1 || static_cast<double>(edges_) > mostEdges(vertices_)))
        throw InputError("a connected graph of " + std::to_string(vertices_) + " vertices has " +
                         std::to_string(vertices_ - 1) + " to " + formatNumber(mostEdges(vertices_)) +
                         " edges, not " + std::to_string(edges_));
    requireSize(static_cast<double>(edgeCount()));
}

std::shared_ptr<const Graph> RandomGraph::makeGraph(Seed seed) const
{
    Random random(seed);
    const auto vertices = static_cast<std::size_t>(vertices_);
    const std::size_t count = edgeCount();
    std::vector<Pair> pairs;
    pairs.reserve(count);
    for (const Graph::Edge &edge : uniformTree(vertices, random))
        pairs.push_back(pairOf(edge.a, edge.b));
    std::sort(pairs.begin(), pairs.end());
    if (static_cast<double>(count) > mostEdges(vertices_) / 2)
        addListedPairs(pairs, count, vertices, random);
    else
        addRandomPairs(pairs, count, vertices, random);

    std::vector<Graph::Edge> edges;
    edges.reserve(count);
    for (const Pair pair : pairs)
        edges.push_back({static_cast<Vertex>(pair >> 32), static_cast<Vertex>(pair)});
    return drawnGraph(vertices, edges);
}

} // namespace mrpp
