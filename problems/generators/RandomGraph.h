#pragma once
/// \file
/// Random connected graphs (section III.B.4 of the MRPPSim paper, random graph).
///
/// \code
/// - random: {vertices: 100, edges: 150, occupancy: 0.5}
/// - random: {vertices: 100, mean_degree: 3, robots: 10}
/// \endcode
///
/// Promises: connected, with exactly `edges` edges; or, where `edges` is not given, with vertices ·
/// mean_degree / 2 of them, rounded, at least what connects the graph and at most what makes it complete. A
/// uniformly random spanning tree (RandomTree.h), and as many further edges, drawn uniformly from all the
/// others. (Not uniform over all connected graphs: those with many spanning trees are likelier.)
/// O(V + E log E).

#include "problems/generators/Generator.h"

namespace mrpp
{

class RandomGraph : public Generator
{
public:
    RandomGraph();

    [[nodiscard]] std::string name() const override { return "random " + std::to_string(vertices_); }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

protected:
    void checkParameters() const override;

private:
    [[nodiscard]] std::size_t edgeCount() const;

    std::int64_t vertices_ = 100;
    std::int64_t edges_ = 0; ///< 0: by the mean degree
    double meanDegree_ = 3;
};

} // namespace mrpp
