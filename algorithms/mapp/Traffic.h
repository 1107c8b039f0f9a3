#pragma once
/// \file
/// The second half of MAPP: robots move along the paths of their Units, those of higher rank first.
///
/// A *progression* lets everybody go on while anybody can: a robot steps onto the next vertex of its path if
/// that is free and in nobody's private zone (where a robot of higher rank stands, or has just been); if a
/// robot of lower rank stands there, a free vertex is brought from the alternate path, or in a tunnel from
/// ahead, by sliding the robots in between. The SLIDABLE robot of highest rank always has a free vertex: the
/// one that it came from. So it arrives. *Repositioning* then undoes what is needed for all others to have a
/// path with a free vertex ahead again, and the next progression begins.
///
/// Source: K.-H. C. Wang, A. Botea, JAIR 42 (2011) 55–90, algorithms 1 to 3 and section 6.

#include "algorithms/mapp/RankSet.h"
#include "algorithms/mapp/Units.h"
#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrpp::mapp
{

class Traffic
{
public:
    /// Keeps references to all of them, and marks who arrives for good in `solved`.
    Traffic(const Instance &instance, const Units &units, const Settings &settings, PebbleBoard &board,
            std::vector<char> &solved, const TerminationCondition &ptc);

    /// Lets everybody go on until nobody can.
    /// \returns how many robots arrived for good
    std::size_t progression();

    /// Takes everybody else back to where a path with a free vertex ahead is sure.
    void repositioning();

    /// How many SLIDABLE robots are not home.
    [[nodiscard]] std::size_t slidableLeft() const { return slidableLeft_; }

private:
    static constexpr std::uint32_t kLast = static_cast<std::uint32_t>(-1);
    /// So many steps for each of its path a robot may spend, in a progression, on making good for pushes.
    static constexpr std::uint32_t kRecoveries = 2;

    /// Where a robot is on its path; taken back with its moves.
    struct Place
    {
        std::uint32_t index = 0; ///< of the last vertex of its path on which it stood
        bool onPath = true;      ///< or has been pushed off
    };
    /// A robot waits for something to happen on a vertex; a list.
    struct Waiting
    {
        std::uint32_t rank = 0;
        std::uint32_t next = kLast;
    };

    void beginProgression();
    bool tryStep(Robot r);
    bool slide(Robot r, Vertex next, std::span<const Vertex> way);
    bool pushAside(Robot r, Vertex next);
    [[nodiscard]] std::span<const Vertex> wayForOthers(Robot r) const;
    /// The vertex from which r was pushed to where it is; kNoVertex where that is not known.
    [[nodiscard]] Vertex wayBack(Robot r) const
    {
        return waysBack_[r].empty() ? kNoVertex : waysBack_[r].back();
    }
    [[nodiscard]] bool isPrivate(Vertex v, Robot r) const;
    [[nodiscard]] bool mayFill(Vertex filled, Vertex emptied, Robot r) const;
    [[nodiscard]] bool isReserved(Vertex v, Robot r) const;
    void stepOnto(Robot r, Vertex v);
    void moveRobot(Robot r, Vertex to);
    void setTrail(Robot r, Vertex v);
    void wait(Vertex v, Robot r);
    void wake(Vertex v);
    void visit(Vertex v, Robot r);
    void arrive(Robot r);
    [[nodiscard]] bool mayStay(Robot r) const;
    void countVisits(PebbleBoard::Mark end);
    void forgetVisits(PebbleBoard::Mark end);
    [[nodiscard]] bool canStop(Robot r) const;
    void countZones(Vertex v, bool isFree);
    [[nodiscard]] std::span<const std::uint32_t> zonesAt(Vertex v) const
    {
        return {zonesAt_.data() + zonesAtOffsets_[v], zonesAt_.data() + zonesAtOffsets_[v + 1]};
    }
    [[nodiscard]] bool contains(Vertex v, std::uint32_t zone) const;
    /// The vertex after the one where r stands on its path; kNoVertex at its end or off the path.
    [[nodiscard]] Vertex nextOf(Robot r) const;

    const Instance &instance_;
    const Graph &graph_;
    const Units &units_;
    const Settings &settings_;
    PebbleBoard &board_;
    std::vector<char> &solved_;
    const TerminationCondition &ptc_;
    std::size_t slidableLeft_ = 0;

    // Robots; size = robots.
    std::vector<std::uint32_t> ranks_; ///< in units_.order(); kLast for those that never move by themselves
    std::vector<Place> places_;
    std::vector<std::uint32_t> reached_;        ///< the farthest index in this progression
    std::vector<std::uint32_t> recoveries_;     ///< steps left that only make good for having been pushed
    std::vector<std::vector<Vertex>> waysBack_; ///< of those pushed off their paths; the next step last
    std::vector<Vertex> trails_;                ///< where it came from, private too; or kNoVertex
    std::vector<std::uint32_t> waitsFor_;       ///< SLIDABLE robots not home whose paths touch its goal
    std::vector<Vertex> begins_;                ///< where it stood when the progression began
    std::vector<Vertex> firstNext_;             ///< nextOf() then
    std::vector<char> stopped_;                 ///< in repositioning: stays where it is

    // Vertices; size = vertices.
    std::vector<Robot> trailOwners_;
    std::vector<Robot> goalOf_; ///< of the SLIDABLE
    std::vector<std::uint32_t> waitingHeads_;
    std::vector<std::uint32_t> visitStamps_; ///< the progression in which visitors_ was written
    std::vector<Robot> visitors_;            ///< the one other robot that was on a goal; kNoRobot: several
    std::vector<std::uint32_t> visits_;      ///< in repositioning: by robots that may come back
    std::vector<std::uint32_t> nextCounts_;  ///< in repositioning: robots whose firstNext_ it is

    std::vector<std::uint32_t> zonesAtOffsets_; ///< size V+1
    std::vector<std::uint32_t> zonesAt_;
    std::vector<std::uint32_t> zoneFree_; ///< free vertices of each zone

    RankSet awake_;
    StampedSearch search_; ///< of pushAside
    std::vector<Waiting> waiting_;
    std::vector<Vertex> waitedFor_; ///< vertices with a list
    std::vector<Place> before_;     ///< of the robot of each move since begin_, before it
    PebbleBoard::Mark begin_ = 0;
    std::uint32_t progressionNumber_ = 0;
    std::size_t arrived_ = 0;
};

} // namespace mrpp::mapp
