#pragma once
/// \file
/// Which configurations of a tiny graph can be reached from which, all at once: exact answers for every
/// instance on it. Shares no code with the solvability tests that it is the yardstick for.

#include "framework/model/Graph.h"
#include "framework/model/MotionRule.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrpp::test
{

/// Visits every configuration of some robots on a graph, single moves and, with rotations, turns of simple
/// cycles (every step of any rule is a sequence of these). Takes vertices^robots · 4 bytes; up to about 8
/// vertices.
class ConfigurationOrbits
{
public:
    ConfigurationOrbits(const Graph &graph, std::size_t robots, MotionRule rule);

    /// Equal for two configurations exactly where legal steps lead from one to the other. \param positions by
    /// robot
    [[nodiscard]] std::uint32_t of(std::span<const Vertex> positions) const
    {
        return orbits_[code(positions)];
    }

    /// Each with its robots' positions.
    [[nodiscard]] const std::vector<std::vector<Vertex>> &configurations() const { return configurations_; }

private:
    static constexpr auto kUnseen = static_cast<std::uint32_t>(-1);

    [[nodiscard]] std::size_t code(std::span<const Vertex> positions) const;
    void enumerate(std::vector<Vertex> &positions, std::size_t robots);
    void flood(const std::vector<Vertex> &first, std::uint32_t orbit);
    void reach(const std::vector<Vertex> &positions, std::uint32_t orbit);

    const Graph &graph_;
    std::vector<std::vector<Vertex>> cycles_; ///< empty without rotations
    std::vector<std::vector<Vertex>> configurations_;
    std::vector<std::uint32_t> orbits_; ///< by code
    std::vector<std::vector<Vertex>> open_;
};

} // namespace mrpp::test
