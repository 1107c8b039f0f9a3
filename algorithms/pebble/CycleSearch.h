#pragma once
/// \file
/// Short cycles through an edge or a vertex, by one breadth-first search each. Run many times on one graph; a
/// search costs what it visits.

#include "algorithms/pebble/StampedSearch.h"
#include "framework/model/Graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpp
{

class CycleSearch
{
public:
    /// Finds none where the termination condition says stop. Keeps references to both.
    CycleSearch(const Graph &graph, const TerminationCondition &ptc)
        : graph_(graph), search_(graph.vertexCount(), &ptc), depths_(graph.vertexCount()),
          branches_(graph.vertexCount())
    {}

    /// A shortest cycle a, b, … through the edge a–b that has no vertex that `blocked(v)` names; empty where
    /// there is none of at most that many vertices.
    template <class Blocked>
    std::vector<Vertex> through(Vertex a, Vertex b, std::size_t mostVertices, const Blocked &blocked);

    /// A shortest cycle that begins with v and does not go over the vertex `without`; empty where there is
    /// none.
    std::vector<Vertex> at(Vertex v, Vertex without);

private:
    void begin(Vertex root)
    {
        search_.begin();
        visit(root, kNoVertex, 0);
    }
    void visit(Vertex v, Vertex parent, std::uint32_t depth)
    {
        search_.visit(v, parent);
        depths_[v] = depth;
        branches_[v] = depth <= 1 ? v : branches_[parent];
    }
    /// Appends the vertices from v up to, and without, the root.
    void appendBranch(std::vector<Vertex> &cycle, Vertex v) const
    {
        for (; search_.parent(v) != kNoVertex; v = search_.parent(v))
            cycle.push_back(v);
    }

    const Graph &graph_;
    StampedSearch search_;
    std::vector<std::uint32_t> depths_; ///< of vertices that were visited
    std::vector<Vertex> branches_;      ///< the root's neighbour that leads there
};

template <class Blocked>
std::vector<Vertex> CycleSearch::through(Vertex a, Vertex b, std::size_t mostVertices, const Blocked &blocked)
{
    std::vector<Vertex> cycle;
    begin(a);
    visit(b, a, 1);
    search_.next(); // a itself: only b leads on
    while (!search_.done())
    {
        const Vertex v = search_.next();
        if (depths_[v] >= mostVertices)
            break;
        for (const Vertex w : graph_.neighbors(v))
        {
            if (w == a && v != b)
            {
                cycle.push_back(a);
                appendBranch(cycle, v);
                std::reverse(cycle.begin() + 1, cycle.end());
                return cycle;
            }
            if (!search_.visited(w) && !blocked(w))
                visit(w, v, depths_[v] + 1);
        }
    }
    return cycle;
}

} // namespace mrpp
