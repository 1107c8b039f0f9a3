#include "framework/analysis/Subgraphs.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace mrpp
{

FreeCounts::FreeCounts(const Blocks &blocks, std::span<const Vertex> occupied) : blocks_(&blocks)
{
    before_.assign(blocks.preorder().size() + 1, 1);
    before_[0] = 0;
    for (const Vertex v : occupied)
        before_[blocks.position(v) + 1] = 0;
    std::partial_sum(before_.begin(), before_.end(), before_.begin());
}

/// Joins the vertices of subgraphs, and keeps the corridors that link nothing.
struct Subgraphs::Corridors
{
    explicit Corridors(std::size_t vertices) : leader(vertices)
    {
        std::iota(leader.begin(), leader.end(), Vertex{0});
    }

    Vertex find(Vertex v)
    {
        while (leader[v] != v)
            v = leader[v] = leader[leader[v]];
        return v;
    }

    /// The smaller leader leads.
    void unite(Vertex a, Vertex b)
    {
        a = find(a);
        b = find(b);
        leader[std::max(a, b)] = std::min(a, b);
    }

    std::vector<Vertex> leader; ///< union-find
    std::vector<Plank> unlinked;
};

Subgraphs::Subgraphs(const Graph &graph, const Blocks &blocks, MotionRule rule,
                     std::span<const Vertex> occupied)
    : graph_(&graph), blocks_(&blocks), rotations_(rule == MotionRule::rotation)
{
    const FreeCounts free(blocks, occupied);
    const std::uint32_t spare = rotations_ ? 0 : 2; ///< free vertices that links cannot count on
    std::vector<std::uint8_t> seeds(graph.vertexCount(), 0);
    Corridors corridors(graph.vertexCount());
    for (Vertex v = 0; v < graph.vertexCount(); ++v)
    {
        const std::uint32_t m = free.inComponent(v);
        if (!isSeed(v) || m < spare)
            continue;
        seeds[v] = 1;
        for (const Vertex u : graph.neighbors(v))
        {
            if (blocks.twoEdgeOf(u) == blocks.twoEdgeOf(v))
                corridors.unite(u, v);
            else
                follow(corridors, v, u, m - spare);
        }
    }
    number(corridors, seeds);
    sortPlanks(corridors.unlinked);
}

/// Walks from a seed to the corridor's other end; links the two where the corridor is short enough.
void Subgraphs::follow(Corridors &corridors, Vertex join, Vertex exterior, std::uint32_t limit) const
{
    // With rotations a C seed needs one free vertex less than a J seed.
    const auto extra = [&](Vertex v) { return rotations_ && !blocks_->inTwoEdgeComponent(v) ? 1U : 0U; };
    Plank corridor{.join = join, .exterior = exterior, .end = exterior, .length = 1};
    for (Vertex previous = join; graph_->degree(corridor.end) == 2; ++corridor.length)
        corridor.end = onwards(std::exchange(previous, corridor.end), corridor.end);
    if (!isSeed(corridor.end) || corridor.length + extra(join) + extra(corridor.end) > limit)
        return corridors.unlinked.push_back(corridor);
    walk(corridor,
         [&](Vertex v)
         {
             corridors.unite(v, join);
             return true;
         });
}

void Subgraphs::number(Corridors &corridors, std::span<const std::uint8_t> seeds)
{
    const std::size_t n = seeds.size();
    std::vector<std::uint8_t> hasSeed(n, 0); ///< by leader
    for (Vertex v = 0; v < n; ++v)
        if (seeds[v] != 0)
            hasSeed[corridors.find(v)] = 1;
    subgraph_.assign(n, kNoSubgraph);
    vertexOffsets_.assign(1, 0);
    for (Vertex v = 0; v < n; ++v)
    {
        const Vertex leader = corridors.find(v); // the smallest vertex, so it has its number already
        if (hasSeed[leader] == 0)
            continue;
        if (leader == v)
        {
            subgraph_[v] = static_cast<std::uint32_t>(count());
            vertexOffsets_.push_back(0);
        }
        subgraph_[v] = subgraph_[leader];
        ++vertexOffsets_[subgraph_[v] + 1];
    }
    std::partial_sum(vertexOffsets_.begin(), vertexOffsets_.end(), vertexOffsets_.begin());
    vertices_.resize(vertexOffsets_.back());
    std::vector<std::uint32_t> end(vertexOffsets_.begin(), vertexOffsets_.end() - 1);
    for (Vertex v = 0; v < n; ++v)
        if (subgraph_[v] != kNoSubgraph)
            vertices_[end[subgraph_[v]]++] = v;
}

void Subgraphs::sortPlanks(std::span<Plank> unlinked)
{
    plankOffsets_.assign(count() + 1, 0);
    for (Plank &plank : unlinked)
    {
        plank.subgraph = subgraph_[plank.join];
        plank.farSubgraph = subgraph_[plank.end];
        ++plankOffsets_[plank.subgraph + 1];
    }
    std::partial_sum(plankOffsets_.begin(), plankOffsets_.end(), plankOffsets_.begin());
    planks_.resize(unlinked.size());
    std::vector<std::uint32_t> end(plankOffsets_.begin(), plankOffsets_.end() - 1);
    for (const Plank &plank : unlinked)
        planks_[end[plank.subgraph]++] = plank;
}

std::vector<std::uint32_t> Subgraphs::assignment(std::span<const Vertex> occupied) const
{
    const FreeCounts free(*blocks_, occupied);
    std::vector<std::uint32_t> assigned = subgraph_; // also of free vertices, which nobody asks for
    for (std::uint32_t subgraph = 0; subgraph < count(); ++subgraph)
    {
        const auto planks = this->planks(subgraph);
        for (std::size_t first = 0, last = 0; first < planks.size(); first = last)
        {
            while (last < planks.size() && planks[last].join == planks[first].join)
                ++last;
            if (!keepsOccupant(planks.subspan(first, last - first), free))
                assigned[planks[first].join] = kNoSubgraph;
        }
    }
    for (const Plank &plank : planks_)
    {
        const std::uint32_t near = free.inComponent(plank.join) - free.beyond(plank.join, plank.exterior);
        const bool toCycles = rotations_ && blocks_->inTwoEdgeComponent(plank.join);
        std::uint32_t reach = toCycles || near == 0 ? near : near - 1; ///< robots
        walk(plank,
             [&](Vertex v)
             {
                 if (reach > 0 && !free.isFree(v))
                 {
                     assert(assigned[v] == kNoSubgraph || assigned[v] == plank.subgraph);
                     assigned[v] = plank.subgraph;
                     --reach;
                 }
                 return reach > 0;
             });
    }
    std::vector<std::uint32_t> result;
    result.reserve(occupied.size());
    for (const Vertex v : occupied)
        result.push_back(assigned[v]);
    return result;
}

bool Subgraphs::keepsOccupant(std::span<const Plank> planksAtJoin, const FreeCounts &free) const
{
    const Vertex join = planksAtJoin.front().join;
    if (rotations_ && blocks_->inTwoEdgeComponent(join))
        return true;
    const std::uint32_t m = free.inComponent(join);
    std::uint32_t outside = free.isFree(join) ? 1 : 0; ///< the join itself, and beyond its planks
    for (const Plank &plank : planksAtJoin)
    {
        const std::uint32_t beyond = free.beyond(join, plank.exterior);
        if (beyond > 0 && beyond < m)
            return true; // a free vertex beyond takes the robot in, and one on this side another one
        outside += beyond;
    }
    return outside < m; // the rest of the subgraph has one
}

} // namespace mrpp
