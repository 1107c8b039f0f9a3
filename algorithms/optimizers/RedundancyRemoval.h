#pragma once
/// \file
/// Redundancy removal (the paper's smoothing): a robot that leaves a vertex and comes back while nobody else
/// entered that vertex might as well have waited there; the moves in between are deleted.
///
/// Safe because the vertex stays the robot's own in the meantime, and every vertex that the robot no longer
/// visits only becomes emptier. Deleting one walk can make another one redundant; the result has none left.
/// Moves in rotations are never deleted.
///
/// Time O(moves + robots + vertices): every move is deleted at most once. Memory about 44 bytes a move.
///
/// Source: R. Luna, K. E. Bekris, IJCAI 2011 (smoothing); B. de Wilde et al., JAIR 51, 2014; P. Surynek,
/// "Redundancy elimination in highly parallel solutions of motion coordination problems", ICTAI 2011.

#include "framework/Optimizer.h"

namespace mrpp
{

class RedundancyRemoval final : public Optimizer
{
public:
    [[nodiscard]] Solution improve(const Instance &instance, Solution solution,
                                   const TerminationCondition &ptc) const override;
};

} // namespace mrpp
