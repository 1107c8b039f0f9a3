#pragma once
/// \file
/// Random solvable instances of the kinds of graphs on which planners differ.

#include "framework/model/Instance.h"
#include "framework/support/Random.h"

namespace mrpp::test
{

/// A tree, sparse graph, dumbbell, tree with cycle leaves, biconnected graph or grid of 4 to 150 vertices, 1
/// to 6 of them free, with goals to which random moves of one robot at a time have led. The same seed, the
/// same instance.
[[nodiscard]] Instance randomFamilyInstance(Seed seed);

} // namespace mrpp::test
