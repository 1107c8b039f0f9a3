#pragma once
/// \file
/// What the parts of solvability() share. Each part looks at one component and objects with a reason, or does
/// not.

#include "framework/analysis/Blocks.h"
#include "framework/analysis/Subgraphs.h"
#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mrpp::detail
{

using Objection = std::optional<std::string>;

/// An instance whose robots were brought to the goals' vertices: who is there, and who should be.
struct SolvabilityCase
{
    const Instance &instance;
    const Graph &graph;
    MotionRule rule;
    Blocks blocks;
    std::vector<Vertex>
        places;              ///< by robot, reachable from the starts; together they are the goals' vertices
    std::vector<Robot> have; ///< by vertex: whose place it is, or kNoRobot
    std::vector<Robot> want; ///< by vertex: whose goal it is, or kNoRobot

    [[nodiscard]] bool rotations() const { return rule == MotionRule::rotation; }
};

/// The robots on a sequence of vertices, leaving out vertices without one.
struct Arrangement
{
    Arrangement(const SolvabilityCase &given, std::span<const Vertex> vertices)
    {
        for (const Vertex v : vertices)
        {
            if (given.want[v] == kNoRobot)
                continue;
            have.push_back(given.have[v]);
            want.push_back(given.want[v]);
        }
    }

    std::vector<Robot> have; ///< by place
    std::vector<Robot> want; ///< by goal
};

/// The vertices from `from` to `to` in the search tree of the blocks, both included.
[[nodiscard]] std::vector<Vertex> treePath(const Blocks &blocks, Vertex from, Vertex to);

/// "{3, 5, 8}", or its beginning and its size.
[[nodiscard]] std::string listed(std::span<const Vertex> vertices);

/// The vertices of a cycle as they follow each other. \param edges of a simple cycle \param first one of its
/// vertices
[[nodiscard]] std::vector<Vertex> aroundCycle(std::span<const Blocks::Edge> edges, Vertex first);

/// Names three robots that would have to change their cyclic order; nothing where turning is enough.
/// \param where "on the polygon {0, 1, 2, 3}"
[[nodiscard]] Objection objectToTurning(const Arrangement &arrangement, const std::string &where);

/// Whether the permutation is odd. \pre have and want hold the same robots
[[nodiscard]] bool isOdd(const Arrangement &arrangement);

/// One free vertex, one robot at a time. \param robots those of a branching component of these vertices
[[nodiscard]] Objection objectWithOneFree(const SolvabilityCase &given, std::span<const Robot> robots,
                                          std::span<const Vertex> vertices);

/// No free vertex, with rotations. \param robots those of a branching component of these vertices
[[nodiscard]] Objection objectWithNoneFree(const SolvabilityCase &given, std::span<const Robot> robots,
                                           std::span<const Vertex> vertices);

/// Robots whose place and goal are not of the same class. \param classes by vertex that is a goal
[[nodiscard]] Objection objectToClasses(const SolvabilityCase &given, const Subgraphs &subgraphs,
                                        std::span<const std::uint32_t> classes,
                                        std::span<const Robot> robots);

} // namespace mrpp::detail
