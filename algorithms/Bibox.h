#pragma once
/// \file
/// BIBOX: graphs without cut vertices, two or more free vertices.
///
/// The graph is taken apart into a first cycle and *handles*, paths whose ends are on what was there before
/// (framework/analysis/EarDecomposition.h). The handle that was added last is filled with the robots that
/// belong there, and never touched again: what is left is as well connected as before. In the end there is
/// the first cycle, whose robots are sorted with the help of one vertex beside it. That needs two free
/// vertices and is easier with more, so goals are changed beforehand, as if robots moved, until as many free
/// vertices as possible belong on the first cycle; these moves are made in reverse order at the very end.
///
/// \code
/// Bibox planner;
/// planner.setInstance(instance);
/// planner.setup();
/// planner.solve(TerminationCondition::after(10));
/// \endcode
///
/// Use it for: crowded biconnected graphs. It always solves them, with O(V^3) moves at most, one free vertex
/// being brought around a cycle for each step of a robot; with more free vertices a nearer one is. A block
/// with one free vertex is for BIBOX-theta.
///
/// Complexity: O(V^3) time and moves [V = vertices]; in practice (robots · their distances · lengths of short
/// cycles). Memory O(V + E + moves).
///
/// Source: P. Surynek, "A novel approach to path planning for multiple robots in bi-connected graphs",
/// ICRA 2009, pp. 3613–3619. What is different here: docs/bibox.md.

#include "algorithms/RestartingPlanner.h"
#include "framework/analysis/EarDecomposition.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace mrpp
{

class Bibox final : public RestartingPlanner
{
public:
    Bibox();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;
    void setup() override;
    void clear() override;

private:
    [[nodiscard]] Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;
    [[nodiscard]] EarDecomposition decompose(std::uint64_t number) const;

    std::string handles_ = "shortest";
    std::unique_ptr<const EarDecomposition> ears_; ///< of attempt 0
};

} // namespace mrpp
