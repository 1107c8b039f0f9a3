#include "algorithms/mapp/Alternates.h"

#include <algorithm>

namespace mrpp::mapp
{

Alternates::Alternates(const Graph &graph, const std::vector<char> &isGoal, std::uint32_t longest)
    : graph_(graph), isGoal_(isGoal), longest_(longest), stamps_(graph.vertexCount(), 0),
      costs_(graph.vertexCount()), parents_(graph.vertexCount()), buckets_(longest + 1)
{}

std::uint32_t Alternates::find(Vertex a, Vertex b, Vertex c, Vertex off)
{
    const auto [known, isNew] = known_.try_emplace(Triple{a, b, c}, kNone);
    if (isNew)
        known->second = search(a, b, c, kNoVertex);
    const std::uint32_t number = known->second;
    if (number == kNone || off == kNoVertex)
        return number;
    const std::span<const Vertex> found = path(number);
    return std::find(found.begin(), found.end(), off) == found.end() ? number : search(a, b, c, off);
}

void Alternates::reach(Vertex v, Vertex parent, std::uint32_t cost)
{
    stamps_[v] = stamp_;
    costs_[v] = cost;
    parents_[v] = parent;
    buckets_[cost].push_back(v);
    ++reached_;
}

std::uint32_t Alternates::search(Vertex a, Vertex b, Vertex c, Vertex off)
{
    if (++stamp_ == 0)
    {
        std::fill(stamps_.begin(), stamps_.end(), 0);
        stamp_ = 1;
    }
    for (auto &bucket : buckets_)
        bucket.clear();
    reached_ = 0;
    reach(a, kNoVertex, 0);
    for (std::uint32_t cost = 0; cost <= longest_; ++cost)
    {
        for (std::size_t i = 0; i < buckets_[cost].size() && reached_ < kMostVertices; ++i)
        {
            const Vertex v = buckets_[cost][i];
            if (costs_[v] != cost)
                continue;
            if (v == c)
            {
                for (Vertex u = parents_[c]; u != kNoVertex; u = parents_[u])
                    vertices_.push_back(u);
                offsets_.push_back(static_cast<std::uint32_t>(vertices_.size()));
                return static_cast<std::uint32_t>(offsets_.size() - 2);
            }
            for (const Vertex w : graph_.neighbors(v))
            {
                if (w == b || w == off)
                    continue;
                const bool priced = isGoal_[w] != 0 && w != c;
                const std::uint32_t there = cost + 1 + (priced ? kGoalPrice : 0);
                if (there <= longest_ && (stamps_[w] != stamp_ || there < costs_[w]))
                    reach(w, v, there);
            }
        }
    }
    return kNone;
}

} // namespace mrpp::mapp
