#pragma once
/// \file
/// Graphs that are special for one free vertex, and instances on them.

#include "framework/model/Instance.h"
#include "framework/support/Random.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace mrpp::test
{

/// What bibox_theta takes.
[[nodiscard]] bool isBiconnectedAndNoCycle(const Graph &graph);

/// A cycle of the vertices 0 … size−1, and more edges, which may have more vertices.
[[nodiscard]] std::shared_ptr<const Graph> cycleWith(std::size_t size, std::vector<Graph::Edge> edges);

/// The vertices 0 and 1, joined by paths of so many inner vertices.
[[nodiscard]] std::shared_ptr<const Graph> thetaGraph(const std::vector<std::size_t> &arms);

[[nodiscard]] std::shared_ptr<const Graph> wheel(std::size_t spokes);
[[nodiscard]] std::shared_ptr<const Graph> prism(std::size_t sides);
[[nodiscard]] std::shared_ptr<const Graph> completeBipartite(std::size_t a, std::size_t b);

/// A cycle with random handles; of some three to `vertices` + 9 vertices.
[[nodiscard]] std::shared_ptr<const Graph> randomBiconnected(std::size_t vertices, Random &random);

/// Random starts on all vertices but one, and goals where a random walk of the blank leads.
[[nodiscard]] Instance scrambled(const std::shared_ptr<const Graph> &graph, std::size_t steps, Seed seed);

/// A random instance with one free vertex on a biconnected graph; on bipartite ones, and on theta_0, only
/// where it is solvable. `isOdd` asks for the wrong parity instead.
[[nodiscard]] std::optional<Instance> randomPuzzle(const std::shared_ptr<const Graph> &graph, Seed seed,
                                                   bool isOdd = false);

} // namespace mrpp::test
