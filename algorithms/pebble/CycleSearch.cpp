#include "algorithms/pebble/CycleSearch.h"

#include <limits>

namespace mrpp
{

std::vector<Vertex> CycleSearch::at(Vertex v, Vertex without)
{
    // Two branches of the search that meet close a cycle; the first level on which that happens has a
    // shortest.
    std::size_t best = std::numeric_limits<std::size_t>::max();
    Vertex left = kNoVertex;
    Vertex right = kNoVertex;
    begin(v);
    while (!search_.done())
    {
        const Vertex u = search_.next();
        if (2 * std::size_t{depths_[u]} + 1 >= best)
            break;
        for (const Vertex w : graph_.neighbors(u))
        {
            if (w == without)
                continue;
            if (!search_.visited(w))
            {
                visit(w, u, depths_[u] + 1);
                continue;
            }
            const std::size_t length = std::size_t{depths_[u]} + depths_[w] + 1;
            if (w != v && u != v && branches_[w] != branches_[u] && length < best)
            {
                best = length;
                left = u;
                right = w;
            }
        }
    }
    std::vector<Vertex> cycle;
    if (left == kNoVertex)
        return cycle;
    cycle.push_back(v);
    appendBranch(cycle, left);
    std::reverse(cycle.begin() + 1, cycle.end());
    appendBranch(cycle, right);
    return cycle;
}

} // namespace mrpp
