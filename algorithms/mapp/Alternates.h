#pragma once
/// \file
/// Alternate paths of MAPP: how to get from a to c, both neighbours of b, without touching b. Robots that
/// stand in somebody's way are slid along them.

#include "framework/model/Graph.h"

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace mrpp::mapp
{

class Alternates
{
public:
    static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
    /// So many steps more does an alternate path go to keep off somebody's goal.
    static constexpr std::uint32_t kGoalPrice = 4;

    /// Keeps references to both.
    /// \param isGoal nonzero where a vertex is a robot's goal; size V
    /// \param longest the most steps of a path, each goal on it counting kGoalPrice more
    Alternates(const Graph &graph, const std::vector<char> &isGoal, std::uint32_t longest);

    /// The number of a cheapest path from c to a that avoids b, and the vertex `off` as well (kNoVertex:
    /// none); kNone where there is none that is short enough. Found by a search that grows around a; each
    /// triple is searched once. O(vertices within the longest length, at most kMostVertices).
    std::uint32_t find(Vertex a, Vertex b, Vertex c, Vertex off);

    /// The path after c, ending with a.
    [[nodiscard]] std::span<const Vertex> path(std::uint32_t number) const
    {
        return {vertices_.data() + offsets_[number], vertices_.data() + offsets_[number + 1]};
    }

private:
    static constexpr std::size_t kMostVertices = 4096;

    using Triple = std::array<Vertex, 3>;
    struct Hash
    {
        std::size_t operator()(const Triple &t) const
        {
            std::uint64_t h = (std::uint64_t{t[0]} << 32 | t[2]) * 0x9e3779b97f4a7c15U;
            h = (h ^ (h >> 29) ^ t[1]) * 0xbf58476d1ce4e5b9U;
            return static_cast<std::size_t>(h ^ (h >> 32));
        }
    };

    std::uint32_t search(Vertex a, Vertex b, Vertex c, Vertex off);
    void reach(Vertex v, Vertex parent, std::uint32_t cost);

    const Graph &graph_;
    const std::vector<char> &isGoal_;
    std::uint32_t longest_;
    std::unordered_map<Triple, std::uint32_t, Hash> known_;
    std::vector<std::uint32_t> offsets_ = {0};
    std::vector<Vertex> vertices_;

    // The search: costs are small, so that one bucket a cost does.
    std::vector<std::uint32_t> stamps_;
    std::vector<std::uint32_t> costs_;
    std::vector<Vertex> parents_;
    std::vector<std::vector<Vertex>> buckets_;
    std::uint32_t stamp_ = 0;
    std::size_t reached_ = 0;
};

} // namespace mrpp::mapp
