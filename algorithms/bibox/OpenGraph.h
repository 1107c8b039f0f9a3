#pragma once
/// \file
/// The part of a graph that is still *open*: the first cycle and the handles up to some level. The interiors
/// of the other handles are *locked*: their robots are at their goals.

#include "framework/analysis/EarDecomposition.h"
#include "framework/model/Graph.h"

#include <cstdint>

namespace mrpp
{

class OpenGraph
{
public:
    OpenGraph(const Graph &graph, const EarDecomposition &ears)
        : graph_(graph), ears_(ears), level_(static_cast<std::uint32_t>(ears.handleCount()))
    {}

    [[nodiscard]] const Graph &graph() const { return graph_; }
    [[nodiscard]] const EarDecomposition &ears() const { return ears_; }

    /// 0: the first cycle alone; i: with the handles 0 … i−1.
    [[nodiscard]] std::uint32_t level() const { return level_; }
    void setLevel(std::uint32_t level) { level_ = level; }

    [[nodiscard]] bool isOpen(Vertex v) const { return ears_.level(v) <= level_; }

private:
    const Graph &graph_;
    const EarDecomposition &ears_;
    std::uint32_t level_;
};

} // namespace mrpp
