#pragma once
/// \file
/// Random graphs with a set longest isthmus, for objectives 7 and 8 of the MRPPSim paper: what Push and Spin
/// can solve depends on whether as many vertices are free as the longest isthmus has edges.
///
/// \code
/// - fg_vr: {graph: {isthmus: {vertices: 100, longest_isthmus: x}}, free: x, x: {from: 2, to: 60, step: 2}}
/// \endcode
///
/// An *isthmus* is a path of bridges whose inner vertices lie on no cycle; its length is its number of edges.
/// Promises: connected; exactly `vertices` vertices; the longest isthmus has exactly `longest_isthmus` edges;
/// every vertex of degree 3 or more lies on a cycle. `blocks` random biconnected graphs (HandleGraph.h,
/// handles of 1 … max_handle_length inner vertices) are joined to a random tree by isthmuses between
/// uniformly random vertices of theirs: the first of the given length, the others of 1 … that length. O(V).

#include "problems/generators/Generator.h"

namespace mrpp
{

class Isthmus : public Generator
{
public:
    Isthmus();

    /// "isthmus 100-46": vertices, longest isthmus.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    std::int64_t vertices_ = 100;
    std::int64_t longestIsthmus_ = 10;
    std::int64_t blocks_ = 2;
    std::int64_t maxHandleLength_ = 4;
};

} // namespace mrpp
