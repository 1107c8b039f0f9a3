#pragma once
/// \file
/// Random biconnected graphs: a cycle with handles, after P. Surynek, "A novel approach to path planning for
/// multiple robots in bi-connected graphs", ICRA 2009, and section III.B.4 of the MRPPSim paper.
///
/// \code
/// - biconnected: {initial_cycle: 5, handles: 4, max_handle_length: 3, free: 2}
/// \endcode
///
/// Promises: biconnected, `handles` edges more than vertices. The paper leaves open how long a handle is:
/// - `handle: fixed` (as MRPPSim's program did): each has max(1, ⌊max_handle_length / 2⌋) inner vertices;
/// - `handle: uniform`: each has 1 … max_handle_length, drawn uniformly.
/// Both ends of a handle are uniformly random vertices of the graph so far. O(V).

#include "problems/generators/Generator.h"

namespace mrpp
{

class Biconnected : public Generator
{
public:
    Biconnected();

    /// "biconnected 5-4-3": cycle, handles, longest handle.
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    std::int64_t initialCycle_ = 5;
    std::int64_t handles_ = 4;
    std::int64_t maxHandleLength_ = 3;
    std::string handle_ = "fixed";
};

} // namespace mrpp
