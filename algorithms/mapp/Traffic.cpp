#include "algorithms/mapp/Traffic.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace mrpp::mapp
{

Traffic::Traffic(const Instance &instance, const Units &units, const Settings &settings, PebbleBoard &board,
                 std::vector<char> &solved, const TerminationCondition &ptc)
    : instance_(instance), graph_(board.graph()), units_(units), settings_(settings), board_(board),
      solved_(solved), ptc_(ptc), ranks_(instance.robotCount(), kLast), places_(instance.robotCount()),
      reached_(instance.robotCount(), 0), recoveries_(instance.robotCount(), 0),
      waysBack_(instance.robotCount()), trails_(instance.robotCount(), kNoVertex),
      waitsFor_(instance.robotCount(), 0), begins_(instance.robotCount()),
      firstNext_(instance.robotCount(), kNoVertex), stopped_(instance.robotCount(), 0),
      trailOwners_(graph_.vertexCount(), kNoRobot), goalOf_(graph_.vertexCount(), kNoRobot),
      waitingHeads_(graph_.vertexCount(), kLast), visitStamps_(graph_.vertexCount(), 0),
      visitors_(graph_.vertexCount(), kNoRobot), visits_(graph_.vertexCount(), 0),
      nextCounts_(graph_.vertexCount(), 0), zonesAtOffsets_(graph_.vertexCount() + 1, 0),
      zoneFree_(units.zones().size(), 0), awake_(units.order().size()), search_(graph_.vertexCount())
{
    for (std::uint32_t rank = 0; rank < units.order().size(); ++rank)
    {
        const Robot r = units.order()[rank];
        ranks_[r] = rank;
        if (!units.isSlidable(r))
            continue;
        ++slidableLeft_;
        goalOf_[instance.goals[r]] = r;
        for (const Robot other : units.crossed(r))
            ++waitsFor_[other];
    }
    // Zones of robots that are not SLIDABLE after all are never asked for.
    for (std::uint32_t zone = 0; zone < zoneFree_.size(); ++zone)
        for (const Vertex v : units.verticesOf(zone))
        {
            ++zonesAtOffsets_[v + 1];
            zoneFree_[zone] += board.isFree(v) ? 1U : 0U;
        }
    for (std::size_t v = 0; v < graph_.vertexCount(); ++v)
        zonesAtOffsets_[v + 1] += zonesAtOffsets_[v];
    zonesAt_.resize(zonesAtOffsets_.back());
    std::vector<std::uint32_t> filled(zonesAtOffsets_.begin(), zonesAtOffsets_.end() - 1);
    for (std::uint32_t zone = 0; zone < zoneFree_.size(); ++zone)
        for (const Vertex v : units.verticesOf(zone))
            zonesAt_[filled[v]++] = zone;
}

Vertex Traffic::nextOf(Robot r) const
{
    const Place &place = places_[r];
    const std::span<const Vertex> path = units_.path(r);
    return place.onPath && place.index + 1 < path.size() ? path[place.index + 1] : kNoVertex;
}

bool Traffic::contains(Vertex v, std::uint32_t zone) const
{
    const std::span<const std::uint32_t> zones = zonesAt(v);
    return std::find(zones.begin(), zones.end(), zone) != zones.end();
}

std::size_t Traffic::progression()
{
    beginProgression();
    for (bool moved = true; moved && !ptc_();)
    {
        moved = false;
        for (const Robot r : units_.order())
            if (solved_[r] == 0)
                awake_.insert(ranks_[r]);
        // Rounds: in each, everybody who is awake tries one step.
        const std::size_t size = units_.order().size();
        std::uint32_t untilPoll = 0;
        while (awake_.next(0) < size)
        {
            for (std::size_t rank = awake_.next(0); rank < size; rank = awake_.next(rank + 1))
            {
                if (untilPoll++ % 1024 == 0 && ptc_())
                    return arrived_;
                const Robot r = units_.order()[rank];
                if (solved_[r] == 0 && tryStep(r))
                    moved = true;
                else
                    awake_.erase(rank);
            }
        }
    }
    return arrived_;
}

void Traffic::beginProgression()
{
    ++progressionNumber_;
    begin_ = board_.mark();
    before_.clear();
    arrived_ = 0;
    waiting_.clear();
    for (const Vertex v : waitedFor_)
        waitingHeads_[v] = kLast;
    waitedFor_.clear();
    for (Robot r = 0; r < solved_.size(); ++r)
    {
        if (solved_[r] != 0)
            continue;
        begins_[r] = board_.position(r);
        firstNext_[r] = nextOf(r);
        reached_[r] = places_[r].index;
        recoveries_[r] = kRecoveries * static_cast<std::uint32_t>(units_.path(r).size());
        waysBack_[r].clear();
        setTrail(r, kNoVertex);
        visit(begins_[r], r);
    }
    for (const Robot r : units_.order())
        if (solved_[r] == 0 && board_.position(r) == instance_.goals[r])
            arrive(r);
}

/// r goes one step along its path, or back to it, if it may. Otherwise it waits.
bool Traffic::tryStep(Robot r)
{
    const bool onPath = places_[r].onPath;
    const Vertex next = onPath ? nextOf(r) : wayBack(r);
    const std::uint32_t step = places_[r].index;
    const bool again = !onPath || step + 1 <= reached_[r];
    if (next == kNoVertex || (again && recoveries_[r] == 0))
        return false;
    if (isPrivate(next, r) || isReserved(next, r))
    {
        wait(next, r);
        return false;
    }
    if (!board_.isFree(next))
    {
        if (!(onPath && slide(r, next, wayForOthers(r))) && !pushAside(r, next))
        {
            wait(next, r);
            return false;
        }
    }
    else if (!mayFill(next, board_.position(r), r))
    {
        wait(next, r);
        return false;
    }
    if (again)
        --recoveries_[r];
    stepOnto(r, next);
    return true;
}

/// Where the robots that stand before r can be slid: an alternate path, or in a tunnel ahead, but not onto
/// the goal of r.
std::span<const Vertex> Traffic::wayForOthers(Robot r) const
{
    const std::uint32_t step = places_[r].index;
    const std::span<const Vertex> alternate = units_.alternate(r, step);
    const std::span<const Vertex> path = units_.path(r);
    if (!alternate.empty() || step + 2 >= path.size())
        return alternate;
    return path.subspan(step + 2, path.size() - step - 3);
}

/// Slides the robots from the vertex before r to the first free vertex on the way from there.
bool Traffic::slide(Robot r, Vertex next, std::span<const Vertex> way)
{
    std::size_t hole = 0;
    while (hole < way.size() && !board_.isFree(way[hole]) && !isPrivate(way[hole], r))
        ++hole;
    if (hole == way.size() || isPrivate(way[hole], r) || isReserved(way[hole], r) ||
        !mayFill(way[hole], board_.position(r), r))
    {
        for (const Vertex v : way.first(std::min(hole + 1, way.size())))
            wait(v, r);
        return false;
    }
    for (; hole > 0; --hole)
        moveRobot(board_.occupant(way[hole - 1]), way[hole]);
    moveRobot(board_.occupant(next), way[0]);
    return true;
}

/// Pushes the robot before r, and those in its way, towards the nearest free vertex that they may enter. More
/// than the paper allows, but it touches no private zone, no buffer zone and no SLIDABLE robot's goal, so
/// that it takes nothing from who is sure to arrive.
bool Traffic::pushAside(Robot r, Vertex next)
{
    constexpr int kMostVertices = 64;
    const Vertex here = board_.position(r);
    search_.begin();
    search_.visit(here, kNoVertex);
    search_.next();
    search_.visit(next, kNoVertex);
    for (int visited = 0; !search_.done() && visited < kMostVertices; ++visited)
    {
        const Vertex v = search_.next();
        if (!board_.isFree(v))
        {
            for (const Vertex w : graph_.neighbors(v))
                if (!search_.visited(w) && goalOf_[w] == kNoRobot && !isPrivate(w, r))
                    search_.visit(w, v);
            continue;
        }
        if (!mayFill(v, here, r))
            continue;
        for (Vertex hole = v; hole != next;)
        {
            const Vertex behind = search_.parent(hole);
            moveRobot(board_.occupant(behind), hole);
            hole = behind;
        }
        return true;
    }
    return false;
}

/// Whether v is in the private zone of a robot that r must not disturb.
bool Traffic::isPrivate(Vertex v, Robot r) const
{
    const Robot there = board_.occupant(v);
    if (there != kNoRobot && there != r && (solved_[there] != 0 || ranks_[there] < ranks_[r]))
        return true;
    const Robot owner = trailOwners_[v];
    return owner != kNoRobot && ranks_[owner] < ranks_[r];
}

/// Robots that only try, and what they push, keep off the goals of the SLIDABLE.
bool Traffic::isReserved(Vertex v, Robot r) const
{
    return !units_.isSlidable(r) && goalOf_[v] != kNoRobot;
}

/// Whether r may fill one vertex and empty another without robbing the buffer zone of one of higher rank.
bool Traffic::mayFill(Vertex filled, Vertex emptied, Robot r) const
{
    for (const std::uint32_t number : zonesAt(filled))
    {
        const Zone &zone = units_.zones()[number];
        const Robot owner = zone.owner;
        if (units_.isSlidable(owner) && solved_[owner] == 0 && ranks_[owner] < ranks_[r] &&
            places_[owner].index <= zone.lastStep && zoneFree_[number] <= zone.need &&
            !contains(emptied, number))
            return false;
    }
    return true;
}

/// One step of r along its path, onto a free vertex.
void Traffic::stepOnto(Robot r, Vertex v)
{
    const Vertex from = board_.position(r);
    moveRobot(r, v);
    setTrail(r, from);
    reached_[r] = std::max(reached_[r], places_[r].index);
    if (v == instance_.goals[r])
        arrive(r);
}

void Traffic::moveRobot(Robot r, Vertex to)
{
    const Vertex from = board_.position(r);
    Place &place = places_[r];
    before_.push_back(place);
    board_.move(r, to);
    countZones(from, true);
    countZones(to, false);
    const std::span<const Vertex> path = units_.path(r);
    const auto isAt = [&](std::size_t index) { return index < path.size() && path[index] == to; };
    place.onPath = true;
    if (isAt(std::size_t{place.index} + 1))
        ++place.index;
    else if (place.index > 0 && isAt(std::size_t{place.index} - 1))
        --place.index;
    else
        place.onPath = isAt(place.index);
    std::vector<Vertex> &back = waysBack_[r];
    if (place.onPath)
        back.clear();
    else if (!back.empty() && back.back() == to)
        back.pop_back();
    else
        back.push_back(from);
    setTrail(r, kNoVertex);
    visit(to, r);
    wake(from);
    if (ranks_[r] != kLast)
        awake_.insert(ranks_[r]);
}

void Traffic::setTrail(Robot r, Vertex v)
{
    const Vertex old = std::exchange(trails_[r], v);
    if (old != kNoVertex && trailOwners_[old] == r)
    {
        trailOwners_[old] = kNoRobot;
        wake(old);
    }
    if (v != kNoVertex && (trailOwners_[v] == kNoRobot || ranks_[r] < ranks_[trailOwners_[v]]))
        trailOwners_[v] = r;
}

void Traffic::wait(Vertex v, Robot r)
{
    if (waitingHeads_[v] == kLast)
        waitedFor_.push_back(v);
    waiting_.push_back({ranks_[r], waitingHeads_[v]});
    waitingHeads_[v] = static_cast<std::uint32_t>(waiting_.size() - 1);
}

void Traffic::wake(Vertex v)
{
    for (std::uint32_t i = std::exchange(waitingHeads_[v], kLast); i != kLast; i = waiting_[i].next)
        awake_.insert(waiting_[i].rank);
}

/// Notes who else was on a goal in this progression.
void Traffic::visit(Vertex v, Robot r)
{
    if (instance_.goals[r] == v)
        return;
    visitors_[v] = visitStamps_[v] != progressionNumber_ || visitors_[v] == r ? r : kNoRobot;
    visitStamps_[v] = progressionNumber_;
}

/// Whether r, at its goal, may stay there for good: nobody needs to pass any more, and nobody has to come
/// back over it in repositioning.
bool Traffic::mayStay(Robot r) const
{
    if (waitsFor_[r] > 0)
        return false;
    const Vertex goal = instance_.goals[r];
    return visitStamps_[goal] != progressionNumber_ ||
           (visitors_[goal] != kNoRobot && solved_[visitors_[goal]] != 0);
}

/// r is at its goal. Where it may stay, others that waited for it may, too.
void Traffic::arrive(Robot r)
{
    if (solved_[r] != 0 || !mayStay(r))
        return;
    std::vector<Robot> home = {r};
    while (!home.empty())
    {
        const Robot last = home.back();
        home.pop_back();
        solved_[last] = 1;
        ++arrived_;
        setTrail(last, kNoVertex);
        if (!units_.isSlidable(last))
            continue;
        --slidableLeft_;
        goalOf_[instance_.goals[last]] = kNoRobot;
        for (const Robot other : units_.crossed(last))
        {
            --waitsFor_[other];
            if (solved_[other] == 0 && board_.position(other) == instance_.goals[other] && mayStay(other) &&
                std::find(home.begin(), home.end(), other) == home.end())
                home.push_back(other);
        }
    }
}

void Traffic::countZones(Vertex v, bool isFree)
{
    for (const std::uint32_t zone : zonesAt(v))
        zoneFree_[zone] += isFree ? 1U : static_cast<std::uint32_t>(-1);
}

void Traffic::repositioning()
{
    const PebbleBoard::Mark end = board_.mark();
    const bool counting = settings_.counting;
    if (counting)
        countVisits(end);
    std::fill(stopped_.begin(), stopped_.end(), 0);
    for (PebbleBoard::Mark i = end; i-- > begin_;)
    {
        if (i % 1024 == 0 && ptc_())
            return;
        const Move move = board_.moves()[i];
        const Robot r = move.robot;
        if (solved_[r] != 0)
            continue;
        if (stopped_[r] == 0 && counting && canStop(r))
        {
            stopped_[r] = 1; // it stays, and will not come back to where it was before
            --visits_[begins_[r]];
            continue;
        }
        if (counting)
            --visits_[move.to];
        if (stopped_[r] != 0)
            continue;
        assert(board_.isFree(move.from));
        board_.move(r, move.from);
        countZones(move.to, true);
        countZones(move.from, false);
        places_[r] = before_[i - begin_];
    }
    if (counting)
        forgetVisits(end);
}

/// For each vertex, how often somebody may come back to it: visits_ and nextCounts_.
void Traffic::countVisits(PebbleBoard::Mark end)
{
    for (Robot r = 0; r < solved_.size(); ++r)
    {
        if (solved_[r] != 0)
            continue;
        ++visits_[begins_[r]];
        if (firstNext_[r] != kNoVertex)
            ++nextCounts_[firstNext_[r]];
    }
    for (const Move &move : board_.moves().subspan(begin_, end - begin_))
        if (solved_[move.robot] == 0)
            ++visits_[move.to];
}

void Traffic::forgetVisits(PebbleBoard::Mark end)
{
    for (Robot r = 0; r < solved_.size(); ++r)
    {
        visits_[begins_[r]] = 0;
        if (firstNext_[r] != kNoVertex)
            nextCounts_[firstNext_[r]] = 0;
    }
    for (const Move &move : board_.moves().subspan(begin_, end - begin_))
        visits_[move.to] = 0;
}

/// *Repositioning with counting*: whether r may stay where it is. It has a free vertex ahead that nobody
/// comes back to, and is in nobody's way back.
bool Traffic::canStop(Robot r) const
{
    const Vertex v = board_.position(r);
    if (visits_[v] != 1 || nextCounts_[v] != (firstNext_[r] == v ? 1U : 0U) || isReserved(v, r))
        return false;
    if (ranks_[r] != kLast)
    {
        const Vertex next = nextOf(r);
        const bool arrived = places_[r].onPath && v == instance_.goals[r];
        if (!arrived && (next == kNoVertex || !board_.isFree(next) || visits_[next] != 0))
            return false;
    }
    const std::span<const std::uint32_t> zones = zonesAt(v);
    return std::all_of(zones.begin(), zones.end(),
                       [&](std::uint32_t number)
                       {
                           const Robot owner = units_.zones()[number].owner;
                           return owner == r || solved_[owner] != 0 || contains(begins_[r], number);
                       });
}

} // namespace mrpp::mapp
