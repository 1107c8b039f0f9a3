#pragma once
/// \file
/// Trees whose leaves are cycles, the class of graphs that Push and Spin needs rotations for (the small
/// problem tree_with_cycle_leaves is one).
///
/// \code
/// - cycle_leaves: {cycle_size: 4, bridge_length: 5, cycles: 2, free: 6}
/// \endcode
///
/// Promises: `cycles` cycles of `cycle_size` vertices each, and nothing else that is a cycle. Two cycles are
/// joined by a path of `bridge_length` edges; three or more each by such a path to one vertex in the middle.
/// Not random. The cycles come first, each beginning with the vertex at which its path ends; then the paths,
/// each from its cycle on. O(V).

#include "problems/generators/Generator.h"

namespace mrpp
{

class CycleLeaves : public Generator
{
public:
    CycleLeaves();

    /// "cycle_leaves 2×4-5": cycles, their size, length of a bridge.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    std::int64_t cycleSize_ = 4;
    std::int64_t bridgeLength_ = 5;
    std::int64_t cycles_ = 2;
};

} // namespace mrpp
