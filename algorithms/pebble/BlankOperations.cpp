#include "algorithms/pebble/BlankOperations.h"

#include <algorithm>

namespace mrpp
{

namespace
{
constexpr std::size_t kPoll = 4096;     ///< vertices or steps between two looks at the clock
constexpr std::size_t kLongHandle = 60; ///< longer ones are not worth being filled both ways round
} // namespace

BlankOperations::BlankOperations(OneBlankBoard &board, const TerminationCondition &ptc)
    : board_(board), graph_(board.graph()), ptc_(ptc), locked_(graph_.vertexCount(), 0),
      blankSearch_(graph_.vertexCount()), robotSearch_(graph_.vertexCount()),
      distances_(graph_.vertexCount(), 0)
{}

template <class Wanted>
bool BlankOperations::walkToFirst(Vertex avoid, Wanted &&wanted)
{
    if (ptc_())
        return false;
    blankSearch_.begin();
    blankSearch_.visit(board_.blank(), kNoVertex);
    Vertex found = blankSearch_.next();
    for (std::size_t count = 1; !wanted(found); ++count)
    {
        if (count % kPoll == 0 && ptc_())
            return false;
        const Vertex u = found;
        for (const Vertex w : graph_.neighbors(u))
            if (w != avoid && !isLocked(w) && !blankSearch_.visited(w))
                blankSearch_.visit(w, u);
        assert(!blankSearch_.done());
        found = blankSearch_.next();
    }
    path_.clear();
    for (Vertex v = found; v != board_.blank(); v = blankSearch_.parent(v))
        path_.push_back(v);
    for (std::size_t i = path_.size(); i-- > 0;)
        board_.step(path_[i]);
    return true;
}

bool BlankOperations::bringBlank(Vertex v, Vertex avoid)
{
    return board_.blank() == v || walkToFirst(avoid, [v](Vertex u) { return u == v; });
}

bool BlankOperations::carry(Vertex robot, Vertex v)
{
    const Vertex start = board_.place(robot);
    if (start == v)
        return true;
    robotSearch_.begin();
    robotSearch_.visit(v, kNoVertex);
    distances_[v] = 0;
    for (std::size_t count = 1; !robotSearch_.visited(start); ++count)
    {
        if (count % kPoll == 0 && ptc_())
            return false;
        const Vertex u = robotSearch_.next();
        for (const Vertex w : graph_.neighbors(u))
        {
            if (isLocked(w) || robotSearch_.visited(w))
                continue;
            robotSearch_.visit(w, u);
            distances_[w] = distances_[u] + 1;
        }
    }
    for (Vertex at = start; at != v; at = board_.place(robot))
    {
        const auto isAhead = [&](Vertex u)
        { return robotSearch_.visited(u) && distances_[u] < distances_[at] && graph_.hasEdge(u, at); };
        if (!walkToFirst(at, isAhead))
            return false;
        board_.step(at);
    }
    return true;
}

bool BlankOperations::fill(const Handle &handle)
{
    if (isFilled(handle))
        return true;
    if (handle.inner.size() == 1)
        return carry(handle.inner[0], handle.inner[0]);

    if (handle.inner.size() > kLongHandle)
        return fillFromX(handle);

    // Both ways round; the shorter one counts.
    const OneBlankBoard::Mark start = board_.mark();
    const Handle reversed{handle.y, {handle.inner.rbegin(), handle.inner.rend()}, handle.x};
    if (!fillFromX(handle))
        return false;
    const std::vector<Vertex> first = reducedWalkSince(start);
    if (!takeBack(start) || !fillFromX(reversed))
        return false;
    const std::vector<Vertex> second = reducedWalkSince(start);
    if (!takeBack(start))
        return false;
    const std::vector<Vertex> &shorter = second.size() < first.size() ? second : first;
    for (std::size_t i = 1; i < shorter.size(); ++i)
        board_.step(shorter[i]);
    return true;
}

bool BlankOperations::takeBack(OneBlankBoard::Mark mark)
{
    while (board_.mark() > mark)
    {
        if (ptc_())
            return false;
        board_.rollback(std::max(mark, board_.mark() - std::min(board_.mark(), kPoll)));
    }
    return true;
}

/// From where the blank was at the mark.
std::vector<Vertex> BlankOperations::reducedWalkSince(OneBlankBoard::Mark mark) const
{
    std::vector<Vertex> walk(board_.walk().begin() + static_cast<std::ptrdiff_t>(mark) - 1,
                             board_.walk().end());
    reduceWalk(walk);
    return walk;
}

/// The deepest one, next to y, goes in first: each enters from x, and the push that brings it in brings those
/// before it one vertex deeper.
bool BlankOperations::fillFromX(const Handle &handle)
{
    const std::vector<Vertex> &inner = handle.inner;
    const std::size_t size = inner.size();
    if (!enterFirst(handle))
        return false;
    for (std::size_t entered = 1; entered < size; ++entered)
    {
        const Vertex robot = inner[size - 1 - entered];
        const auto place = std::find(inner.begin(), inner.end(), board_.place(robot));
        setLocked(inner, true);
        const bool done =
            (place == inner.end() || extract(handle, static_cast<std::size_t>(inner.end() - place))) &&
            carry(robot, handle.x) && bringBlank(handle.y, handle.x);
        setLocked(inner, false);
        if (!done)
            return false;
        walkThrough(handle, true);
    }
    return true;
}

bool BlankOperations::enterFirst(const Handle &handle)
{
    return carry(handle.inner.back(), handle.inner.front()) && bringBlank(handle.y, handle.inner.front());
}

bool BlankOperations::enterFirstAgain(const Handle &handle)
{
    const Vertex robot = handle.inner.back();
    Vertex aside = kNoVertex;
    for (const Vertex v : graph_.neighbors(handle.x))
        if (v != handle.y && v != handle.inner.front() && !isLocked(v))
            aside = v;
    setLocked(handle.inner, true);
    bool done = bringBlank(handle.x);
    if (done)
    {
        walkThrough(handle, false);
        done = bringBlank(aside, handle.x);
    }
    if (done)
    {
        board_.step(handle.x);
        done = bringBlank(handle.y, aside);
    }
    if (done)
    {
        walkThrough(handle, true);
        done = carry(robot, handle.x) && bringBlank(handle.y, handle.x);
    }
    if (done)
    {
        walkThrough(handle, true);
        done = bringBlank(handle.y);
    }
    setLocked(handle.inner, false);
    return done;
}

/// One that stands too deep in a handle of which a part is filled: pushed out at y, led aside, and the pushes
/// are undone. The handle's inner vertices are locked.
bool BlankOperations::extract(const Handle &handle, std::size_t pushes)
{
    for (std::size_t i = 0; i < pushes; ++i)
    {
        if (!bringBlank(handle.y))
            return false;
        walkThrough(handle, true);
    }
    Vertex aside = kNoVertex;
    for (const Vertex v : graph_.neighbors(handle.y))
        if (v != handle.x && !isLocked(v) && aside == kNoVertex)
            aside = v;
    if (!bringBlank(aside, handle.y))
        return false;
    board_.step(handle.y);
    for (std::size_t i = 0; i < pushes; ++i)
    {
        if (!bringBlank(handle.x, aside))
            return false;
        walkThrough(handle, false);
    }
    return true;
}

/// The blank goes through a handle from y to x, which pushes everybody towards y, or from x to y.
void BlankOperations::walkThrough(const Handle &handle, bool fromY)
{
    if (fromY)
    {
        for (std::size_t i = handle.inner.size(); i-- > 0;)
            board_.step(handle.inner[i]);
        board_.step(handle.x);
    }
    else
    {
        for (const Vertex v : handle.inner)
            board_.step(v);
        board_.step(handle.y);
    }
}

bool BlankOperations::isFilled(const Handle &handle) const
{
    return std::all_of(handle.inner.begin(), handle.inner.end(),
                       [this](Vertex v) { return board_.target(v) == v; });
}

void BlankOperations::setLocked(std::span<const Vertex> vertices, bool locked)
{
    for (const Vertex v : vertices)
        locked_[v] = locked ? 1 : 0;
}

} // namespace mrpp
