#pragma once
/// \file
/// All small graphs, for tests that want every case there is, and the sets of positions between which brute
/// force can exchange robots.

#include "framework/model/Graph.h"
#include "framework/model/MotionRule.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace mrpp::test
{

/// Every connected graph with that many vertices once up to isomorphism, in an order that is always the same:
/// 1, 1, 2, 6, 21, 112, 853 graphs of 1, 2, … 7 vertices. \pre 1 ≤ vertices ≤ 7. A second for 7.
[[nodiscard]] std::vector<std::shared_ptr<const Graph>> connectedGraphs(std::size_t vertices);

/// Every simple cycle once, each a sequence of three or more vertices. For graphs of up to about 12 vertices.
[[nodiscard]] std::vector<std::vector<Vertex>> simpleCycles(const Graph &graph);

/// For each set of occupied vertices (bits of an index) and each vertex of it, the smallest vertex to which
/// legal steps can bring its robot while the same set is occupied again in the end; the robots are not told
/// apart otherwise. Element [set · vertexCount + vertex]. \pre vertexCount ≤ 16
[[nodiscard]] std::vector<Vertex> positionOrbits(const Graph &graph, MotionRule rule);

} // namespace mrpp::test
