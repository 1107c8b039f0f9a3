#pragma once
/// \file
/// Tree-based agent swapping: every solvable instance on a tree with two free vertices or more.
///
/// The tree is filled from its leaves inwards. A leaf that is a goal gets its robot and is taken away; a leaf
/// that is no goal is emptied and taken away, as late as possible, because free vertices are useful. What is
/// left is a tree again, and nobody ever has to pass a robot that is at home. On its way a robot pushes
/// others aside while there is a free vertex ahead of it; where there is none, it *swaps* with the next one
/// at a junction.
///
/// Use it for: trees. Every other graph is refused; push_and_rotate takes those.
///
/// Why it is complete: let r stand before s with no free vertex beyond r in what is left, and r's goal there.
/// As r gets in in the end, somebody from there gets out, past r and past s (if s is not the one). So r
/// belongs to the same subgraph as that robot, s between them does too, and robots of one subgraph that stand
/// side by side can be swapped (de Wilde et al. 2014). A swap that fails is therefore a proof.
///
/// Complexity: O(robots · V) pushes and swaps, O(V) each and O(V) moves; much less in practice. Memory
/// O(V + moves).
///
/// Source: M. M. Khorshid, R. C. Holte, N. R. Sturtevant, "A polynomial-time algorithm for non-optimal
/// multi-agent pathfinding", SoCS 2011. docs/tass.md says what differs.

#include "algorithms/RestartingPlanner.h"

namespace mrpp
{

class Tass final : public RestartingPlanner
{
public:
    Tass();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;

private:
    Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
};

} // namespace mrpp
