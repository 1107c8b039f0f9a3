#include "problems/SolvableInstance.h"

#include "framework/Problem.h"
#include "framework/analysis/Components.h"
#include "framework/analysis/Solvability.h"

#include <algorithm>

namespace mrpp
{

namespace
{

constexpr std::uint64_t kDraws = 32; ///< of goals, before they are scrambled starts

/// Robots on the vertices of one component, moved by the pebble rule alone.
class Scramble
{
public:
    Scramble(const Graph &graph, std::vector<Vertex> vertices, std::vector<Vertex> places, Seed seed)
        : graph_(graph), vertices_(std::move(vertices)), places_(std::move(places)), random_(seed),
          occupant_(graph.vertexCount(), kNoRobot), parent_(graph.vertexCount(), kNoVertex),
          depth_(graph.vertexCount(), 0)
    {
        for (Robot r = 0; r < places_.size(); ++r)
            occupant_[places_[r]] = r;
        for (const Vertex v : vertices_)
            if (occupant_[v] == kNoRobot)
                empty_.push_back(v);
    }

    /// Where the robots end.
    std::vector<Vertex> run()
    {
        if (empty_.empty())
            return places_;
        const std::size_t rounds =
            std::clamp<std::size_t>(4'000'000 / (graph_.vertexCount() + graph_.edgeCount()), 8, 500);
        for (std::size_t i = 0; i < rounds; ++i)
        {
            drawTree();
            for (std::size_t trip = 0; trip < places_.size(); ++trip)
                takeTrip();
        }
        return places_;
    }

private:
    void drawTree()
    {
        for (const Vertex v : vertices_)
            parent_[v] = kNoVertex;
        const Vertex root = vertices_[random_.below(vertices_.size())];
        parent_[root] = root;
        depth_[root] = 0;
        queue_.assign(1, root);
        for (std::size_t head = 0; head < queue_.size(); ++head)
        {
            const Vertex v = queue_[head];
            const auto around = graph_.neighbors(v);
            const std::size_t turn = around.empty() ? 0 : random_.below(around.size());
            for (std::size_t i = 0; i < around.size(); ++i)
            {
                const Vertex u = around[(i + turn) % around.size()];
                if (parent_[u] != kNoVertex)
                    continue;
                parent_[u] = v;
                depth_[u] = depth_[v] + 1;
                queue_.push_back(u);
            }
        }
    }

    void takeTrip()
    {
        Vertex &hole = empty_[random_.below(empty_.size())];
        const Vertex from = places_[random_.below(places_.size())];
        // The path from the hole to `from`; upwards from both, up to where they meet.
        path_.clear();
        back_.clear();
        Vertex a = hole;
        Vertex b = from;
        while (a != b)
        {
            Vertex &deeper = depth_[a] >= depth_[b] ? a : b;
            (depth_[a] >= depth_[b] ? path_ : back_).push_back(deeper);
            deeper = parent_[deeper];
        }
        path_.push_back(a);
        path_.insert(path_.end(), back_.rbegin(), back_.rend());
        for (const Vertex v : path_)
            if (occupant_[v] != kNoRobot)
            {
                // All vertices of the path between v and the hole are empty.
                places_[occupant_[v]] = hole;
                std::swap(occupant_[v], occupant_[hole]);
                hole = v;
            }
    }

    const Graph &graph_;
    std::vector<Vertex> vertices_; ///< of the component
    std::vector<Vertex> places_;   ///< by robot
    Random random_;
    std::vector<Robot> occupant_; ///< by vertex
    std::vector<Vertex> empty_;
    std::vector<Vertex> parent_;
    std::vector<std::uint32_t> depth_;
    std::vector<Vertex> queue_;
    std::vector<Vertex> path_;
    std::vector<Vertex> back_;
};

} // namespace

Instance solvableInstance(std::shared_ptr<const Graph> graph, std::size_t robots, Seed seed)
{
    Instance instance = randomInstance(std::move(graph), robots, seed);
    const Components components(*instance.graph);
    for (std::uint64_t draw = 0; draw < kDraws; ++draw)
    {
        if (solvability(instance, MotionRule::pebble).solvable)
            return instance;
        instance.goals =
            randomInstance(instance.graph, robots, deriveSeed(seed, "goals" + std::to_string(draw))).goals;
    }
    Scramble scramble(*instance.graph, components.vertices(components.largest()), instance.starts,
                      deriveSeed(seed, "scramble"));
    instance.goals = scramble.run();
    return instance;
}

} // namespace mrpp
