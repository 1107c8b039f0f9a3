#pragma once
/// \file
/// A block (an edge, a cycle, or a biconnected graph) with one blank: whether it can be solved, and how. This
/// is BIBOX-theta.
///
/// The graph is built up from a small *core* by handles (framework/analysis/EarDecomposition.h). They are
/// filled last to first and locked; the core that remains is solved by search if it has at most nine
/// vertices, otherwise it is a theta graph and solved by 3-cycles (ThetaStage.h). What makes this complete:
///
/// * The core of a graph that is not bipartite holds an odd cycle, so that any permutation that is left can
/// be
///   solved on it. On a bipartite graph its parity never changes: half of all permutations cannot be solved.
/// * The core is never theta_0 (seven vertices: arms of 1, 2 and 2 inner vertices, whose one blank makes only
///   120 of 720 permutations), unless that is the whole graph.
///
/// Both by R. M. Wilson, "Graph puzzles, homotopy, and the alternating group", JCT B 16 (1974) 86–96. Method:
/// P. Surynek, "An application of pebble motion on graphs to abstract multi-robot path planning", ICTAI 2009.
///
/// O(n^3) moves. Memory O(V + E + moves).

#include "algorithms/pebble/BlankOperations.h"
#include "framework/analysis/Blocks.h"
#include "framework/support/Random.h"
#include "framework/support/TerminationCondition.h"

#include <memory>
#include <optional>
#include <vector>

namespace mrpp
{

/// A block as a graph of its own, and how it is built up.
struct PreparedBlock
{
    std::vector<Vertex> vertices;       ///< their names in the whole graph
    std::shared_ptr<const Graph> graph; ///< without cut vertices, of two or more vertices
    bool isBipartite = false;
    std::vector<char> sides;     ///< which of the two of a bipartite block, by vertex
    std::vector<Vertex> cycle;   ///< the first one, of odd length unless the block is bipartite …
    std::vector<Handle> handles; ///< … and what is added to it

    /// \param shuffle where given, the vertices are numbered by chance, which decides ties otherwise
    /// Near-linear where the block has short cycles and handles.
    PreparedBlock(const Blocks &blocks, std::uint32_t block, std::optional<Seed> shuffle = std::nullopt);
};

/// Larger blocks are prepared once, not for each attempt: that would take longer than a planner may be deaf.
inline constexpr std::size_t kMostShuffled = 20'000;

/// What has to be done in a block, by the vertices of its own graph. The block must outlive it.
struct BlockPuzzle
{
    const PreparedBlock *block;
    std::vector<Vertex> targets; ///< a permutation: where the one on each vertex goes, the blank too
    Vertex blank = 0;
};

/// Why a block cannot be solved.
enum class BlockObstacle
{
    none,
    cyclicOrder,    ///< a cycle, and the robots follow each other in another order
    oddPermutation, ///< bipartite, and the permutation's parity is not that of the blank's way
    thetaZero,      ///< theta_0, and the permutation is none of its 120
};

/// Whether the graph is theta_0.
[[nodiscard]] bool isThetaZero(const Graph &graph);

/// O(V). Anything where the termination condition says stop.
[[nodiscard]] BlockObstacle obstacle(const BlockPuzzle &puzzle, const TerminationCondition &ptc = {});

/// A walk of the blank, from where it is to its target, that brings everybody home; nothing where the
/// termination condition says stop.
/// \param largestSearch cores of at most so many vertices are solved by search, 0 … 9
/// \pre obstacle(puzzle) == BlockObstacle::none
[[nodiscard]] std::optional<std::vector<Vertex>>
solveBlock(const BlockPuzzle &puzzle, std::size_t largestSearch, const TerminationCondition &ptc);

} // namespace mrpp
