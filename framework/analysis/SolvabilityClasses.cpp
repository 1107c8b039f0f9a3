/// \file
/// Two or more free vertices, or rotations and one or more: the robots of a subgraph are permuted at will,
/// and no robot changes its class. Where one would have to, this finds the corridor that is too long.

#include "framework/analysis/SolvabilityCase.h"

#include <algorithm>
#include <cassert>
#include <fmt/core.h>
#include <utility>

namespace mrpp::detail
{

namespace
{

/// A path over vertices of degree two from u to v, each a seed or a leaf.
struct Corridor
{
    Vertex u = kNoVertex;
    Vertex v = kNoVertex;
    std::uint32_t length = 0; ///< edges
};

/// Where robots of different classes are neighbours.
struct Border
{
    Corridor corridor; ///< that keeps them apart
    Vertex join =
        kNoVertex; ///< the one of the two that no subgraph can get hold of, if it is not in the corridor
    Vertex a = kNoVertex; ///< otherwise, an edge of the corridor between them: near end
    Vertex b = kNoVertex; ///< and far end
};

class ClassObjection
{
public:
    ClassObjection(const SolvabilityCase &given, const Subgraphs &subgraphs,
                   std::span<const std::uint32_t> classes)
        : given_(given), subgraphs_(subgraphs), classes_(classes), free_(given.blocks, given.instance.goals)
    {}

    /// \param robot its place and its goal are of different classes
    [[nodiscard]] std::string explain(Robot robot, std::span<const Robot> robots)
    {
        const std::vector<Vertex> path =
            treePath(given_.blocks, given_.places[robot], given_.instance.goals[robot]);
        findNeighbours(path);
        const Border border = findBorder();
        const Corridor &corridor = border.corridor;
        const Robot other = robotThatComesBack(border, robots);
        const bool deadEnd = isLeaf(corridor.u) || isLeaf(corridor.v);
        return fmt::format(
            "robots {} and {} cannot pass each other in the {} {}–{}: it needs {} free vertices, there "
            "{} {}",
            std::min(robot, other), std::max(robot, other), deadEnd ? "dead end" : "corridor", corridor.u,
            corridor.v, need(corridor), m() == 1 ? "is" : "are", m());
    }

private:
    [[nodiscard]] std::uint32_t m() const { return free_.inComponent(near_); }
    [[nodiscard]] bool isLeaf(Vertex v) const { return given_.graph.degree(v) == 1; }
    /// The robot on v belongs to a subgraph.
    [[nodiscard]] bool belongs(Vertex v) const { return classes_[v] < subgraphs_.count(); }

    /// Sets near_ and far_: the last robot of the first one's class on the path, and the next robot.
    void findNeighbours(std::span<const Vertex> path)
    {
        const std::uint32_t from = classes_[path.front()];
        near_ = far_ = kNoVertex;
        for (const Vertex v : path)
        {
            if (free_.isFree(v))
                continue;
            if (classes_[v] == from)
            {
                near_ = v;
                far_ = kNoVertex;
            }
            else if (far_ == kNoVertex)
            {
                far_ = v;
            }
        }
    }

    /// The corridor of an edge that is in no subgraph.
    [[nodiscard]] Corridor corridorOf(Vertex a, Vertex b) const
    {
        Corridor corridor{.u = a, .v = b, .length = 1};
        const auto extend = [&](Vertex &end, Vertex previous)
        {
            for (; given_.graph.degree(end) == 2; ++corridor.length)
            {
                const auto around = given_.graph.neighbors(end);
                previous = std::exchange(end, around[around[0] == previous ? 1 : 0]);
            }
        };
        extend(corridor.u, b);
        extend(corridor.v, a);
        if (isLeaf(corridor.u))
            std::swap(corridor.u, corridor.v);
        return corridor;
    }

