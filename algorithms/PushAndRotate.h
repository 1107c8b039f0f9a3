#pragma once
/// \file
/// Push and Rotate.
///
/// Robots go home one after another, by pushes and swaps, as in Push and Swap. What makes it complete: the
/// graph is decomposed into *subgraphs* within which robots can be exchanged, robots are assigned to them,
/// and one subgraph is planned after another so that nobody is locked in; robots that had arrived and gave
/// way are brought back along a *trail*, on which a closed cycle is *rotated*.
///
/// Use it for: any instance with at least two free vertices in each component in which somebody must move. It
/// solves it, or proves that it cannot be solved.
///
/// \code
/// PushAndRotate planner;
/// planner.parameters().set("restarts", "1000"); // small problems: shorter solutions
/// planner.setInstance(instance);
/// planner.setup();
/// const PlannerStatus status = planner.solve(TerminationCondition::after(10));
/// \endcode
///
/// Complexity: setup O(V + E); then one path search a robot plus what pushes and swaps touch. O(robots · V)
/// moves without swaps, at most O(robots · V^3) with them; in practice near the sum of the shortest
/// distances. Memory O(V + E + moves).
///
/// Source: B. de Wilde, A. W. ter Mors, C. Witteveen, "Push and Rotate: a complete multi-agent pathfinding
/// algorithm", JAIR 51 (2014) 443–492. docs/push_and_rotate.md says what differs.

#include "algorithms/TrailPlanner.h"

namespace mrpp
{

class PushAndRotate final : public TrailPlanner
{
public:
    PushAndRotate();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;

private:
    [[nodiscard]] Outcome start(const Run &run) const override;
};

} // namespace mrpp
