#pragma once
/// \file
/// Random trees as edge lists.

#include "framework/model/Graph.h"
#include "framework/support/Random.h"

#include <vector>

namespace mrpp
{

/// Every labelled tree on the vertices 0 … vertices−1 is equally likely: a random Prüfer sequence (H. Prüfer,
/// "Neuer Beweis eines Satzes über Permutationen", 1918), decoded in O(V). \pre vertices ≥ 1
[[nodiscard]] std::vector<Graph::Edge> uniformTree(std::size_t vertices, Random &random);

/// A random recursive tree: every vertex but the first hangs on a uniformly random one before it, which makes
/// it shallow (depth about e · ln V). \pre vertices ≥ 1. O(V).
[[nodiscard]] std::vector<Graph::Edge> recursiveTree(std::size_t vertices, Random &random);

} // namespace mrpp
