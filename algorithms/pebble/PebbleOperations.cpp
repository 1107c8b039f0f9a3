#include "algorithms/pebble/PebbleOperations.h"

#include "framework/analysis/Components.h"

#include <algorithm>

namespace mrpp
{

std::vector<char> unswappable(const Instance &instance)
{
    const Components components(*instance.graph);
    const auto shapes = componentShapes(*instance.graph, components);
    std::vector<char> robots;
    for (const Vertex start : instance.starts)
        robots.push_back(shapes[components.of(start)] == ComponentShape::branching ? 0 : 1);
    return robots;
}

PebbleOperations::PebbleOperations(PebbleBoard &board, const TerminationCondition &ptc)
    : board_(board), graph_(board.graph()), ptc_(ptc), freeSearch_(graph_.vertexCount(), &ptc),
      junctionSearch_(graph_.vertexCount(), &ptc), avoidStamps_(graph_.vertexCount(), 0),
      cycleStamps_(graph_.vertexCount(), 0)
{}

void PebbleOperations::avoid(std::span<const Vertex> vertices)
{
    ++avoidStamp_;
    for (const Vertex v : vertices)
        avoidStamps_[v] = avoidStamp_;
}

bool PebbleOperations::clearVertex(Vertex v, const Blocked &blocked)
{
    const auto isBlocked = [&](Vertex w)
    {
        if (std::find(blocked.vertices.begin(), blocked.vertices.end(), w) != blocked.vertices.end())
            return true;
        if (blocked.cycle && cycleStamps_[w] == cycleStamp_)
            return true;
        const Robot r = board_.occupant(w);
        return blocked.robots != nullptr && r != kNoRobot && (*blocked.robots)[r] != 0;
    };
    if (isBlocked(v))
        return false;
    if (board_.isFree(v))
        return true;

    // How many more vertices to look at after the first free one, if that one is to be avoided.
    constexpr int kPatience = 6;
    int patience = kPatience;
    Vertex target = kNoVertex;
    freeSearch_.begin();
    freeSearch_.visit(v, kNoVertex);
    while (!freeSearch_.done() && (target == kNoVertex || patience-- > 0))
    {
        const Vertex u = freeSearch_.next();
        if (!board_.isFree(u))
        {
            forNeighbors(u,
                         [&](Vertex w)
                         {
                             if (!freeSearch_.visited(w) && !isBlocked(w))
                                 freeSearch_.visit(w, u);
                         });
            continue;
        }
        const bool avoided = avoidStamps_[u] == avoidStamp_;
        if (target == kNoVertex || !avoided)
            target = u;
        if (!avoided)
            break;
    }
    if (target == kNoVertex)
        return false;
    for (Vertex hole = target; hole != v;)
    {
        const Vertex behind = freeSearch_.parent(hole);
        board_.move(board_.occupant(behind), hole);
        hole = behind;
    }
    return true;
}

bool PebbleOperations::push(Robot r, Vertex v, const std::vector<char> *stay)
{
    if (!clearVertex(v, {{board_.position(r)}, stay}))
        return false;
    board_.move(r, v);
    return true;
}

std::span<const Vertex> PebbleOperations::aroundJunction(Vertex junction)
{
    if (random_ == nullptr)
        return graph_.neighbors(junction);
    around_.assign(graph_.neighbors(junction).begin(), graph_.neighbors(junction).end());
    random_->shuffle(std::span(around_));
    return around_;
}

bool PebbleOperations::canSwap(Robot r, Robot s) const
{
    return subgraphs_ == nullptr || (assignment_[r] != kNoSubgraph && assignment_[r] == assignment_[s]);
}

bool PebbleOperations::isJunctionOf(Robot r, Vertex v) const
{
    return graph_.degree(v) >= 3 && (subgraphs_ == nullptr || subgraphs_->of(v) == assignment_[r]);
}

bool PebbleOperations::swap(Robot r, Robot s, const SwapLimits &limits)
{
    if (!canSwap(r, s))
        return false;
    junctionSearch_.begin();
    junctionSearch_.visit(board_.position(r), kNoVertex);
    junctionSearch_.visit(board_.position(s), kNoVertex);
    std::size_t tried = 0;
    while (!junctionSearch_.done() && tried < limits.junctions)
    {
        const Vertex junction = junctionSearch_.next();
        forNeighbors(junction,
                     [&](Vertex w)
                     {
                         if (!junctionSearch_.visited(w))
                             junctionSearch_.visit(w, junction);
                     });
        if (!isJunctionOf(r, junction))
            continue;
        if (ptc_())
            return false;

        path_.clear();
        for (Vertex v = junction; v != kNoVertex; v = junctionSearch_.parent(v))
            path_.push_back(v);
        std::reverse(path_.begin(), path_.end());
        // Two moves for each edge of the way there, as many back, and six for the exchange.
        if (4 * path_.size() + 2 > limits.moves)
            return false;
        ++tried;
        const Robot leader = path_.front() == board_.position(r) ? r : s;
        const Robot follower = leader == r ? s : r;

        const PebbleBoard::Mark start = board_.mark();
        if (multipush(leader, follower, path_) && clear(leader, follower, junction))
        {
            const PebbleBoard::Mark gathered = board_.mark();
            const bool leaderIsThere = board_.position(leader) == junction;
            exchange(leaderIsThere ? leader : follower, leaderIsThere ? follower : leader, junction);
            board_.reverse(start, gathered, r, s);
            return true;
        }
        board_.rollback(start);
    }
    return false;
}

/// *Multipush*: the leader goes along the path, the follower behind it; whoever stands in the way is pushed
/// on. On failure the board is left as it is; swap() takes it back.
bool PebbleOperations::multipush(Robot leader, Robot follower, std::span<const Vertex> path)
{
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const Vertex left = board_.position(leader);
        if (ptc_() || !clearVertex(path[i], {{left, board_.position(follower)}}))
            return false;
        board_.move(leader, path[i]);
        board_.move(follower, left);
    }
    return true;
}

