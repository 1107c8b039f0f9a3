#include "problems/generators/Isthmus.h"

#include "framework/support/Error.h"
#include "problems/generators/Drawing.h"
#include "problems/generators/HandleGraph.h"
#include "problems/generators/RandomTree.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr std::size_t kSmallestBlock = 3; ///< a triangle

/// A random biconnected graph of exactly `size` vertices.
HandleGraph randomBlock(std::size_t size, std::size_t longestHandle, Random &random)
{
    const std::size_t most = std::min(size, kSmallestBlock + longestHandle);
    HandleGraph block(kSmallestBlock + random.below(most - kSmallestBlock + 1));
    while (block.vertexCount() < size)
        block.addRandomHandle(1 + random.below(std::min(longestHandle, size - block.vertexCount())), random);
    return block;
}

/// How many edges each isthmus has: the first `longest`, the others as many as their vertices allow.
std::vector<std::size_t> isthmusLengths(std::size_t count, std::size_t longest, std::size_t spare,
                                        Random &random)
{
    std::vector<std::size_t> lengths(count, longest);
    for (std::size_t i = 1; i < count; ++i)
    {
        lengths[i] = 1 + random.below(std::min(longest, spare + 1));
        spare -= lengths[i] - 1;
    }
    return lengths;
}

/// The parts of a graph put together.
struct Assembly
{
    std::size_t vertexCount = 0;
    std::vector<Graph::Edge> edges;

    /// Returns the first vertex of the block.
    Vertex add(const HandleGraph &block)
    {
        const auto first = static_cast<Vertex>(vertexCount);
        for (const Graph::Edge &edge : block.edges())
            edges.push_back({edge.a + first, edge.b + first});
        vertexCount += block.vertexCount();
        return first;
    }

    void join(Vertex a, Vertex b, std::size_t length)
    {
        Vertex last = a;
        for (std::size_t i = 1; i < length; ++i)
        {
            const auto next = static_cast<Vertex>(vertexCount++);
            edges.push_back({last, next});
            last = next;
        }
        edges.push_back({last, b});
    }
};

} // namespace

Isthmus::Isthmus()
{
    declareParam("vertices", vertices_, "6:100000000", "how many vertices");
    declareParam("longest_isthmus", longestIsthmus_, "1:100000000", "edges of the longest isthmus");
    declareParam("blocks", blocks_, "2:10000000", "biconnected parts, joined by isthmuses");
    declareParam("max_handle_length", maxHandleLength_, "1:1000000",
                 "most inner vertices of a handle of a part: the fewer, the denser");
}

std::string Isthmus::name() const
{
    return "isthmus " + std::to_string(vertices_) + "-" + std::to_string(longestIsthmus_);
}

void Isthmus::checkParameters() const
{
    const std::int64_t needed = static_cast<std::int64_t>(kSmallestBlock) * blocks_ + longestIsthmus_ - 1;
    if (vertices_ < needed)
        throw InputError(std::to_string(blocks_) + " blocks and an isthmus of " +
                         std::to_string(longestIsthmus_) + " edges need " + std::to_string(needed) +
                         " vertices or more, not " + std::to_string(vertices_));
}

std::shared_ptr<const Graph> Isthmus::makeGraph(Seed seed) const
{
    Random random(seed);
    const auto blocks = static_cast<std::size_t>(blocks_);
    const auto longest = static_cast<std::size_t>(longestIsthmus_);
    std::size_t spare = static_cast<std::size_t>(vertices_) - kSmallestBlock * blocks - (longest - 1);
    const auto lengths = isthmusLengths(blocks - 1, longest, spare, random);
    for (std::size_t i = 1; i < lengths.size(); ++i)
        spare -= lengths[i] - 1;

    // What is left goes to the blocks in equal shares.
    std::vector<HandleGraph> parts;
    for (std::size_t i = 0; i < blocks; ++i)
    {
        const std::size_t size = kSmallestBlock + spare / blocks + (i < spare % blocks ? 1 : 0);
        parts.push_back(randomBlock(size, static_cast<std::size_t>(maxHandleLength_), random));
    }

    auto joints = uniformTree(blocks, random);
    random.shuffle(std::span(joints));
    Assembly whole;
    std::vector<Vertex> first;
    for (const HandleGraph &part : parts)
        first.push_back(whole.add(part));
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        const auto pick = [&](Vertex block)
        { return first[block] + static_cast<Vertex>(random.below(parts[block].vertexCount())); };
        const Vertex a = pick(joints[i].a);
        const Vertex b = pick(joints[i].b);
        whole.join(a, b, lengths[i]);
    }
    return drawnGraph(whole.vertexCount, whole.edges);
}

} // namespace mrpp
