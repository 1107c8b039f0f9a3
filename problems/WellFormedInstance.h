#pragma once
/// \file
/// Random well-formed instances: every robot can reach its goal whatever the others do at their starts or
/// goals.
///
/// M. Čáp, J. Vokřínek, A. Kleiner, "Complete Decentralized Method for On-Line Multi-Robot Trajectory
/// Planning in Well-formed Infrastructures", ICAPS 2015: an instance is *well-formed* if between every
/// robot's start and goal there is a path that passes through no other robot's start or goal. Prioritized
/// planning solves every such instance; so does bringing one robot after another to its goal, which is why it
/// is solvable under every motion rule.

#include "framework/model/Instance.h"
#include "framework/support/Random.h"

namespace mrpp
{

/// A well-formed instance with 2 · robots different starts and goals in the largest component.
///
/// Robots are drawn one after another: uniformly random pairs of vertices that are no start or goal yet, each
/// taken if the robots so far stay well-formed with it, never taken back. So the robots of a smaller number
/// are the first of a larger one. As robots can only block paths, many pairs are checked at once (twice as
/// many after a success, half as many after a failure), with the same result as one by one.
///
/// Throws DoesNotFit where the component has too few vertices, or no instance was found by as many checks as
/// look at 2 · 10^8 vertices and edges, at least 100 and at most 100 000; that is no proof that there is
/// none. O(V + E) a check.
[[nodiscard]] Instance wellFormedInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed);

} // namespace mrpp