/// *Clear* (de Wilde et al. 2014, four stages): makes two neighbours of the junction free besides the one
/// where one of the pair stands. r stands on the junction, s beside it; in the end one of them stands on it
/// and the other beside it. On failure the board is left as it is; swap() takes it back.
bool PebbleOperations::clear(Robot r, Robot s, Vertex junction)
{
    const Vertex beside = board_.position(s);
    Vertex free = kNoVertex;
    for (const Vertex v : aroundJunction(junction))
    {
        if (!board_.isFree(v))
            continue;
        if (free != kNoVertex)
            return true;
        free = v;
    }

    // Stage 1: push a neighbour's occupant outwards, away from the junction.
    for (const Vertex v : aroundJunction(junction))
    {
        if (v == beside || v == free)
            continue;
        if (!clearVertex(v, {{junction, beside, free}}))
            continue;
        if (free != kNoVertex)
            return true;
        free = v;
    }
    if (free == kNoVertex)
        return false;
    return clearThroughFree(junction, beside, free) || clearThroughBeside(r, s, junction, free) ||
           clearByBackingOff(r, s, junction, free);
}

/// Stage 2: push another neighbour's occupant out through the free one, then free that one again.
bool PebbleOperations::clearThroughFree(Vertex junction, Vertex beside, Vertex free)
{
    for (const Vertex v : aroundJunction(junction))
    {
        const PebbleBoard::Mark mark = board_.mark();
        if (v == beside || v == free || !clearVertex(v, {{junction, beside}}))
            continue;
        if (clearVertex(free, {{junction, beside, v}}))
            return true;
        board_.rollback(mark);
        return false;
    }
    return false;
}

