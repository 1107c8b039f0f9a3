#pragma once
/// \file
/// The symmetries of a small graph, to look at one instance of each kind only.

#include "framework/model/Graph.h"

#include <span>
#include <vector>

namespace mrpp::test
{

class Symmetries
{
public:
    using Symmetry = std::vector<Vertex>; ///< where each vertex goes; size = vertices

    /// Tries all permutations: for graphs of up to seven or eight vertices.
    explicit Symmetries(const Graph &graph);

    /// Whether no symmetry leads to a set of vertices that comes before this one. \param set ascending
    [[nodiscard]] bool isFirst(std::span<const Vertex> set) const;

    /// Those that lead from the set to itself, but for the identity. \param set ascending
    [[nodiscard]] std::vector<Symmetry> keeping(std::span<const Vertex> set) const;

    /// Whether none of the symmetries, which keep the goals, leads to starts that come before these. A robot
    /// is whoever has its goal: the symmetry renames it. \param goals ascending
    [[nodiscard]] static bool isFirst(std::span<const Vertex> starts, std::span<const Vertex> goals,
                                      std::span<const Symmetry> keepingGoals);

private:
    std::vector<Symmetry> all_;
};

} // namespace mrpp::test
