#pragma once
/// \file
/// Random graphs, instances that are solvable because their goals come from legal moves, and solutions for
/// property tests. The same arguments give the same case everywhere.

#include "framework/model/Instance.h"
#include "framework/model/MotionRule.h"
#include "framework/model/Schedule.h"
#include "framework/model/Solution.h"
#include "framework/support/Random.h"

#include <cstddef>
#include <memory>

namespace mrpp::test
{

/// A random tree, each vertex joined to a random earlier one, with `extraEdges` random further edges (fewer
/// where the graph becomes complete); vertex numbers are shuffled.
[[nodiscard]] std::shared_ptr<const Graph> randomConnectedGraph(std::size_t vertices, std::size_t extraEdges,
                                                                Seed seed);

/// Width × height vertices, row by row, each joined to its right and lower neighbour.
[[nodiscard]] std::shared_ptr<const Graph> gridGraph(std::size_t width, std::size_t height);

struct SolvedCase
{
    Instance instance;
    Solution solution; ///< valid for the instance
};

struct ScheduledCase
{
    Instance instance;
    Schedule schedule; ///< valid for the instance
};

/// Random starts, at most `moves` random legal pebble moves (fewer only where no robot can move), and goals
/// where they end. A robot does not go back at once where it has another way. \pre robots ≤ vertices
[[nodiscard]] SolvedCase randomSolvedCase(std::shared_ptr<const Graph> graph, std::size_t robots,
                                          std::size_t moves, Seed seed);

/// Exactly `moves` legal pebble moves of robots chosen by chance, for long solutions: O(1) a move on a board
/// that is not nearly full. \pre robots < vertices, and the graph has edges
[[nodiscard]] SolvedCase randomWalks(std::shared_ptr<const Graph> graph, std::size_t robots,
                                     std::size_t moves, Seed seed);

/// As randomSolvedCase(), with about every third action a rotation, where one is found.
[[nodiscard]] SolvedCase randomSolvedCaseWithRotations(std::shared_ptr<const Graph> graph, std::size_t robots,
                                                       std::size_t actions, Seed seed);

/// An instance that can be solved by pebble moves: the goals are scrambled starts.
[[nodiscard]] Instance randomSolvableInstance(std::shared_ptr<const Graph> graph, std::size_t robots,
                                              Seed seed);

/// `steps` random steps, each legal under the rule, in which every robot that can move does so with
/// probability of about one half.
[[nodiscard]] ScheduledCase randomScheduledCase(std::shared_ptr<const Graph> graph, std::size_t robots,
                                                std::size_t steps, MotionRule rule, Seed seed);

} // namespace mrpp::test