/// Stage 3: the pair steps on into the free neighbour, so that another neighbour's occupant can leave through
/// where the second robot stood. Then s stands on the junction and r beside it.
bool PebbleOperations::clearThroughBeside(Robot r, Robot s, Vertex junction, Vertex free)
{
    const Vertex beside = board_.position(s);
    for (const Vertex v : aroundJunction(junction))
    {
        if (v == beside || v == free)
            continue;
        const PebbleBoard::Mark mark = board_.mark();
        board_.move(r, free);
        board_.move(s, junction);
        const bool left = clearVertex(v, {{junction, free}});
        if (left && clearVertex(beside, {{junction, free, v}}))
            return true;
        board_.rollback(mark);
        if (left)
            return false;
    }
    return false;
}

/// Stage 4: the pair backs off, another robot passes over the junction into the free neighbour and on, and
/// the pair comes back.
bool PebbleOperations::clearByBackingOff(Robot r, Robot s, Vertex junction, Vertex free)
{
    const Vertex beside = board_.position(s);
    if (!clearVertex(beside, {{junction}}))
        return false;
    board_.move(r, beside);
    if (!clearVertex(free, {{junction, beside, board_.position(s)}}))
        return false;
    for (const Vertex v : aroundJunction(junction))
    {
        if (v == beside || v == free || v == board_.position(s))
            continue;
        if (!board_.isFree(v))
        {
            const Robot passing = board_.occupant(v);
            board_.move(passing, junction);
            board_.move(passing, free);
        }
        board_.move(r, junction);
        board_.move(s, beside);
        return clearVertex(free, {{junction, beside, v}});
    }
    return false;
}

/// *Exchange* (Luna and Bekris 2011): six moves around a junction with two free neighbours.
void PebbleOperations::exchange(Robot onJunction, Robot beside, Vertex junction)
{
    const Vertex outside = board_.position(beside);
    Vertex first = kNoVertex;
    Vertex second = kNoVertex;
    for (const Vertex v : aroundJunction(junction))
    {
        if (board_.isFree(v))
        {
            second = first;
            first = v;
        }
    }
    assert(second != kNoVertex);
    board_.move(onJunction, first);
    board_.move(beside, junction);
    board_.move(beside, second);
    board_.move(onJunction, junction);
    board_.move(onJunction, outside);
    board_.move(beside, junction);
}

bool PebbleOperations::rotate(std::span<const Vertex> cycle)
{
    for (std::size_t i = 0; i < cycle.size(); ++i)
    {
        if (board_.isFree(cycle[i]))
        {
            cascade(cycle, i);
            return true;
        }
    }
    ++cycleStamp_;
    for (const Vertex v : cycle)
        cycleStamps_[v] = cycleStamp_;
    for (std::size_t i = 0; i < cycle.size() && !ptc_(); ++i)
    {
        const Vertex exit = cycle[i];
        const std::size_t hole = i == 0 ? cycle.size() - 1 : i - 1;
        const PebbleBoard::Mark start = board_.mark();
        const Robot pushed = board_.occupant(exit);
        cycleStamps_[exit] = 0;
        const bool cleared = clearVertex(exit, {.vertices = {}, .cycle = true});
        cycleStamps_[exit] = cycleStamp_;
        if (!cleared)
            continue;
        const PebbleBoard::Mark pushedOff = board_.mark();
        const Robot next = board_.occupant(cycle[hole]);
        board_.move(next, exit);
        if (swap(pushed, next))
        {
            cascade(cycle, hole);
            board_.reverse(start, pushedOff, pushed, next);
            return true;
        }
        board_.rollback(start);
    }
    return false;
}

/// Every robot on the cycle goes one vertex on; those behind the hole first.
void PebbleOperations::cascade(std::span<const Vertex> cycle, std::size_t hole)
{
    std::size_t to = hole;
    for (std::size_t steps = 1; steps < cycle.size(); ++steps)
    {
        const std::size_t from = to == 0 ? cycle.size() - 1 : to - 1;
        if (!board_.isFree(cycle[from]))
            board_.move(board_.occupant(cycle[from]), cycle[to]);
        to = from;
    }
}

} // namespace mrpp
