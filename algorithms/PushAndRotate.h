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

#include "algorithms/RestartingPlanner.h"
#include "algorithms/pebble/TrailLoop.h"

#include <atomic>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mrpp
{

class PushAndRotate final : public RestartingPlanner
{
public:
    PushAndRotate();
    ~PushAndRotate() override;

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;
    void setup() override;
    void clear() override;

private:
    struct Preparation;
    struct Choices;

    Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
    [[nodiscard]] TrailSettings settings() const;
    [[nodiscard]] Choices firstChoices(Random &random) const;
    [[nodiscard]] Choices randomChoices(Random &random) const;
    Outcome searchNearby(Random &random, const TerminationCondition &ptc) const;
    /// \param random breaks ties; null: the vertices' numbers do
    Outcome runMainLoop(const Choices &choices, Random *random, const TerminationCondition &ptc) const;
    Outcome runFallback(const TerminationCondition &ptc) const;
    [[nodiscard]] std::size_t lengthWithoutRedundancy(const Outcome &outcome) const;

    std::string order_ = "far_first";
    std::int64_t swapPrice_ = 10;
    std::unique_ptr<const Preparation> prepared_;
    /// Attempts after the first are given up when they are longer.
    mutable std::atomic<std::size_t> mostMoves_ = std::numeric_limits<std::size_t>::max();
    mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

} // namespace mrpp
