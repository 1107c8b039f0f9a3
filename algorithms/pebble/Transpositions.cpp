#include "algorithms/pebble/Transpositions.h"

namespace mrpp
{

namespace
{

/// The vertices of every component from the leaves of a breadth-first tree inwards: what comes after a vertex
/// stays connected within its component.
std::vector<Vertex> leavesFirst(const Graph &graph)
{
    std::vector<Vertex> order;
    StampedSearch search(graph.vertexCount());
    search.begin();
    for (Vertex root = 0; root < graph.vertexCount(); ++root)
    {
        if (search.visited(root))
            continue;
        search.visit(root, kNoVertex);
        while (!search.done())
        {
            const Vertex v = search.next();
            order.push_back(v);
            for (const Vertex w : graph.neighbors(v))
                if (!search.visited(w))
                    search.visit(w, v);
        }
    }
    std::reverse(order.begin(), order.end());
    return order;
}

} // namespace

bool occupyGoals(const Instance &instance, PebbleBoard &board, const TerminationCondition &ptc)
{
    const Graph &graph = *instance.graph;
    std::vector<char> isGoal(graph.vertexCount(), 0);
    for (const Vertex goal : instance.goals)
        isGoal[goal] = 1;
    std::vector<char> taken(graph.vertexCount(), 0);
    StampedSearch search(graph.vertexCount());
    for (const Vertex v : leavesFirst(graph))
    {
        if (ptc())
            return false;
        const bool wanted = isGoal[v] != 0;
        if (board.isFree(v) == wanted)
        {
            search.begin();
            search.visit(v, kNoVertex);
            Vertex found = v;
            while (board.isFree(found) == wanted && !search.done())
            {
                found = search.next();
                for (const Vertex w : graph.neighbors(found))
                    if (taken[w] == 0 && !search.visited(w))
                        search.visit(w, found);
            }
            if (wanted)
            {
                for (const Robot r = board.occupant(found); found != v; found = search.parent(found))
                    board.move(r, search.parent(found));
            }
            else
            {
                for (; found != v; found = search.parent(found))
                    board.move(board.occupant(search.parent(found)), found);
            }
        }
        taken[v] = 1;
    }
    return true;
}

} // namespace mrpp
