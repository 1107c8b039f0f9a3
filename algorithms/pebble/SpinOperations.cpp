#include "algorithms/pebble/SpinOperations.h"

#include "framework/analysis/BreadthFirstSearch.h"

#include <algorithm>
#include <utility>

namespace mrpp
{

namespace
{

/// A full cycle of more vertices is not turned for a single step of one robot.
constexpr std::size_t kLongestTurn = 16;

/// So many ways to swap a pair are compared, or as many as take so many moves; more are tried only while none
/// works.
constexpr std::size_t kEnoughTries = 16;
constexpr std::size_t kEnoughMoves = 2000;

std::vector<Vertex> positions(const PebbleBoard &board)
{
    std::vector<Vertex> list(board.robotCount());
    for (Robot r = 0; r < board.robotCount(); ++r)
        list[r] = board.position(r);
    return list;
}

} // namespace

SpinOperations::SpinOperations(PebbleBoard &board, const Blocks &blocks, const TerminationCondition &ptc)
    : board_(board), graph_(board.graph()), blocks_(blocks), ptc_(ptc), pebble_(board, ptc),
      free_(blocks, positions(board)), toEntry_(distancesToEntries()), cycles_(graph_, ptc),
      siteSearch_(graph_.vertexCount(), &ptc), siteSteps_(graph_.vertexCount()),
      freeSearch_(graph_.vertexCount(), &ptc), held_(board.robotCount(), 0)
{}

std::vector<std::uint32_t> SpinOperations::distancesToEntries() const
{
    std::vector<std::uint32_t> distances(graph_.vertexCount(), kUnreachable);
    std::vector<Vertex> queue;
    for (Vertex v = 0; v < graph_.vertexCount(); ++v)
    {
        if (!isEntry(v))
            continue;
        distances[v] = 0;
        queue.push_back(v);
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
        for (const Vertex w : graph_.neighbors(queue[i]))
        {
            if (distances[w] != kUnreachable)
                continue;
            distances[w] = distances[queue[i]] + 1;
            queue.push_back(w);
        }
    }
    return distances;
}

bool SpinOperations::push(Robot r, Vertex v, const std::vector<char> *stay)
{
    const Vertex from = board_.position(r);
    const PebbleBoard::Mark start = board_.mark();
    const bool pushed = pebble_.push(r, v, stay);
    // Where nothing is free, turns are all there is.
    const std::size_t longestTurn = free_.inComponent(from) == 0 ? graph_.vertexCount() : kLongestTurn;
    const std::size_t moves = pushed ? board_.mark() - start : longestTurn + 1;
    if (moves <= 3 || blocks_.isBridge(from, v))
        return pushed;
    Solution push = board_.cut(start);
    const auto blocked = [&](Vertex w)
    {
        const Robot other = board_.occupant(w);
        return other == kNoRobot || (stay != nullptr && (*stay)[other] != 0);
    };
    const Cycle cycle = blocked(v) ? Cycle() : cycles_.through(from, v, moves - 1, blocked);
    if (!cycle.empty())
        board_.rotate(cycle);
    else
        board_.replay(push);
    return pushed || !cycle.empty();
}

bool SpinOperations::rotate(std::span<const Vertex> cycle)
{
    std::size_t hole = 0;
    while (hole < cycle.size() && !board_.isFree(cycle[hole]))
        ++hole;
    if (hole == cycle.size())
    {
        board_.rotate(cycle);
        return true;
    }
    for (std::size_t i = 1; i < cycle.size(); ++i)
    {
        const Vertex to = cycle[(hole + cycle.size() - i + 1) % cycle.size()];
        const Vertex from = cycle[(hole + cycle.size() - i) % cycle.size()];
        if (!board_.isFree(from))
            shift(from, to);
    }
    return true;
}

bool SpinOperations::canSwap(Robot r, Robot s) const
{
    return assignment_.empty() || (assignment_[r] != kNoSubgraph && assignment_[r] == assignment_[s]);
}

bool SpinOperations::swap(Robot r, Robot s)
{
    if (!canSwap(r, s))
        return false;
    found_ = false;
    tries_ = spent_ = 0;
    // An exchange needs two free vertices, and where there is room it is the cheapest.
    const bool canExchange = free_.inComponent(board_.position(r)) >= 2;
    if (canExchange)
        exchangeAtJunction({r, s}, {.junctions = 4});
    if (!blocks_.isBridge(board_.position(r), board_.position(s)))
        spinsOnCycle({r, s});
    spinsOutside({r, s});
    if (canExchange && !found_)
        exchangeAtJunction({r, s}, {});
    if (ptc_() || !found_)
        return false;
    board_.replay(best_);
    return true;
}

/// Whether the best way so far will do.
bool SpinOperations::isEnough() const
{
    return found_ && (tries_ >= kEnoughTries || spent_ >= kEnoughMoves);
}

/// Whether to try a way to swap that takes no fewer moves. Chance says no now and then.
bool SpinOperations::isWorthTrying(std::size_t leastMoves)
{
    const bool worth = !found_ || (!isEnough() && leastMoves < best_.pathLength() &&
                                   (random_ == nullptr || random_->below(4) != 0));
    tries_ += worth ? 1 : 0;
    return worth;
}

/// Takes back the moves since `start`, which came to nothing.
void SpinOperations::giveUp(PebbleBoard::Mark start)
{
    spent_ += board_.mark() - start;
    board_.rollback(start);
}

/// The moves since `start` swap the pair: takes them back, and keeps them where they are the fewest so far.
void SpinOperations::tryOut(PebbleBoard::Mark start)
{
    Solution swapped = board_.cut(start);
    spent_ += swapped.pathLength();
    if (found_ && swapped.pathLength() >= best_.pathLength())
        return;
    best_ = std::move(swapped);
    found_ = true;
}

/// One of the pair stands on the entry, the other one outside, and the cycle has a hole: exchanges them and
/// reverses what led there.
void SpinOperations::complete(PebbleBoard::Mark start, Pair pair)
{
    const PebbleBoard::Mark gathered = board_.mark();
    const bool firstIsOutside = board_.position(pair.first) != cycle_[0];
    exchange(board_.position(firstIsOutside ? pair.first : pair.second));
    board_.reverse(start, gathered, pair.first, pair.second);
    tryOut(start);
}

/// *Cycle–cycle*: over the shortest cycle through the pair.
void SpinOperations::spinsOnCycle(Pair pair)
{
    pairCycle_ = cycles_.through(board_.position(pair.first), board_.position(pair.second),
                                 graph_.vertexCount(), [](Vertex) { return false; });
    const std::size_t length = pairCycle_.size();
    // The pair is on the first two vertices; the entries nearest to them need the fewest turns.
    for (std::size_t turns = 0; 2 * turns < length && !isEnough(); ++turns)
    {
        for (const std::size_t entry : {(length - turns) % length, (1 + turns) % length})
        {
            if (graph_.degree(pairCycle_[entry]) < 3)
                continue;
            for (const Vertex outside : graph_.neighbors(pairCycle_[entry]))
            {
                if (std::find(pairCycle_.begin(), pairCycle_.end(), outside) != pairCycle_.end())
                    continue;
                if (ptc_())
                    return;
                if (isWorthTrying(0))
                    spinOnCycle(pair, entry, outside);
            }
        }
    }
}

void SpinOperations::spinOnCycle(Pair pair, std::size_t entry, Vertex outside)
{
    cycle_ = pairCycle_;
    std::rotate(cycle_.begin(), cycle_.begin() + static_cast<std::ptrdiff_t>(entry), cycle_.end());
    const PebbleBoard::Mark start = board_.mark();
    if (freeOutside(pair, outside) && stepOut(pair, outside))
        complete(start, pair);
    else
        giveUp(start);
}

/// Frees the vertex outside: pushes its occupant away from the cycle, or pulls it in.
bool SpinOperations::freeOutside(Pair pair, Vertex outside)
{
    hold(1);
    const bool cleared = pebble_.clearVertex(outside, {{cycle_[0]}, &held_});
    hold(0);
    return cleared || pullIn(pair, outside);
}

void SpinOperations::hold(char value)
{
    for (const Vertex v : cycle_)
        if (!board_.isFree(v))
            held_[board_.occupant(v)] = value;
}

/// The robot outside goes onto the cycle, into a hole that is brought to the entry, but not between the pair.
bool SpinOperations::pullIn(Pair pair, Vertex outside)
{
    const std::size_t length = cycle_.size();
    for (const bool backwards : {false, true})
    {
        const PebbleBoard::Mark start = board_.mark();
        const auto at = [&](std::size_t i) { return cycle_[backwards ? (length - i) % length : i]; };
        std::size_t hole = 0;
        while (hole < length && !board_.isFree(at(hole)))
            ++hole;
        if (hole == length)
            return false;
        for (; hole > 0; --hole)
            shift(at(hole - 1), at(hole));
        const auto isOfPair = [&](Vertex v)
        { return v == board_.position(pair.first) || v == board_.position(pair.second); };
        if (length == 3 || !isOfPair(cycle_[1]) || !isOfPair(cycle_.back()))
        {
            shift(outside, cycle_[0]);
            return true;
        }
        board_.rollback(start);
    }
    return false;
}

/// The cycle turns until one of the pair is on the entry; that one steps out, and the other one follows onto
/// the entry.
bool SpinOperations::stepOut(Pair pair, Vertex outside)
{
    const std::size_t length = cycle_.size();
    const auto place = [&](Robot r)
    {
        return static_cast<std::size_t>(std::find(cycle_.begin(), cycle_.end(), board_.position(r)) -
                                        cycle_.begin());
    };
    std::size_t ahead = place(pair.first);
    std::size_t behind = place(pair.second);
    if ((behind + 1) % length != ahead)
        std::swap(ahead, behind);
    if (behind < (length - ahead) % length)
    {
        // It is the shorter way to turn backwards, with the other one ahead.
        std::reverse(cycle_.begin() + 1, cycle_.end());
        ahead = (length - behind) % length;
    }
    for (std::size_t turns = (length - ahead) % length; turns > 0; --turns)
        if (ptc_() || !rotate(cycle_))
            return false;
    shift(cycle_[0], outside);
    shift(cycle_.back(), cycle_[0]);
    return true;
}

/// *Cycle–bridge* and *bridge–bridge*: at the vertices on cycles that are near the pair.
void SpinOperations::spinsOutside(Pair pair)
{
    // Nothing is looked for where all entries are too far off, as on trees.
    const std::uint32_t nearest =
        std::min(toEntry_[board_.position(pair.first)], toEntry_[board_.position(pair.second)]);
    if (nearest == kUnreachable || (found_ && 4 * (std::size_t{nearest} + 1) + 2 >= best_.pathLength()))
        return;
    const auto visit = [this](Vertex v, Vertex parent, std::uint32_t steps)
    {
        siteSearch_.visit(v, parent);
        siteSteps_[v] = steps;
    };
    siteSearch_.begin();
    visit(board_.position(pair.first), kNoVertex, 0);
    visit(board_.position(pair.second), kNoVertex, 0);
    while (!siteSearch_.done())
    {
        const Vertex entry = siteSearch_.next();
        if (found_ && 4 * (std::size_t{siteSteps_[entry]} + 1) + 2 >= best_.pathLength())
            return;
        for (const Vertex w : graph_.neighbors(entry))
            if (!siteSearch_.visited(w))
                visit(w, entry, siteSteps_[entry] + 1);
        if (!isEntry(entry))
            continue;
        path_.clear();
        for (Vertex v = entry; v != kNoVertex; v = siteSearch_.parent(v))
            path_.push_back(v);
        std::reverse(path_.begin(), path_.end());
        if (ptc_() || isEnough())
            return;
        if (!isWorthTrying(4 * path_.size() + 2))
            continue;
        const bool firstLeads = path_.front() == board_.position(pair.first);
        spinOutside(firstLeads ? pair : Pair{pair.second, pair.first});
    }
}

/// The pair goes along path_ to its end, which is on a cycle, and is exchanged there.
void SpinOperations::spinOutside(Pair pair)
{
    const PebbleBoard::Mark start = board_.mark();
    if (multipush(pair) && openCycle(pair))
        complete(start, pair);
    else
        giveUp(start);
}

/// *Multipush*: the first goes along path_, the second behind it; whoever stands in the way is pushed on.
bool SpinOperations::multipush(Pair pair)
{
    for (std::size_t i = 1; i < path_.size(); ++i)
    {
        const Vertex left = board_.position(pair.first);
        if (ptc_() || !pebble_.clearVertex(path_[i], {{left, board_.position(pair.second)}}))
            return false;
        board_.move(pair.first, path_[i]);
        board_.move(pair.second, left);
    }
    return true;
}

/// The first of the pair stands on an entry, the second beside it. Finds a cycle that begins there, and makes
/// a hole on it.
bool SpinOperations::openCycle(Pair pair)
{
    const Vertex entry = board_.position(pair.first);
    const Vertex outside = board_.position(pair.second);
    cycle_ = cycles_.at(entry, outside);
    if (cycle_.empty())
        return false;
    if (std::any_of(cycle_.begin(), cycle_.end(), [this](Vertex v) { return board_.isFree(v); }))
        return true;
    return makeHole(outside) || openThroughThird(pair);
}

/// Makes a hole on the full cycle behind its entry, from the nearest free vertex that can be reached without
/// the pair.
bool SpinOperations::makeHole(Vertex outside)
{
    freeSearch_.begin();
    for (auto v = cycle_.begin() + 1; v != cycle_.end(); ++v)
        freeSearch_.visit(*v, kNoVertex);
    while (!freeSearch_.done())
    {
        Vertex hole = freeSearch_.next();
        if (board_.isFree(hole))
        {
            for (Vertex from = freeSearch_.parent(hole); from != kNoVertex; from = freeSearch_.parent(hole))
            {
                shift(from, hole);
                hole = from;
            }
            return true;
        }
        for (const Vertex w : graph_.neighbors(hole))
            if (!freeSearch_.visited(w) && w != cycle_[0] && w != outside)
                freeSearch_.visit(w, hole);
    }
    return false;
}

/// All that can be freed is beyond the entry, on a third side of it: the pair goes one vertex on to there,
/// and a robot of the cycle takes the vertex that it leaves.
bool SpinOperations::openThroughThird(Pair pair)
{
    const Vertex entry = cycle_[0];
    const Vertex left = board_.position(pair.second);
    for (const Vertex third : graph_.neighbors(entry))
    {
        if (third == left || std::find(cycle_.begin(), cycle_.end(), third) != cycle_.end())
            continue;
        if (!pebble_.clearVertex(third, {{entry, left}}))
            continue;
        shift(entry, third);
        shift(left, entry);
        board_.rotate(cycle_);
        shift(entry, left);
        shift(cycle_[1], entry);
        return true;
    }
    return false;
}

/// One robot stands on the entry, one outside; afterwards they have changed places, and everybody else is
/// where they were. \pre the cycle has a hole behind its entry
void SpinOperations::exchange(Vertex outside)
{
    const auto isFree = [this](Vertex v) { return board_.isFree(v); };
    const auto first = std::find_if(cycle_.begin(), cycle_.end(), isFree) - cycle_.begin();
    const auto last = cycle_.rend() - std::find_if(cycle_.rbegin(), cycle_.rend(), isFree) - 1;
    if (first == last)
        exchangeByFullTurn(outside, static_cast<std::size_t>(first));
    else
        exchangeBetweenHoles(outside, static_cast<std::size_t>(first), static_cast<std::size_t>(last));
}

/// 2L + 2 moves on a cycle of L vertices.
void SpinOperations::exchangeByFullTurn(Vertex outside, std::size_t hole)
{
    const Vertex entry = cycle_[0];
    for (std::size_t i = hole; i > 0; --i)
        shift(cycle_[i - 1], cycle_[i]);
    shift(outside, entry);
    turned_.assign(cycle_.rbegin(), cycle_.rend());
    board_.rotate(turned_);
    shift(entry, outside);
    shift(cycle_.back(), entry);
    for (std::size_t i = cycle_.size() - 1; i > hole; --i)
        shift(cycle_[i - 1], cycle_[i]);
}

/// 2 (first + L − last) + 2 moves on a cycle of L vertices: six where both holes are next to the entry.
void SpinOperations::exchangeBetweenHoles(Vertex outside, std::size_t first, std::size_t last)
{
    const Vertex entry = cycle_[0];
    for (std::size_t i = first; i > 0; --i)
        shift(cycle_[i - 1], cycle_[i]);
    shift(outside, entry);
    for (std::size_t i = last; i + 1 < cycle_.size(); ++i)
        shift(cycle_[i + 1], cycle_[i]);
    shift(entry, cycle_.back());
    shift(cycle_[1], entry);
    shift(entry, outside);
    shift(cycle_.back(), entry);
    for (std::size_t i = cycle_.size() - 1; i > last; --i)
        shift(cycle_[i - 1], cycle_[i]);
    for (std::size_t i = 1; i < first; ++i)
        shift(cycle_[i + 1], cycle_[i]);
}

/// The exchange of Push and Swap, at a junction with two free neighbours.
void SpinOperations::exchangeAtJunction(Pair pair, const PebbleOperations::SwapLimits &limits)
{
    const PebbleBoard::Mark start = board_.mark();
    if (pebble_.swap(pair.first, pair.second, limits))
        tryOut(start);
}

} // namespace mrpp
