#pragma once
/// \file
/// Random instances that have a solution.

#include "framework/model/Instance.h"
#include "framework/support/Random.h"

namespace mrpp
{

/// The starts of randomInstance() (Problem.h), and goals that the pebble rule (one robot a step, into an
/// empty vertex) can lead to, so that the instance is solvable under every motion rule.
///
/// Random goals are drawn until the solvability oracle takes them, 32 times at most: they are uniform among
/// the solvable ones. Where this is unlikely (nearly full graphs with corridors) the goals are scrambled
/// starts instead.
///
/// The scramble goes in rounds. Each draws a random breadth-first tree of the largest component and makes as
/// many trips as there are robots: a random robot's vertex and a random empty one are joined by their path in
/// the tree, and every robot on it moves to the place of the next, the last to the empty vertex. 8 to 500
/// rounds, the more the smaller the graph, mix well; nothing is claimed about how evenly.
///
/// The starts of a smaller number of robots are the first of a larger one. **The goals are not**: no scramble
/// can serve two numbers of robots and mix the larger one well. Throws InputError where the component is too
/// small. O(rounds · (V + E + robots · diameter)).
[[nodiscard]] Instance solvableInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed);

} // namespace mrpp
