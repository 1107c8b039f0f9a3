#pragma once
/// \file
/// A question: a graph, and for each robot where it starts and where it has to go.

#include "framework/model/Graph.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrpp
{

struct Instance
{
    std::shared_ptr<const Graph> graph;
    std::vector<Vertex> starts; ///< size = robotCount(), pairwise distinct
    std::vector<Vertex> goals;  ///< size = robotCount(), pairwise distinct; a robot's goal may be its start

    [[nodiscard]] std::size_t robotCount() const { return starts.size(); }
    [[nodiscard]] std::size_t freeCount() const { return graph->vertexCount() - starts.size(); }

    /// Robots per vertex, 0 … 1; 0 on an empty graph.
    [[nodiscard]] double occupancy() const;

    /// Why this is no well-formed instance (a vertex that does not exist, two robots with one start or one
    /// goal, …), in words; nothing where it is. Says nothing about whether it can be solved. O(V + robots).
    [[nodiscard]] std::optional<std::string> defect() const;

    /// Depends on the graph's fingerprint, starts and goals. O(V + E).
    [[nodiscard]] std::string fingerprint() const;
};

} // namespace mrpp
