#pragma once
/// \file
/// BIBOX-theta: biconnected graphs with a single free vertex.
///
/// The graph is a core to which *handles* (ears) are added one after another. The last handle is filled with
/// the robots that belong there: each is carried to the handle's end, and the *blank*, walking once around
/// the cycle that the handle closes, pushes it in. Then the handle is locked, and the next one follows, until
/// the core is left: a theta graph, solved by 3-cycles, or anything of at most nine vertices, solved by
/// search.
///
/// Use it for: biconnected graphs that are no cycles, with one free vertex. With more it works as well, by
/// treating the others as robots whose moves are not written down; `bibox` and `push_and_rotate` use them
/// better.
///
/// Complexity: O(V^3) moves; on K × K grids some 2.2 K^3. Time is near the number of moves times the distance
/// that the blank looks around for each. Memory O(V + E + moves).
///
/// Source: P. Surynek, "An application of pebble motion on graphs to abstract multi-robot path planning",
/// ICTAI 2009, pp. 151–158. Differences: any biconnected graph is decomposed, with the shortest handles that
/// it has; the last stage needs no table of precomputed macros, see pebble/ThetaStage.h and
/// pebble/BlockPuzzle.h, which also say why it is complete.

#include "algorithms/RestartingPlanner.h"
#include "algorithms/pebble/BlockPuzzle.h"

#include <memory>

namespace mrpp
{

class BiboxTheta final : public RestartingPlanner
{
public:
    BiboxTheta();

    [[nodiscard]] std::optional<std::string> reasonToReject(const Instance &instance) const override;
    void setup() override;
    void clear() override;

protected:
    [[nodiscard]] Outcome attempt(std::uint64_t number, const TerminationCondition &ptc) const override;

private:
    std::int64_t coreSize_ = 9;
    std::unique_ptr<const Blocks> blocks_;
    std::unique_ptr<const PreparedBlock> block_;
};

} // namespace mrpp
