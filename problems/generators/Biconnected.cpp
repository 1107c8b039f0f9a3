#include "problems/generators/Biconnected.h"

#include "problems/generators/Drawing.h"
#include "problems/generators/HandleGraph.h"

#include <algorithm>

namespace mrpp
{

Biconnected::Biconnected()
{
    declareParam("initial_cycle", initialCycle_, "3:100000000", "vertices of the first cycle");
    declareParam("handles", handles_, "0:100000000", "how many handles are added to it");
    declareParam("max_handle_length", maxHandleLength_, "1:100000000", "longest handle, see `handle`");
    declareParam("handle", handle_, "fixed,uniform",
                 "inner vertices of each: half the longest (at least 1), or random from 1 to the longest");
}

std::string Biconnected::name() const
{
    return "biconnected " + std::to_string(initialCycle_) + "-" + std::to_string(handles_) + "-" +
           std::to_string(maxHandleLength_);
}

void Biconnected::checkParameters() const
{
    requireSize(static_cast<double>(initialCycle_) +
                static_cast<double>(handles_) * static_cast<double>(maxHandleLength_ + 1));
}

std::shared_ptr<const Graph> Biconnected::makeGraph(Seed seed) const
{
    Random random(seed);
    HandleGraph graph(static_cast<std::size_t>(initialCycle_));
    const auto longest = static_cast<std::size_t>(maxHandleLength_);
    for (std::int64_t i = 0; i < handles_; ++i)
        graph.addRandomHandle(
            handle_ == "uniform" ? 1 + random.below(longest) : std::max<std::size_t>(1, longest / 2), random);
    return drawnGraph(graph.vertexCount(), graph.edges());
}

} // namespace mrpp
