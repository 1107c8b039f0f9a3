#include "algorithms/bibox/Carrier.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

Carrier::Carrier(PebbleBoard &board, OpenGraph &open, const TerminationCondition &ptc)
    : board_(board), open_(open), ptc_(ptc), costToGo_(open, ptc), search_(board.graph().vertexCount())
{}

void Carrier::setRoom(std::size_t vertices, std::size_t free)
{
    spacing_ = static_cast<CostToGo::Cost>(vertices / free);
}

Vertex Carrier::nearestFree(Vertex v, Vertex avoid)
{
    if (board_.isFree(v))
        return v;
    search_.begin();
    search_.visit(v, kNoVertex);
    while (!search_.done())
    {
        const Vertex u = search_.next();
        for (const Vertex w : board_.graph().neighbors(u))
        {
            if (search_.visited(w) || w == avoid || !open_.isOpen(w))
                continue;
            search_.visit(w, u);
            if (board_.isFree(w))
                return w;
        }
    }
    return kNoVertex;
}

void Carrier::makeFree(Vertex v, Vertex avoid)
{
    Vertex hole = nearestFree(v, avoid);
    assert(hole != kNoVertex);
    while (hole != v)
    {
        const Vertex behind = search_.parent(hole);
        board_.move(board_.occupant(behind), hole);
        hole = behind;
    }
}

Vertex Carrier::nextStep(Vertex at)
{
    const CostToGo::Cost here = costToGo_.cost(at);
    Vertex only = kNoVertex;
    std::size_t nearer = 0;
    for (const Vertex w : board_.graph().neighbors(at))
        if (open_.isOpen(w) && costToGo_.cost(w) < here)
        {
            only = w;
            ++nearer;
        }
    if (nearer == 1)
        return only;
    Vertex best = kNoVertex;
    std::size_t bestCost = 0;
    for (const Vertex w : board_.graph().neighbors(at))
    {
        if (!open_.isOpen(w) || costToGo_.cost(w) >= here)
            continue;
        std::size_t cost = costToGo_.cost(w);
        for (Vertex hole = nearestFree(w, at); hole != w; hole = search_.parent(hole))
            ++cost;
        if (best == kNoVertex || cost < bestCost)
        {
            best = w;
            bestCost = cost;
        }
    }
    return best;
}

bool Carrier::carry(Robot r, Vertex target)
{
    if (board_.position(r) == target)
        return true;
    if (target != target_ || targetLevel_ != open_.level())
    {
        costToGo_.setTarget(target, spacing_);
        target_ = target;
        targetLevel_ = open_.level();
    }
    if (!costToGo_.find(board_.position(r)))
        return false;
    while (board_.position(r) != target)
    {
        if (ptc_())
            return false;
        const Vertex at = board_.position(r);
        const Vertex next = nextStep(at);
        makeFree(next, at);
        board_.move(r, next);
    }
    return true;
}

void Carrier::shift(std::span<const Vertex> line, std::size_t from, std::size_t hole)
{
    assert(board_.isFree(line[hole]));
    while (hole != from)
    {
        const std::size_t behind = from < hole ? hole - 1 : hole + 1;
        const Robot r = board_.occupant(line[behind]);
        if (r != kNoRobot)
            board_.move(r, line[hole]);
        hole = behind;
    }
}

} // namespace mrpp
