#pragma once
/// \file
/// Graphs without cut vertices, for the planners of such graphs.

#include "framework/model/Graph.h"
#include "framework/support/Random.h"

#include <memory>

namespace mrpp::test
{

/// One block of three or more vertices, and nothing beside it.
[[nodiscard]] bool isBiconnected(const Graph &graph);

/// A cycle with handles whose ends are random, as is the number of their inner vertices, 1 … longest.
[[nodiscard]] std::shared_ptr<const Graph> cycleWithHandles(std::size_t cycle, std::size_t handles,
                                                            std::size_t longest, Seed seed);

/// Biconnected and no cycle, 4 to some 60 vertices: by turns of the seed a cycle with random handles, a theta
/// graph, wheel, ladder, prism, complete graph, complete bipartite graph, grid, or the largest block of a map
/// with random obstacles or of a random graph.
[[nodiscard]] std::shared_ptr<const Graph> randomBiconnectedGraph(Seed seed);

} // namespace mrpp::test
