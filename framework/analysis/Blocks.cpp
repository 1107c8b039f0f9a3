#include "framework/analysis/Blocks.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// Turns counts at i + 1 into offsets.
void accumulate(std::vector<std::uint32_t> &counts)
{
    for (std::size_t i = 1; i < counts.size(); ++i)
        counts[i] += counts[i - 1];
}

} // namespace

Blocks::Blocks(const Graph &graph)
{
    search(graph);
    collectVertices();
    collectEdges(graph);
    findTwoEdgeComponents();
}

void Blocks::search(const Graph &graph)
{
    const std::size_t n = graph.vertexCount();
    preorder_.reserve(n);
    position_.assign(n, kNone);
    subtreeSize_.assign(n, 1);
    parent_.assign(n, kNoVertex);
    root_.resize(n);
    parentBlock_.assign(n, kNone);
    std::vector<std::uint32_t> low(n); ///< the smallest position that the subtree's edges reach
    std::vector<std::uint32_t> next(n, 0);
    std::vector<Vertex> open; ///< met, but their block towards the root is not complete
    const auto meet = [&](Vertex v, Vertex root)
    {
        root_[v] = root;
        low[v] = position_[v] = static_cast<std::uint32_t>(preorder_.size());
        preorder_.push_back(v);
        open.push_back(v);
    };
    const auto completeBlock = [&](Vertex top, Vertex child)
    {
        const auto block = static_cast<std::uint32_t>(tops_.size());
        tops_.push_back(top);
        for (Vertex v = kNoVertex; v != child;)
        {
            v = open.back();
            open.pop_back();
            parentBlock_[v] = block;
        }
    };
    for (Vertex root = 0; root < n; ++root)
    {
        if (position_[root] != kNone)
            continue;
        meet(root, root);
        for (Vertex v = root; v != kNoVertex;)
        {
            if (next[v] < graph.degree(v))
            {
                const Vertex w = graph.neighbors(v)[next[v]++];
                if (position_[w] == kNone)
                {
                    parent_[w] = v;
                    meet(w, root);
                    v = w;
                }
                else if (w != parent_[v])
                {
                    low[v] = std::min(low[v], position_[w]);
                }
                continue;
            }
            const Vertex p = parent_[v];
            if (p != kNoVertex)
            {
                low[p] = std::min(low[p], low[v]);
                subtreeSize_[p] += subtreeSize_[v];
                if (low[v] >= position_[p])
                    completeBlock(p, v);
            }
            v = p;
        }
        open.clear();
    }
}

void Blocks::collectVertices()
{
    const std::size_t n = preorder_.size();
    blocksOfOffsets_.assign(n + 1, 0);
    for (Vertex v = 0; v < n; ++v)
        blocksOfOffsets_[v + 1] += parentBlock_[v] != kNone ? 1 : 0;
    for (const Vertex top : tops_)
        ++blocksOfOffsets_[top + 1];
    accumulate(blocksOfOffsets_);
    blocksOf_.resize(blocksOfOffsets_[n]);
    std::vector<std::uint32_t> end(blocksOfOffsets_.begin(), blocksOfOffsets_.end() - 1);
    for (std::uint32_t block = 0; block < tops_.size(); ++block)
        blocksOf_[end[tops_[block]]++] = block;
    for (Vertex v = 0; v < n; ++v) // towards the root is the largest number
        if (parentBlock_[v] != kNone)
            blocksOf_[end[v]++] = parentBlock_[v];

    vertexOffsets_.assign(count() + 1, 0);
    for (const std::uint32_t block : blocksOf_)
        ++vertexOffsets_[block + 1];
    accumulate(vertexOffsets_);
    vertices_.resize(blocksOf_.size());
    end.assign(vertexOffsets_.begin(), vertexOffsets_.end() - 1);
    for (Vertex v = 0; v < n; ++v)
        for (const std::uint32_t block : of(v))
            vertices_[end[block]++] = v;
}

void Blocks::collectEdges(const Graph &graph)
{
    std::vector<std::uint8_t> colour(preorder_.size(), 0);
    for (const Vertex v : preorder_)
        if (parent_[v] != kNoVertex)
            colour[v] = colour[parent_[v]] ^ 1U;
    edgeOffsets_.assign(count() + 1, 0);
    bipartite_.assign(count(), 1);
    const auto forEachEdge = [&](auto &&use)
    {
        for (const Vertex a : preorder_)
            for (const Vertex b : graph.neighbors(a))
                if (position_[a] < position_[b])
                    use(a, b, parentBlock_[b]);
    };
    forEachEdge(
        [&](Vertex a, Vertex b, std::uint32_t block)
        {
            ++edgeOffsets_[block + 1];
            if (colour[a] == colour[b])
                bipartite_[block] = 0;
        });
    accumulate(edgeOffsets_);
    edges_.resize(edgeOffsets_[count()]);
    std::vector<std::uint32_t> end(edgeOffsets_.begin(), edgeOffsets_.end() - 1);
    forEachEdge([&](Vertex a, Vertex b, std::uint32_t block) { edges_[end[block]++] = {a, b}; });
}

void Blocks::findTwoEdgeComponents()
{
    std::vector<Vertex> head(preorder_.size()); ///< the first vertex that the search met of v's component
    for (const Vertex v : preorder_)
        head[v] = parent_[v] == kNoVertex || isEdge(parentBlock_[v]) ? v : head[parent_[v]];
    std::vector<std::uint32_t> number(preorder_.size(), kNone);
    twoEdge_.resize(preorder_.size());
    for (Vertex v = 0; v < twoEdge_.size(); ++v)
    {
        if (number[head[v]] == kNone)
        {
            number[head[v]] = static_cast<std::uint32_t>(twoEdgeSizes_.size());
            twoEdgeSizes_.push_back(0);
        }
        twoEdge_[v] = number[head[v]];
        ++twoEdgeSizes_[twoEdge_[v]];
    }
}

} // namespace mrpp
