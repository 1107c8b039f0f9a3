#pragma once
/// \file
/// Carries robots through the open part of a biconnected graph, BIBOX's operation *move robot*: each step of
/// the robot needs the vertex in front of it free, and to free it the nearest free place is brought there
/// around the robot, which turns part of a cycle through both.
///
/// Source: P. Surynek, "A novel approach to path planning for multiple robots in bi-connected graphs",
/// ICRA 2009.

#include "algorithms/bibox/OpenGraph.h"
#include "algorithms/pebble/PebbleBoard.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mrpp
{

class Carrier
{
public:
    /// Keeps references to all of them.
    Carrier(PebbleBoard &board, OpenGraph &open, const TerminationCondition &ptc);

    [[nodiscard]] PebbleBoard &board() { return board_; }
    [[nodiscard]] OpenGraph &open() { return open_; }
    [[nodiscard]] bool stopped() const { return ptc_(); }

    /// Edges on a shortest open path. Nothing where the termination condition came first. O(open vertices
    /// nearer to the target), in all calls with one target at one level together.
    [[nodiscard]] std::optional<std::size_t> distance(Vertex from, Vertex target);

    /// Brings the nearest open free vertex to v; the robot on `avoid` does not move, nor is anybody moved
    /// onto it. \pre such a free vertex can be reached. O(edges of the vertices nearer than it).
    void makeFree(Vertex v, Vertex avoid = kNoVertex);

    /// Brings r to the target. False where the termination condition came first.
    /// \pre the open part is biconnected, or a cycle, and has a free vertex
    [[nodiscard]] bool carry(Robot r, Vertex target);

    /// Moves the robots on line[from … hole−1], or line[hole+1 … from], by one towards the free vertex
    /// line[hole]; free vertices among them stay behind.
    void shift(std::span<const Vertex> line, std::size_t from, std::size_t hole);

private:
    /// The nearest open free vertex; its way to v is in search_.
    [[nodiscard]] Vertex nearestFree(Vertex v, Vertex avoid);
    [[nodiscard]] std::size_t costOfFreeing(Vertex v, Vertex avoid);
    [[nodiscard]] Vertex nextStep(Vertex at);
    [[nodiscard]] bool isNearer(Vertex v, Vertex than) const;

    PebbleBoard &board_;
    OpenGraph &open_;
    const TerminationCondition &ptc_;
    StampedSearch search_; ///< for a free vertex

    StampedSearch distanceSearch_; ///< from the target, as far as was needed
    std::vector<std::uint32_t> distances_;
    Vertex target_ = kNoVertex;
    std::uint32_t targetLevel_ = 0;
};

} // namespace mrpp
