#pragma once
/// \file
/// Whether an instance has a solution, and if not, why.
///
/// Exact under every motion rule, for any number of free vertices, on any graph; near-linear in time and
/// linear in memory. Nothing is planned: the robots are brought to the goals' vertices without telling them
/// apart (Normalization.h), and the permutation that is left is looked up in the group of the permutations
/// that moves can make:
///
/// | component | free | group |
/// |---|---|---|
/// | path; polygon | any | the order of the robots stays; their cyclic order stays |
/// | other, one robot at a time | none | nothing moves |
/// | other, one robot at a time | 1 | block by block: Wilson, Graph puzzles, homotopy, and the alternating
/// group, 1974 | | other, one robot at a time | ≥ 2 | all permutations of each subgraph's robots
/// (Subgraphs.h): Kornhauser, Miller, Spirakis 1984; de Wilde, ter Mors, Witteveen 2014 | | other, with
/// rotations | none | all permutations of each 2-edge-connected component's robots, or the even ones where
/// every block is an odd cycle | | other, with rotations | ≥ 1 | all permutations of each subgraph's robots |
///
/// \code
/// const Solvability answer = solvability(instance, MotionRule::pebble);
/// if (!answer.solvable)
///     std::cout << answer.reason; // robots 3 and 7 cannot pass each other in the corridor 12–18: it needs …
/// \endcode
///
/// docs/solvability.md explains the reasons; docs/completeness.md has the comparison with brute force.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/support/TerminationCondition.h"

#include <optional>
#include <string>

namespace mrpp
{

struct Solvability
{
    bool solvable = true;
    std::string reason; ///< where it is not: one sentence that names robots and vertices
};

/// \pre instance.defect() is empty. O(V + E + robots · log robots); memory some 150 bytes a vertex.
[[nodiscard]] Solvability solvability(const Instance &instance, MotionRule rule);

/// The same; nothing where the termination condition says stop before it is known.
[[nodiscard]] std::optional<Solvability> solvability(const Instance &instance, MotionRule rule,
                                                     const TerminationCondition &ptc);

} // namespace mrpp