    [[nodiscard]] Border findBorder() const
    {
        // On a vertex of a subgraph that has no hold of him.
        for (const Vertex stuck : {near_, far_})
            if (subgraphs_.of(stuck) != kNoSubgraph && subgraphs_.of(stuck) != classes_[stuck])
                return {plankWithAllFree(stuck), stuck};
        // In a corridor, or on either side of one.
        const std::vector<Vertex> between = treePath(given_.blocks, near_, far_);
        std::vector<std::size_t> outside; // edges of the path that are in no subgraph, by their first vertex
        for (std::size_t i = 0; i + 1 < between.size(); ++i)
            if (subgraphs_.of(between[i]) == kNoSubgraph ||
                subgraphs_.of(between[i]) != subgraphs_.of(between[i + 1]))
                outside.push_back(i);
        const std::size_t i = belongs(near_) ? outside.back() : outside.front();
        return {corridorOf(between[i], between[i + 1]), kNoVertex, between[i], between[i + 1]};
    }

    /// All free vertices are beyond one plank of this join: its subgraph has none to move the robot on it.
    [[nodiscard]] Corridor plankWithAllFree(Vertex join) const
    {
        const auto planks = subgraphs_.planks(subgraphs_.of(join));
        const auto plank = std::ranges::find_if(
            planks, [&](const Plank &p)
            { return p.join == join && free_.beyond(join, p.exterior) == free_.inComponent(join); });
        assert(plank != planks.end());
        return corridorOf(join, plank->exterior);
    }

    /// How many free vertices let robots pass each other there however they stand.
    [[nodiscard]] std::uint32_t need(const Corridor &corridor) const
    {
        const auto extra = [&](Vertex v)
        {
            if (isLeaf(v))
                return 0U;
            return given_.rotations() && given_.blocks.inTwoEdgeComponent(v) ? 0U : 1U;
        };
        return corridor.length + extra(corridor.u) + extra(corridor.v);
    }

    /// The vertices that `from` reaches without the border: without its join, or without its edge.
    [[nodiscard]] std::vector<std::uint8_t> flood(Vertex from, const Border &border) const
    {
        std::vector<std::uint8_t> reached(given_.graph.vertexCount(), 0);
        std::vector<Vertex> stack = {from};
        reached[from] = 1;
        while (!stack.empty())
        {
            const Vertex v = stack.back();
            stack.pop_back();
            for (const Vertex w : given_.graph.neighbors(v))
            {
                const bool crosses = w == border.join || (v == border.a && w == border.b);
                if (crosses || reached[w] != 0)
                    continue;
                reached[w] = 1;
                stack.push_back(w);
            }
        }
        return reached;
    }

    /// One that has to go from the far side to the near side. Somebody has to: as many robots stand there in
    /// the end.
    [[nodiscard]] Robot robotThatComesBack(const Border &border, std::span<const Robot> robots) const
    {
        // A join belongs to the side that is not flooded.
        const bool joinIsNear = border.join == near_;
        const std::vector<std::uint8_t> flooded = flood(joinIsNear ? far_ : near_, border);
        const auto isFar = [&](Vertex v) { return (flooded[v] != 0) == joinIsNear; };
        const auto robot = std::ranges::find_if(
            robots, [&](Robot r) { return isFar(given_.places[r]) && !isFar(given_.instance.goals[r]); });
        assert(robot != robots.end());
        return *robot;
    }

    const SolvabilityCase &given_;
    const Subgraphs &subgraphs_;
    std::span<const std::uint32_t> classes_;
    FreeCounts free_;
    Vertex near_ = kNoVertex; ///< two vertices whose robots are neighbours of different classes
    Vertex far_ = kNoVertex;
};

} // namespace

Objection objectToClasses(const SolvabilityCase &given, const Subgraphs &subgraphs,
                          std::span<const std::uint32_t> classes, std::span<const Robot> robots)
{
    const auto stays = [&](Robot robot)
    { return classes[given.places[robot]] == classes[given.instance.goals[robot]]; };
    const auto robot = std::ranges::find_if_not(robots, stays);
    if (robot == robots.end())
        return std::nullopt;
    return ClassObjection(given, subgraphs, classes).explain(*robot, robots);
}

} // namespace mrpp::detail
