#include "algorithms/bibox/CostToGo.h"

#include <algorithm>

namespace mrpp
{

CostToGo::CostToGo(const OpenGraph &open, const TerminationCondition &ptc)
    : open_(open), graph_(open.graph()), ptc_(ptc), cycles_(2 * graph_.edgeCount()),
      search_(graph_.vertexCount()), depths_(graph_.vertexCount()), costs_(graph_.vertexCount()),
      stamps_(graph_.vertexCount(), 0)
{}

void CostToGo::setTarget(Vertex target, Cost farthest)
{
    target_ = target;
    farthest_ = farthest;
    ++stamp_;
    queue_ = {};
    queue_.emplace(0, target);
}

bool CostToGo::find(Vertex v)
{
    while (cost(v) == kFar)
    {
        if (ptc_())
            return false;
        const auto [reached, u] = queue_.top();
        queue_.pop();
        if (cost(u) != kFar)
            continue;
        stamps_[u] = stamp_;
        costs_[u] = reached;
        const auto neighbors = graph_.neighbors(u);
        for (std::size_t j = 0; j < neighbors.size(); ++j)
            if (open_.isOpen(neighbors[j]) && cost(neighbors[j]) == kFar)
                queue_.emplace(reached + stepCost(u, j), neighbors[j]);
    }
    return true;
}

CostToGo::Cost CostToGo::stepCost(Vertex from, std::size_t neighbor)
{
    const Cycle &cycle = cycles_[arc(from, neighbor)];
    if (cycle.level > open_.level())
        findCycle(from, graph_.neighbors(from)[neighbor]);
    return 1 + std::min(cycle.length - 2, farthest_);
}

/// Where all cycles through the edge are longer than matters, the first length that does not matter is kept:
/// cycles get no shorter while handles are locked.
void CostToGo::findCycle(Vertex a, Vertex b)
{
    const Cost longest = farthest_ + 2;
    Cycle cycle{longest, 0};
    search_.begin();
    search_.visit(a, kNoVertex);
    depths_[a] = 0;
    while (!search_.done() && cycle.length == longest)
    {
        const Vertex u = search_.next();
        if (depths_[u] + 2 >= longest)
            break;
        for (const Vertex w : graph_.neighbors(u))
        {
            if (search_.visited(w) || !open_.isOpen(w) || (u == a && w == b))
                continue;
            search_.visit(w, u);
            depths_[w] = depths_[u] + 1;
            if (w == b)
            {
                cycle.length = depths_[w] + 1;
                for (Vertex v = b; v != kNoVertex; v = search_.parent(v))
                    cycle.level = std::max(cycle.level, open_.ears().level(v));
                break;
            }
        }
    }
    cycles_[*graph_.arc(a, b)] = cycle;
    cycles_[*graph_.arc(b, a)] = cycle;
    spread(a, b, cycle);
    spread(b, a, cycle);
}

/// The edges behind `to` have the same cycles as long as the path does not branch.
void CostToGo::spread(Vertex from, Vertex to, Cycle cycle)
{
    const Vertex first = from;
    while (to != first)
    {
        Vertex next = kNoVertex;
        for (const Vertex w : graph_.neighbors(to))
        {
            if (w == from || !open_.isOpen(w))
                continue;
            if (next != kNoVertex)
                return;
            next = w;
        }
        if (next == kNoVertex)
            return;
        cycles_[*graph_.arc(to, next)] = cycle;
        cycles_[*graph_.arc(next, to)] = cycle;
        from = to;
        to = next;
    }
}

} // namespace mrpp
