#pragma once
/// \file
/// Random trees.
///
/// \code
/// - tree: {vertices: 50, robots: 4}
/// \endcode
///
/// Promises: connected, one edge fewer than vertices. `shape: uniform` makes every labelled tree equally
/// likely (long arms, depth about √V), `shape: recursive` hangs every vertex on a random one before it
/// (shallow, depth about ln V). O(V). See RandomTree.h for the sources.

#include "problems/generators/Generator.h"

namespace mrpp
{

class Tree : public Generator
{
public:
    Tree();

    [[nodiscard]] std::string name() const override { return "tree " + std::to_string(vertices_); }
    [[nodiscard]] std::shared_ptr<const Graph> makeGraph(Seed seed) const override;

private:
    std::int64_t vertices_ = 50;
    std::string shape_ = "uniform";
};

} // namespace mrpp
