#pragma once
/// \file
/// How dear it is to bring a robot to a target through the open part of a graph, with few free vertices: each
/// step needs the vertex in front of the robot free, and the nearest free vertex is mostly the one that it
/// has just left, from where the free place has to go around a cycle. So a step along an edge costs the
/// length of the shortest cycle through that edge, less one; never more than where free vertices are near
/// anyway.

#include "algorithms/bibox/OpenGraph.h"
#include "algorithms/pebble/StampedSearch.h"
#include "framework/support/TerminationCondition.h"

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace mrpp
{

class CostToGo
{
public:
    using Cost = std::uint32_t;

    CostToGo(const OpenGraph &open, const TerminationCondition &ptc);

    /// Costs of steps are about the open part as it is now. \param farthest the distance of the nearest free
    /// vertex when it does not matter where the robot came from, about
    void setTarget(Vertex target, Cost farthest);

    /// Looks for v, beginning where the last call stopped. False where the termination condition came first.
    /// \pre v can be reached. O(open part · log) for all calls with one target, and the cycles' lengths.
    [[nodiscard]] bool find(Vertex v);

    /// Moves from v to the target, about; kFar where find() has not come by.
    [[nodiscard]] Cost cost(Vertex v) const { return stamps_[v] == stamp_ ? costs_[v] : kFar; }
    static constexpr Cost kFar = static_cast<Cost>(-1);

private:
    /// The length of a shortest cycle through an arc while nothing above `level` is needed.
    struct Cycle
    {
        Cost length = 0;
        std::uint32_t level = static_cast<std::uint32_t>(-1);
    };

    [[nodiscard]] std::size_t arc(Vertex v, std::size_t neighbor) const
    {
        return static_cast<std::size_t>(graph_.neighbors(v).data() - graph_.neighbors(0).data()) + neighbor;
    }
    [[nodiscard]] Cost stepCost(Vertex from, std::size_t neighbor);
    void findCycle(Vertex a, Vertex b);
    void spread(Vertex from, Vertex to, Cycle cycle);

    const OpenGraph &open_;
    const Graph &graph_;
    const TerminationCondition &ptc_;
    Cost farthest_ = 0;
    Vertex target_ = kNoVertex;
    std::vector<Cycle> cycles_; ///< size = arcs
    StampedSearch search_;
    std::vector<Cost> depths_; ///< of search_

    using Entry = std::pair<Cost, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::vector<Cost> costs_;
    std::vector<std::uint32_t> stamps_; ///< costs_[v] is final where it is stamp_
    std::uint32_t stamp_ = 0;
};

} // namespace mrpp
