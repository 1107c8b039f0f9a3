#include "algorithms/bibox/Carrier.h"

#include <algorithm>
#include <cassert>

namespace mrpp
{

Carrier::Carrier(PebbleBoard &board, OpenGraph &open, const TerminationCondition &ptc)
    : board_(board), open_(open), ptc_(ptc), search_(board.graph().vertexCount()),
      distanceSearch_(board.graph().vertexCount()), distances_(board.graph().vertexCount())
{}

std::optional<std::size_t> Carrier::distance(Vertex from, Vertex target)
{
    if (target != target_ || targetLevel_ != open_.level())
    {
        target_ = target;
        targetLevel_ = open_.level();
        distanceSearch_.begin();
        distanceSearch_.visit(target, kNoVertex);
        distances_[target] = 0;
    }
    constexpr std::size_t kBetweenPolls = 1024;
    for (std::size_t i = 1; !distanceSearch_.visited(from); ++i)
    {
        if (i % kBetweenPolls == 0 && ptc_())
            return std::nullopt;
        const Vertex u = distanceSearch_.next();
        for (const Vertex w : board_.graph().neighbors(u))
        {
            if (distanceSearch_.visited(w) || !open_.isOpen(w))
                continue;
            distanceSearch_.visit(w, u);
            distances_[w] = distances_[u] + 1;
        }
    }
    return distances_[from];
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

std::size_t Carrier::costOfFreeing(Vertex v, Vertex avoid)
{
    std::size_t moves = 0;
    for (Vertex hole = nearestFree(v, avoid); hole != v; hole = search_.parent(hole))
        ++moves;
    return moves;
}

bool Carrier::isNearer(Vertex v, Vertex than) const
{
    return open_.isOpen(v) && distanceSearch_.visited(v) && distances_[v] < distances_[than];
}

/// Of the neighbours nearer to the target, or the first few of them, the one that is freed with the fewest
/// moves.
Vertex Carrier::nextStep(Vertex at)
{
    constexpr int kMostCompared = 8;
    const auto neighbors = board_.graph().neighbors(at);
    const auto nearer = [&](Vertex v) { return isNearer(v, at); };
    auto best = std::find_if(neighbors.begin(), neighbors.end(), nearer);
    auto next = std::find_if(best + 1, neighbors.end(), nearer);
    if (next == neighbors.end())
        return *best;
    std::size_t fewest = costOfFreeing(*best, at);
    for (int i = 1; i < kMostCompared && next != neighbors.end() && !ptc_(); ++i)
    {
        const std::size_t moves = costOfFreeing(*next, at);
        if (moves < fewest)
        {
            best = next;
            fewest = moves;
        }
        next = std::find_if(next + 1, neighbors.end(), nearer);
    }
    return *best;
}

bool Carrier::carry(Robot r, Vertex target)
{
    if (!distance(board_.position(r), target))
        return false;
    while (board_.position(r) != target)
    {
        if (ptc_())
            return false;
        const Vertex at = board_.position(r);
        const Vertex next = nextStep(at);
        if (ptc_())
            return false;
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
