#pragma once
/// \file
/// Random solvable instances of the kinds of graphs on which planners differ.

#include "framework/model/Instance.h"
#include "framework/support/Random.h"

namespace mrpp::test
{

/// Where the goals come from.
enum class RandomGoals
{
    moves,     ///< random moves of one robot at a time lead there
    rotations, ///< random moves, and turns of full cycles
    chance     ///< nobody knows whether they can be reached
};

/// A tree, sparse graph, dumbbell, tree with cycle leaves, biconnected graph or grid of 4 to 150 vertices, 1
/// to 6 of them free. The same seed, the same instance.
[[nodiscard]] Instance randomFamilyInstance(Seed seed, RandomGoals goals);

} // namespace mrpp::test
