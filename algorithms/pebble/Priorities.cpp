#include "algorithms/pebble/Priorities.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>

namespace mrpp
{

std::vector<Robot> farFirst(const Instance &instance, const Landmarks &landmarks)
{
    const Graph &graph = *instance.graph;
    constexpr std::uint32_t kUnseen = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> depths(graph.vertexCount(), kUnseen);
    std::vector<Vertex> queue(landmarks.centers().begin(), landmarks.centers().end());
    queue.reserve(graph.vertexCount());
    for (const Vertex v : queue)
        depths[v] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
        for (const Vertex w : graph.neighbors(queue[i]))
        {
            if (depths[w] != kUnseen)
                continue;
            depths[w] = depths[queue[i]] + 1;
            queue.push_back(w);
        }
    }
    std::vector<Robot> order(instance.robotCount());
    std::iota(order.begin(), order.end(), Robot{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Robot a, Robot b) { return depths[instance.goals[a]] > depths[instance.goals[b]]; });
    return order;
}

SubgraphPriorities::SubgraphPriorities(const Subgraphs &subgraphs, const Instance &instance,
                                       std::span<const std::uint32_t> assignment)
    : assignment_(assignment.begin(), assignment.end()), subgraphCount_(subgraphs.count())
{
    std::vector<Robot> goalOf(instance.graph->vertexCount(), kNoRobot);
    for (Robot r = 0; r < instance.robotCount(); ++r)
        goalOf[instance.goals[r]] = r;
    for (std::uint32_t subgraph = 0; subgraph < subgraphs.count(); ++subgraph)
    {
        for (const Plank &plank : subgraphs.planks(subgraph))
        {
            const auto goesOn = [&](Vertex v)
            {
                const Robot r = goalOf[v];
                if (r == kNoRobot || assignment_[r] == subgraph)
                    return false;
                if (assignment_[r] == kNoSubgraph)
                    return true;
                before_.emplace_back(subgraph, assignment_[r]);
                return false;
            };
            if (goesOn(plank.join))
                subgraphs.walk(plank, goesOn);
        }
    }
    std::sort(before_.begin(), before_.end());
    before_.erase(std::unique(before_.begin(), before_.end()), before_.end());
}

std::vector<Robot> SubgraphPriorities::arrange(std::span<const Robot> order) const
{
    constexpr std::size_t kNever = static_cast<std::size_t>(-1);
    // Subgraphs in the order of their first robots; those that wait for others are taken when these are done.
    std::vector<std::size_t> firsts(subgraphCount_, kNever);
    for (std::size_t i = order.size(); i-- > 0;)
        if (assignment_[order[i]] != kNoSubgraph)
            firsts[assignment_[order[i]]] = i;
    std::vector<std::uint32_t> waitsFor(subgraphCount_, 0);
    for (const auto &[first, later] : before_)
        ++waitsFor[later];
    using Entry = std::pair<std::size_t, std::uint32_t>; ///< first robot, subgraph
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
    for (std::uint32_t s = 0; s < subgraphCount_; ++s)
        if (waitsFor[s] == 0)
            ready.emplace(firsts[s], s);
    std::vector<std::uint32_t> ranks(subgraphCount_ + 1, kNoSubgraph); // the last of robots without one
    std::uint32_t rank = 0;
    for (; !ready.empty(); ++rank)
    {
        const std::uint32_t s = ready.top().second;
        ready.pop();
        ranks[s] = rank;
        for (auto i = std::lower_bound(before_.begin(), before_.end(), std::pair(s, std::uint32_t{0}));
             i != before_.end() && i->first == s; ++i)
            if (--waitsFor[i->second] == 0)
                ready.emplace(firsts[i->second], i->second);
    }
    for (std::uint32_t &none : ranks)
        if (none == kNoSubgraph)
            none = rank++;
    return sortedByRank(order, ranks);
}

/// By counting: linear, for a million robots.
std::vector<Robot> SubgraphPriorities::sortedByRank(std::span<const Robot> order,
                                                    std::span<const std::uint32_t> ranks) const
{
    const auto rankOf = [&](Robot r) { return ranks[std::min<std::size_t>(assignment_[r], subgraphCount_)]; };
    std::vector<std::size_t> next(ranks.size() + 1, 0);
    for (const Robot r : order)
        ++next[rankOf(r) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Robot> sorted(order.size());
    for (const Robot r : order)
        sorted[next[rankOf(r)]++] = r;
    return sorted;
}

} // namespace mrpp
