#pragma once
/// \file
/// The certain way home: where rules of thumb get stuck on an instance that can be solved, this cannot, if
/// neighbours of one subgraph can always be swapped. Its solutions are long.
///
/// First the robots are brought to the goals' vertices without telling them apart, from the leaves of the
/// graph inwards: the vertices are taken away one after another so that the rest stays connected, and before
/// one is taken away, the nearest robot of the rest comes to it, or the nearest free vertex does. Then each
/// robot that is not at home is exchanged with the one on its goal: it goes along a path within its
/// subgraph by swaps with its neighbours, the other comes back the same way, and all others are where they
/// were. Within a subgraph every permutation is a product of such exchanges.
///
/// Source: D. Kornhauser, G. Miller, P. Spirakis, FOCS 1984 (the reduction to permutations); swaps: see
/// PebbleOperations.h.
///
/// O(V) searches for the first part, O(robots · V) swaps for the second.

#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <concepts>
#include <string>
#include <vector>

namespace mrpp
{

/// Occupies exactly the goals' vertices, by whichever robots. False only where the termination condition says
/// stop. \pre each component has as many goals as robots
bool occupyGoals(const Instance &instance, PebbleBoard &board, const TerminationCondition &ptc);

/// \tparam Operations has swap(Robot, Robot): neighbours exchange places, all others are where they were
template <class Operations>
class Transpositions
{
public:
    /// Keeps references to all of them.
    /// \param assignment the subgraph of each robot; robots on each path must be of one
    Transpositions(const Instance &instance, PebbleBoard &board, Operations &operations,
                   std::span<const std::uint32_t> assignment, const TerminationCondition &ptc)
        : instance_(instance), board_(board), operations_(operations), assignment_(assignment), ptc_(ptc),
          search_(instance.graph->vertexCount())
    {}

    /// Brings every robot home. False where a swap fails, or where the termination condition says stop.
    [[nodiscard]] bool run()
    {
        if (!occupyGoals(instance_, board_, ptc_))
            return false;
        for (Robot r = 0; r < instance_.robotCount(); ++r)
            if (board_.position(r) != instance_.goals[r] && !exchange(r))
                return false;
        return true;
    }

private:
    /// r and the robot on its goal exchange places.
    bool exchange(Robot r)
    {
        const Robot other = board_.occupant(instance_.goals[r]);
        if (other == kNoRobot || !findPath(r))
            return false;
        for (std::size_t i = 1; i < path_.size(); ++i)
            if (!pass(r, path_[i]))
                return false;
        for (std::size_t i = path_.size() - 2; i-- > 0;)
            if (!pass(other, path_[i]))
                return false;
        return true;
    }

    bool pass(Robot r, Vertex v)
    {
        if (ptc_())
            return false;
        if (!board_.isFree(v))
            return operations_.swap(r, board_.occupant(v));
        board_.move(r, v);
        return true;
    }

    /// The shortest path of r to its goal over free vertices and robots of its own subgraph.
    bool findPath(Robot r)
    {
        path_.clear();
        search_.begin();
        search_.visit(instance_.goals[r], kNoVertex);
        while (!search_.done() && !search_.visited(board_.position(r)))
        {
            const Vertex v = search_.next();
            for (const Vertex w : board_.graph().neighbors(v))
                if (!search_.visited(w) &&
                    (board_.isFree(w) || assignment_[board_.occupant(w)] == assignment_[r]))
                    search_.visit(w, v);
        }
        if (!search_.visited(board_.position(r)))
            return false;
        for (Vertex v = board_.position(r); v != kNoVertex; v = search_.parent(v))
            path_.push_back(v);
        return true;
    }

    const Instance &instance_;
    PebbleBoard &board_;
    Operations &operations_;
    std::span<const std::uint32_t> assignment_;
    const TerminationCondition &ptc_;
    StampedSearch search_;
    std::vector<Vertex> path_;
};

} // namespace mrpp
