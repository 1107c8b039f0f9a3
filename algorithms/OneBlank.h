#pragma once
/// \file
/// Everything that can be solved with one free vertex.
///
/// With a single free vertex, the *blank*, everything is a walk of the blank, and walking back undoes it.
/// Root the tree of blocks (biconnected components) where the blank has to be in the end. A robot can then
/// never leave its block: going out of a block and coming back through the same cut vertex restores
/// whatever it changed outside. So each block is a puzzle of its own, with the blank at the cut vertex
/// towards the root in the end: on a single edge nothing can change, a cycle can be turned, and what is
/// richer is solved by BIBOX-theta (pebble/BlockPuzzle.h). On the way from where the blank starts to the root
/// a block is entered at one vertex and left at another. The walks of the blocks are put into each other
/// where they meet, so that nothing has to be visited twice.
///
/// Use it for: any graph of which each connected component has exactly one free vertex, or nobody who has to
/// move. It finds a solution, or proves that there is none and says why.
///
/// Complexity: O(V + E) beside the blocks' own, at most O(V^3) moves. Memory O(V + E + moves).
///
/// Sources: R. M. Wilson, "Graph puzzles, homotopy, and the alternating group", JCT B 16 (1974) 86–96;
/// D. Kornhauser, G. Miller, P. Spirakis, "Coordinating pebble motion on graphs, the diameter of permutation
/// groups, and applications", FOCS 1984; P. Surynek, ICTAI 2009, for the blocks.

#include "algorithms/RestartingPlanner.h"
#include "algorithms/pebble/BlockPuzzle.h"
#include "framework/analysis/Components.h"

#include <map>
#include <memory>

namespace mrpp
{

class OneBlank final : public RestartingPlanner
{
public:
    OneBlank();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;
    void setup() override;
    void clear() override;

protected:
    [[nodiscard]] Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;

private:
    std::int64_t coreSize_ = 9;
    std::unique_ptr<const Blocks> blocks_;
    std::unique_ptr<const Components> components_;
    std::map<std::uint32_t, PreparedBlock> prepared_; ///< the large blocks
};

} // namespace mrpp
